// New, open, recent, save, quit: what happens to the document's file, and the question about
// changes that are not saved.
#include "dialogs.h"
#include "file_question.h"

#include <teapath/core/error.h>
#include <teapath/io/scene_file.h>

#include <fmt/format.h>
#include <imgui.h>

#include <utility>

namespace tp {
namespace {

namespace fs = std::filesystem;
using Then = std::function<void(PanelContext&)>;

void take_scene(PanelContext& c, const std::shared_ptr<Scene>& scene, const fs::path& file) {
    // A scene made of a model has no file yet.
    c.document.adopt(std::move(*scene), can_read_model(file) ? fs::path() : file);
    c.ui.viewport.fly_speed = 0;
    c.ui.preferences.remember_file(file);
    c.toast(fmt::format("Opened {}", file.filename().string()));
}

void save_to(PanelContext& c, const fs::path& file, Then then) {
    JobOptions options;
    options.title = fmt::format("Saving {}", file.filename().string());
    options.failed = [](PanelContext& p, const std::string& error) {
        show_message(p.ui, "The scene is not saved", error);
    };
    const ScenePtr scene = c.document.snapshot();
    c.ui.jobs.start(std::move(options),
                    [scene, file, then = std::move(then)](JobControl&) -> JobFinish {
                        save_scene(*scene, file);
                        return [scene, file, then](PanelContext& p) {
                            p.document.mark_saved(scene, file);
                            p.ui.preferences.remember_file(file);
                            p.toast(fmt::format("Saved {}", file.filename().string()));
                            if (then) then(p);
                        };
                    });
}

// A scene without a file is called as it is, beside its model if it was made of one.
fs::path suggested_file(const Document& document) {
    if (!document.file().empty()) return document.file();
    const Scene& scene = document.scene();
    if (scene.name.empty() || scene.models.empty()) return "untitled.json";
    return fs::path(scene.origin.folder) / (scene.name + ".json");
}

void stop_jobs_and_quit(PanelContext& c) {
    for (const JobView& job : c.ui.jobs.running())
        c.ui.jobs.cancel(job.id);
    c.ui.dialogs.quits = true;
}

// What is still being written would be lost.
bool is_exporting(const PanelContext& c) {
    for (const JobView& job : c.ui.jobs.running())
        if (job.can_keep) return true;
    return false;
}

}  // namespace

void ask_first(PanelContext& c, const std::string& verb, Then then) {
    if (!c.document.is_modified()) {
        then(c);
        return;
    }
    c.ui.dialogs.pending = {verb, std::move(then)};
}

void show_unreadable(UiState& ui, const fs::path& file, const std::string& error) {
    show_message(ui, fmt::format("{} cannot be opened", file.filename().string()), error);
}

void open_scene(PanelContext& c, const fs::path& file) {
    JobOptions options;
    options.title = fmt::format("Opening {}", file.filename().string());
    options.failed = [file](PanelContext& p, const std::string& error) {
        show_unreadable(p.ui, file, error);
    };
    c.ui.jobs.start(
        std::move(options), [file, edits = c.document.edits()](JobControl& control) -> JobFinish {
            const auto scene = std::make_shared<Scene>(load_scene(file, reading_in(control)));
            if (control.is_cancelled()) return nullptr;
            return [scene, file, edits](PanelContext& p) {
                // What was edited while the file was read is asked about.
                if (p.document.edits() == edits)
                    take_scene(p, scene, file);
                else
                    ask_first(p, "opening " + file.filename().string(),
                              [scene, file](PanelContext& q) { take_scene(q, scene, file); });
            };
        });
}

void ask_to_open(PanelContext& c) {
    FileQuestion question;
    question.title = "Open a scene or a model";
    question.accept = "Open";
    question.filters = openable_filters();
    question.purpose = "scene";
    question.then = open_scene;
    ask_for_file(c, std::move(question));
}

void ask_to_save_as(PanelContext& c, Then then) {
    FileQuestion question;
    question.title = "Save the scene as";
    question.accept = "Save";
    question.saves = true;
    question.filters = scene_filters();
    question.purpose = "scene";
    question.suggestion = suggested_file(c.document);
    question.extension = ".json";
    question.then = [then = std::move(then)](PanelContext& p, const fs::path& file) {
        save_to(p, file, then);
    };
    ask_for_file(c, std::move(question));
}

void save_scene_or_ask(PanelContext& c, Then then) {
    if (c.document.file().empty())
        ask_to_save_as(c, std::move(then));
    else
        save_to(c, c.document.file(), std::move(then));
}

void ask_to_quit(PanelContext& c) {
    ask_first(c, "closing the window", [](PanelContext& p) {
        if (!is_exporting(p))
            stop_jobs_and_quit(p);
        else
            p.ui.dialogs.asks_to_stop = true;
    });
}

void draw_recent_files(PanelContext& c) {
    // Looked at once each time that the menu opens: a disk far away may be slow.
    static std::vector<bool> is_missing;
    const std::vector<std::string> files = c.ui.preferences.recent_files;
    if (ImGui::IsWindowAppearing() || is_missing.size() != files.size()) {
        is_missing.clear();
        std::error_code ignored;
        for (const std::string& file : files)
            is_missing.push_back(!fs::is_regular_file(file, ignored));
    }
    for (size_t i = 0; i < files.size(); ++i) {
        const fs::path file = files[i];
        const std::string label = fmt::format("{}##{}", file.filename().string(), files[i]);
        if (ImGui::MenuItem(label.c_str(), nullptr, false, !is_missing[i]))
            ask_first(c, "opening " + file.filename().string(),
                      [file](PanelContext& p) { open_scene(p, file); });
        if (ImGui::IsItemHovered(ImGuiHoveredFlags_ForTooltip |
                                 ImGuiHoveredFlags_AllowWhenDisabled))
            ImGui::SetTooltip("%s%s", is_missing[i] ? "There is no such file any more: " : "",
                              files[i].c_str());
    }
    if (files.empty()) ImGui::MenuItem("Nothing opened yet", nullptr, false, false);
    ImGui::Separator();
    if (ImGui::MenuItem("Clear", nullptr, false, !files.empty()))
        c.ui.preferences.recent_files.clear();
}

namespace {

// What the question about unsaved changes was answered with.
enum class Answer { None, Save, Discard, Cancel };

Answer draw_question(const PanelContext& c) {
    Answer answer = Answer::None;
    if (!begin_question("Unsaved changes")) return answer;
    ImGui::Text("%s has changes that are not saved.",
                c.document.file().empty() ? "The scene" : c.document.file().filename().c_str());
    ImGui::TextDisabled("Save them before %s?", c.ui.dialogs.pending.verb.c_str());
    ImGui::Spacing();
    if (ImGui::Button("Save")) answer = Answer::Save;
    ImGui::SetItemDefaultFocus();
    ImGui::SameLine();
    if (ImGui::Button("Discard")) answer = Answer::Discard;
    ImGui::SameLine();
    if (ImGui::Button("Cancel") || ImGui::IsKeyPressed(ImGuiKey_Escape)) answer = Answer::Cancel;
    if (answer != Answer::None) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
    return answer;
}

void ask_to_stop(PanelContext& c) {
    if (!begin_question("Still exporting")) return;
    ImGui::TextUnformatted("An export is not done yet.");
    ImGui::Spacing();
    const bool goes_on = ImGui::Button("Go on exporting") || ImGui::IsKeyPressed(ImGuiKey_Escape);
    ImGui::SetItemDefaultFocus();
    ImGui::SameLine();
    const bool stops = ImGui::Button("Stop it and quit");
    if (stops) stop_jobs_and_quit(c);
    if (stops || goes_on) {
        c.ui.dialogs.asks_to_stop = false;
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
}

}  // namespace

void draw_unsaved_question(PanelContext& c) {
    PendingStep& pending = c.ui.dialogs.pending;
    if (pending.then) {
        const Answer answer = draw_question(c);
        const Then then = answer == Answer::None ? nullptr : std::exchange(pending, {}).then;
        if (answer == Answer::Save) save_scene_or_ask(c, then);
        if (answer == Answer::Discard) then(c);
    }
    if (c.ui.dialogs.asks_to_stop) ask_to_stop(c);
}

}  // namespace tp
