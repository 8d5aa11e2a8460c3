// Opening and saving scenes and images, and the question about unsaved changes.
#include "dialogs.h"

#include <teapath/core/error.h>
#include <teapath/io/image_file.h>

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>
#include <portable_file_dialogs.h>

#include <utility>

namespace tp {
namespace {

bool save_scene_to(PanelContext& c, const std::filesystem::path& file) {
    try {
        c.document.save(file);
        c.toast(fmt::format("Saved {}", file.filename().string()));
        return true;
    } catch (const Error& error) {
        c.toast(error.what(), true);
        return false;
    }
}

// Writes what the window shows now.
void save_image(PanelContext& c, const std::filesystem::path& file, const std::vector<uint8_t>& rgb,
                int width, int height) {
    try {
        Picture picture;
        picture.width = width;
        picture.height = height;
        picture.display = rgb;
        picture.metadata = {{"software", "Teapath"}, {"samples", std::to_string(c.status.samples)}};
        write_picture(file, picture);
        c.toast(fmt::format("Wrote {}", file.filename().string()));
    } catch (const Error& error) {
        c.toast(error.what(), true);
    }
}

void ask_to_open(PanelContext& c) {
    if (pfd::settings::available()) {
        const auto chosen =
            pfd::open_file("Open a scene", ".", {"Scenes (.json)", "*.json"}).result();
        if (!chosen.empty()) open_scene(c, chosen.front());
        return;
    }
    c.ui.dialogs.show_open = true;
}

// Runs what waits for unsaved changes to be settled.
void finish_pending(PanelContext& c) {
    const std::string what = std::exchange(c.ui.dialogs.pending, "");
    if (what == "quit") c.window.set_should_close(true);
    if (what == "new") c.document.start_new();
    if (what == "open") ask_to_open(c);
}

// Folder and name of a file, where no native dialog is there. True when "ok" is pressed.
bool path_dialog(PanelContext& c, bool& show, const char* title, const char* ok) {
    if (show && !ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
    bool done = false;
    ImGui::SetNextWindowSize(ImVec2(ImGui::GetFontSize() * 32, 0), ImGuiCond_Appearing);
    if (ImGui::BeginPopupModal(title, &show)) {
        if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
        ImGui::SetNextItemWidth(-1);
        done = ImGui::InputText("##path", &c.ui.dialogs.path_input,
                                ImGuiInputTextFlags_EnterReturnsTrue);
        done |= ImGui::Button(ok);
        ImGui::SameLine();
        if (ImGui::Button("Cancel") || ImGui::IsKeyPressed(ImGuiKey_Escape)) show = false;
        if (done) show = false;
        if (!show) ImGui::CloseCurrentPopup();
        ImGui::EndPopup();
    }
    return done && !c.ui.dialogs.path_input.empty();
}

void unsaved_dialog(PanelContext& c) {
    const char* title = "Unsaved changes";
    if (!c.ui.dialogs.pending.empty() && !ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
    if (!ImGui::BeginPopupModal(title, nullptr, ImGuiWindowFlags_AlwaysAutoResize)) return;
    ImGui::Text("%s has changes that are not saved.", c.document.title().c_str());
    if (ImGui::Button("Save")) {
        const std::filesystem::path file =
            c.document.file().empty() ? std::filesystem::path("untitled.json") : c.document.file();
        if (save_scene_to(c, file)) finish_pending(c);
        ImGui::CloseCurrentPopup();
    }
    ImGui::SameLine();
    if (ImGui::Button("Discard")) {
        finish_pending(c);
        ImGui::CloseCurrentPopup();
    }
    ImGui::SameLine();
    if (ImGui::Button("Cancel") || ImGui::IsKeyPressed(ImGuiKey_Escape)) {
        c.ui.dialogs.pending.clear();
        c.window.set_should_close(false);
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
}

}  // namespace

void open_scene(PanelContext& c, const std::filesystem::path& file) {
    try {
        c.document.open(file);
        c.ui.viewport.fly_speed = 0;
        c.toast(fmt::format("Opened {}", file.filename().string()));
    } catch (const Error& error) {
        c.toast(error.what(), true);
    }
}

void save_scene_or_ask(PanelContext& c) {
    if (c.document.file().empty())
        c.ui.dialogs.show_save_as = true;
    else
        save_scene_to(c, c.document.file());
}

void ask_first(PanelContext& c, const std::string& what) {
    c.ui.dialogs.pending = what;
    if (!c.document.is_modified()) finish_pending(c);
}

void draw_dialogs(PanelContext& c) {
    if (path_dialog(c, c.ui.dialogs.show_open, "Open a scene file", "Open"))
        open_scene(c, c.ui.dialogs.path_input);
    if (path_dialog(c, c.ui.dialogs.show_save_as, "Save the scene as", "Save")) {
        std::filesystem::path file = c.ui.dialogs.path_input;
        if (file.extension().empty()) file += ".json";
        save_scene_to(c, file);
    }
    if (path_dialog(c, c.ui.dialogs.show_export, "Save the image as", "Save")) {
        std::filesystem::path file = c.ui.dialogs.path_input;
        if (file.extension().empty()) file += ".png";
        save_image(c, file, c.texture.pixels(), c.texture.width(), c.texture.height());
    }
    if (c.window.should_close() && c.document.is_modified() && c.ui.dialogs.pending.empty()) {
        c.window.set_should_close(false);
        c.ui.dialogs.pending = "quit";
    }
    unsaved_dialog(c);
    draw_keys_window(c);
    draw_settings_window(c);
}

}  // namespace tp
