// What all dialogs share, and the messages.
#include "dialogs.h"

#include "../jobs/jobs_view.h"
#include "file_question.h"

#include <imgui.h>

namespace tp {

namespace {

constexpr ImGuiWindowFlags kSmallWindow = ImGuiWindowFlags_AlwaysAutoResize |
                                          ImGuiWindowFlags_NoDocking | ImGuiWindowFlags_NoCollapse |
                                          ImGuiWindowFlags_NoSavedSettings;

void place_in_middle() {
    const ImGuiViewport* screen = ImGui::GetMainViewport();
    ImGui::SetNextWindowPos(screen->GetWorkCenter(), ImGuiCond_Appearing, ImVec2(0.5f, 0.5f));
    ImGui::SetNextWindowSizeConstraints(
        ImVec2(0, 0), ImVec2(screen->WorkSize.x * 0.95f, screen->WorkSize.y * 0.9f));
}

}  // namespace

bool begin_note(const char* title, bool* is_open) {
    place_in_middle();
    return ImGui::Begin(title, is_open, kSmallWindow);
}

bool begin_question(const char* title) {
    if (!ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
    place_in_middle();
    return ImGui::BeginPopupModal(title, nullptr, kSmallWindow);
}

void show_message(UiState& ui, const std::string& title, const std::string& text) {
    log_line(LogLevel::Error, title + ": " + text);
    ui.dialogs.messages.push_back({title, text});
}

void draw_messages(PanelContext& c) {
    if (c.ui.dialogs.messages.empty()) return;
    const Message message = c.ui.dialogs.messages.front();
    bool is_open = true;
    if (begin_note((message.title + "###message").c_str(), &is_open)) {
        ImGui::PushTextWrapPos(ImGui::GetFontSize() * 32);
        ImGui::TextUnformatted(message.text.c_str());
        ImGui::PopTextWrapPos();
        ImGui::Spacing();
        if (ImGui::Button("Close")) is_open = false;
        ImGui::SetItemDefaultFocus();
        ImGui::SameLine();
        if (ImGui::Button("Copy text")) ImGui::SetClipboardText(message.text.c_str());
        if (ImGui::IsWindowFocused() && ImGui::IsKeyPressed(ImGuiKey_Escape)) is_open = false;
    }
    ImGui::End();
    if (!is_open) c.ui.dialogs.messages.pop_front();
}

void draw_dialogs(PanelContext& c) {
    finish_jobs(c);
    c.ui.autosave.update(c.document, c.ui.jobs, c.ui.preferences.autosave_minutes,
                         ImGui::IsMouseDown(ImGuiMouseButton_Left) || c.ui.viewport.is_moving);
    if (c.window.should_close()) {
        c.window.set_should_close(false);
        ask_to_quit(c);
    }
    draw_file_question(c);
    draw_unsaved_question(c);
    draw_recovery_window(c);
    draw_messages(c);
    draw_export_window(c);
    draw_save_layout_window(c);
    draw_keys_window(c);
    draw_settings_window(c);
}

}  // namespace tp
