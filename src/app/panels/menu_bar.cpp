// Menus, tools, shortcuts and dialogs.
#include "../theme.h"
#include "../widgets.h"
#include "panels.h"

#include <teapath/core/error.h>
#include <teapath/editor/scene_edits.h>
#include <teapath/io/image_file.h>
#include <teapath/scene/enum_tables.h>

#include <fmt/format.h>
#include <icons_font_awesome_6.h>
#include <imgui.h>
#include <imgui_stdlib.h>
#include <portable_file_dialogs.h>

#include <algorithm>

namespace tp {

void PanelContext::toast(const std::string& text, bool is_error) {
    ui.toasts.push_back({text, ImGui::GetTime() + (is_error ? 10 : 4), is_error});
}

void open_scene(PanelContext& c, const std::filesystem::path& file) {
    try {
        c.document.open(file);
        c.ui.fly_speed = 0;
        c.toast(fmt::format("Opened {}", file.filename().string()));
        log_info("opened {}", file.string());
    } catch (const Error& error) {
        log_line(LogLevel::Error, error.what());
        c.toast(error.what(), true);
    }
}

namespace {

bool save_scene_to(PanelContext& c, const std::filesystem::path& file) {
    try {
        c.document.save(file);
        c.toast(fmt::format("Saved {}", file.filename().string()));
        log_info("saved {}", file.string());
        return true;
    } catch (const Error& error) {
        log_line(LogLevel::Error, error.what());
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
        log_line(LogLevel::Error, error.what());
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
    c.ui.show_open = true;
}

// Runs what waits for unsaved changes to be settled.
void finish_pending(PanelContext& c) {
    const std::string what = std::exchange(c.ui.pending, "");
    if (what == "quit") c.window.set_should_close(true);
    if (what == "new") c.document.start_new();
    if (what == "open") ask_to_open(c);
}

void ask_first(PanelContext& c, const std::string& what) {
    c.ui.pending = what;
    if (!c.document.is_modified()) finish_pending(c);
}

void add_shape(PanelContext& c, const ShapeKind& kind) {
    const Camera camera = active_camera(c.document.scene());
    const double size = glm::distance(camera.look_from, camera.look_at) * 0.2;
    ObjectId made;
    c.document.edit(fmt::format("Add {}", kind.label), "",
                    [&](Scene& s) { made = add_object(s, kind, camera.look_at, size); });
    c.document.select(made);
}

void file_menu(PanelContext& c) {
    if (ImGui::MenuItem("New", "Ctrl+N")) ask_first(c, "new");
    if (ImGui::MenuItem("Open\xe2\x80\xa6", "Ctrl+O")) ask_first(c, "open");
    if (ImGui::MenuItem("Save", "Ctrl+S")) save_scene_or_ask(c);
    if (ImGui::MenuItem("Save as\xe2\x80\xa6", "Ctrl+Shift+S")) c.ui.show_save_as = true;
    ImGui::Separator();
    if (ImGui::MenuItem("Save image\xe2\x80\xa6", "Ctrl+E")) c.ui.show_export = true;
    ImGui::Separator();
    if (ImGui::MenuItem("Quit", "Ctrl+Q")) ask_first(c, "quit");
}

void edit_menu(PanelContext& c) {
    const auto& history = c.document.history();
    const size_t at = c.document.history_position();
    if (ImGui::MenuItem(c.document.can_undo()
                            ? fmt::format("Undo {}###undo", history[at].label).c_str()
                            : "Undo###undo",
                        "Ctrl+Z", false, c.document.can_undo()))
        c.document.undo();
    if (ImGui::MenuItem(c.document.can_redo()
                            ? fmt::format("Redo {}###redo", history[at + 1].label).c_str()
                            : "Redo###redo",
                        "Ctrl+Shift+Z", false, c.document.can_redo()))
        c.document.redo();
    ImGui::Separator();
    const bool any = !c.document.selection.empty();
    if (ImGui::MenuItem("Duplicate", "Ctrl+D", false, any))
        c.document.edit("Duplicate", "",
                        [&](Scene& s) { duplicate_objects(s, c.document.selection); });
    if (ImGui::MenuItem("Delete", "Del", false, any))
        c.document.edit("Delete", "",
                        [ids = c.document.selection](Scene& s) { delete_objects(s, ids); });
    if (ImGui::MenuItem("Select all", "Ctrl+A")) {
        c.document.selection.clear();
        for (const Object& o : c.document.scene().objects)
            c.document.selection.push_back(o.id);
    }
    ImGui::Separator();
    if (ImGui::MenuItem("Clear scene"))
        c.document.edit("Clear scene", "", [](Scene& s) {
            s.objects.clear();
            s.generators.clear();
        });
}

void shortcuts(PanelContext& c) {
    const ImGuiIO& io = ImGui::GetIO();
    const auto chord = [](ImGuiKeyChord keys) {
        return ImGui::Shortcut(keys, ImGuiInputFlags_RouteGlobal);
    };
    if (chord(ImGuiMod_Ctrl | ImGuiKey_Z)) {
        if (c.document.can_undo()) c.document.undo();
    }
    if (chord(ImGuiMod_Ctrl | ImGuiMod_Shift | ImGuiKey_Z) || chord(ImGuiMod_Ctrl | ImGuiKey_Y)) {
        if (c.document.can_redo()) c.document.redo();
    }
    if (chord(ImGuiMod_Ctrl | ImGuiKey_N)) ask_first(c, "new");
    if (chord(ImGuiMod_Ctrl | ImGuiKey_O)) ask_first(c, "open");
    if (chord(ImGuiMod_Ctrl | ImGuiKey_S)) save_scene_or_ask(c);
    if (chord(ImGuiMod_Ctrl | ImGuiMod_Shift | ImGuiKey_S)) c.ui.show_save_as = true;
    if (chord(ImGuiMod_Ctrl | ImGuiKey_E)) c.ui.show_export = true;
    if (chord(ImGuiMod_Ctrl | ImGuiKey_Q)) ask_first(c, "quit");
    if (chord(ImGuiMod_Ctrl | ImGuiKey_D) && !c.document.selection.empty())
        c.document.edit("Duplicate", "",
                        [&](Scene& s) { duplicate_objects(s, c.document.selection); });
    if (io.WantTextInput) return;
    if (ImGui::IsKeyPressed(ImGuiKey_P, false) && !io.KeyCtrl) {
        c.ui.paused = !c.ui.paused;
        c.worker.set_paused(c.ui.paused);
    }
    if (ImGui::IsKeyPressed(ImGuiKey_F11, false)) c.window.toggle_full_screen();
    if (ImGui::IsKeyPressed(ImGuiKey_F1, false)) c.ui.show_keys = !c.ui.show_keys;
}

void tool_button(PanelContext& c, const char* icon, Tool tool, const char* help) {
    const bool active = c.ui.tool == tool;
    if (active) ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(0.91f, 0.64f, 0.24f, 1));
    if (ImGui::MenuItem(icon)) c.ui.tool = tool;
    if (active) ImGui::PopStyleColor();
    ui::tooltip(help);
}

// Folder and name of a file, where no native dialog is there. True when "ok" is pressed.
bool path_dialog(PanelContext& c, bool& show, const char* title, const char* ok) {
    if (show && !ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
    bool done = false;
    ImGui::SetNextWindowSize(ImVec2(ImGui::GetFontSize() * 32, 0), ImGuiCond_Appearing);
    if (ImGui::BeginPopupModal(title, &show)) {
        if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
        ImGui::SetNextItemWidth(-1);
        done = ImGui::InputText("##path", &c.ui.path_input, ImGuiInputTextFlags_EnterReturnsTrue);
        done |= ImGui::Button(ok);
        ImGui::SameLine();
        if (ImGui::Button("Cancel") || ImGui::IsKeyPressed(ImGuiKey_Escape)) show = false;
        if (done) show = false;
        if (!show) ImGui::CloseCurrentPopup();
        ImGui::EndPopup();
    }
    return done && !c.ui.path_input.empty();
}

void unsaved_dialog(PanelContext& c) {
    const char* title = "Unsaved changes";
    if (!c.ui.pending.empty() && !ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
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
        c.ui.pending.clear();
        c.window.set_should_close(false);
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
}

void keys_window(PanelContext& c) {
    if (!c.ui.show_keys) return;
    if (ImGui::Begin("Keys", &c.ui.show_keys,
                     ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoDocking)) {
        static constexpr std::pair<const char*, const char*> keys[] = {
            {"W A S D", "fly forward, left, back, right"},
            {"E, Space", "up"},
            {"Q", "down"},
            {"Shift", "faster"},
            {"right drag", "look around"},
            {"wheel", "field of view; with the right button: speed"},
            {"middle drag", "pan"},
            {"Alt + left drag", "orbit"},
            {"click", "select, Shift adds"},
            {"F, Home", "frame the selection, everything"},
            {"C", "camera as in the file"},
            {"P", "pause and resume"},
            {"Del", "delete"},
            {"Ctrl+Z, Ctrl+Y", "undo, redo"},
            {"Ctrl+S, Ctrl+O, Ctrl+N", "save, open, new"},
            {"Ctrl+E", "save the image"},
            {"F11", "full screen"},
            {"F1", "this table"}};
        if (ui::begin_rows("keys")) {
            for (const auto& [key, what] : keys)
                ui::row_text(key, what);
            ui::end_rows();
        }
    }
    ImGui::End();
}

}  // namespace

void save_scene_or_ask(PanelContext& c) {
    if (c.document.file().empty())
        c.ui.show_save_as = true;
    else
        save_scene_to(c, c.document.file());
}

void draw_menu_bar(PanelContext& c) {
    shortcuts(c);
    if (!ImGui::BeginMainMenuBar()) return;
    if (ImGui::BeginMenu("File")) file_menu(c), ImGui::EndMenu();
    if (ImGui::BeginMenu("Edit")) edit_menu(c), ImGui::EndMenu();
    if (ImGui::BeginMenu("Add")) {
        for (const ShapeKind& kind : shape_kinds())
            if (ImGui::MenuItem(kind.label)) add_shape(c, kind);
        ImGui::EndMenu();
    }
    if (ImGui::BeginMenu("View")) {
        if (ImGui::MenuItem("Reset layout")) c.ui.reset_layout = true;
        if (ImGui::MenuItem("Full screen", "F11")) c.window.toggle_full_screen();
        if (ImGui::MenuItem("Light theme", nullptr, !c.ui.dark)) {
            c.ui.dark = !c.ui.dark;
            c.ui.dark ? apply_dark_theme(c.window.scale()) : apply_light_theme(c.window.scale());
        }
        ImGui::EndMenu();
    }
    if (ImGui::BeginMenu("Render")) {
        if (ImGui::MenuItem(c.ui.paused ? "Resume" : "Pause", "P"))
            c.worker.set_paused(c.ui.paused = !c.ui.paused);
        if (ImGui::MenuItem("Start again")) c.worker.restart();
        ImGui::EndMenu();
    }
    if (ImGui::BeginMenu("Help")) {
        if (ImGui::MenuItem("Keys", "F1")) c.ui.show_keys = true;
        ImGui::EndMenu();
    }
    ImGui::TextDisabled("|");
    tool_button(c, ICON_FA_ARROW_POINTER "##select", Tool::Select, "Select");
    tool_button(c, ICON_FA_UP_DOWN_LEFT_RIGHT "##move", Tool::Move, "Move the selection");
    tool_button(c, ICON_FA_ROTATE "##rotate", Tool::Rotate, "Rotate the selection");
    tool_button(c, ICON_FA_MAXIMIZE "##scale", Tool::Scale, "Scale the selection");
    ImGui::TextDisabled("|");
    if (ImGui::MenuItem(c.ui.paused ? ICON_FA_PLAY "##pause" : ICON_FA_PAUSE "##pause"))
        c.worker.set_paused(c.ui.paused = !c.ui.paused);
    ui::tooltip("Pause and resume (P)");
    const std::string title = c.document.title();
    ImGui::SetCursorPosX(ImGui::GetWindowWidth() - ImGui::CalcTextSize(title.c_str()).x - 16);
    ImGui::TextUnformatted(title.c_str());
    ImGui::EndMainMenuBar();
}

void draw_dialogs(PanelContext& c) {
    if (path_dialog(c, c.ui.show_open, "Open a scene file", "Open")) open_scene(c, c.ui.path_input);
    if (path_dialog(c, c.ui.show_save_as, "Save the scene as", "Save")) {
        std::filesystem::path file = c.ui.path_input;
        if (file.extension().empty()) file += ".json";
        save_scene_to(c, file);
    }
    if (path_dialog(c, c.ui.show_export, "Save the image as", "Save")) {
        std::filesystem::path file = c.ui.path_input;
        if (file.extension().empty()) file += ".png";
        save_image(c, file, c.texture.pixels(), c.texture.width(), c.texture.height());
    }
    if (c.window.should_close() && c.document.is_modified() && c.ui.pending.empty()) {
        c.window.set_should_close(false);
        c.ui.pending = "quit";
    }
    unsaved_dialog(c);
    keys_window(c);
}

}  // namespace tp
