#include "context.h"

#include <imgui.h>

namespace tp {

void PanelContext::toast(const std::string& text, bool is_error) {
    ui.toasts.push_back({text, ImGui::GetTime() + (is_error ? 10 : 4), is_error});
    log_line(is_error ? LogLevel::Error : LogLevel::Info, text);
}

void PanelContext::set_paused(bool paused) {
    ui.paused = paused;
    worker.set_paused(paused);
}

}  // namespace tp
