// What is written over the picture: figures and notices.
#include "viewport_parts.h"

#include <fmt/format.h>

#include <algorithm>

namespace tp {
namespace {

constexpr ImU32 kText = IM_COL32(230, 230, 230, 255);
constexpr ImU32 kError = IM_COL32(255, 140, 120, 255);

// Text on a dark plate; `at` is its top left.
void plate(const ImVec2& at, const std::string& text, ImU32 color) {
    ImDrawList* draw = ImGui::GetWindowDrawList();
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    draw->AddRectFilled({at.x - 6, at.y - 3}, {at.x + size.x + 6, at.y + size.y + 3},
                        IM_COL32(0, 0, 0, 140), 4);
    draw->AddText(at, color, text.c_str());
}

std::string time_text(double seconds) {
    const auto whole = static_cast<int64_t>(seconds);
    if (seconds < 60) return fmt::format("{:.1f} s", seconds);
    if (whole < 3600) return fmt::format("{}:{:02}", whole / 60, whole % 60);
    return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

std::string status_text(const PanelContext& c) {
    std::string text = fmt::format("{} / {} spp  \xc2\xb7  {}", c.status.samples,
                                   c.document.scene().render.samples, time_text(c.status.seconds));
    if (!c.status.backend.empty()) text += fmt::format("  \xc2\xb7  {}", c.status.backend);
    if (c.status.is_preview) text += "  \xc2\xb7  preview";
    return text;
}

void draw_toasts(PanelContext& c, const ImVec2& low, const ImVec2& high) {
    const double now = ImGui::GetTime();
    std::erase_if(c.ui.toasts, [&](const Toast& t) { return t.until < now; });
    const float line = ImGui::GetTextLineHeight() + 13;
    float y = high.y - line - 2;
    for (auto toast = c.ui.toasts.rbegin(); toast != c.ui.toasts.rend(); ++toast, y -= line) {
        const float width = ImGui::CalcTextSize(toast->text.c_str()).x;
        plate({std::max(low.x + 12, high.x - width - 18), y}, toast->text,
              toast->is_error ? kError : kText);
    }
}

}  // namespace

void draw_overlay(PanelContext& c, const ViewportFrame& frame) {
    // Within what is seen of the picture.
    const Double2 end = frame.picture.low + frame.picture.size;
    const ImVec2 low = im(glm::max(frame.picture.low, frame.panel.low));
    const ImVec2 high = im(glm::min(end, frame.panel.low + frame.panel.size));
    plate({low.x + 12, low.y + 10}, status_text(c), kText);
    if (c.ui.paused) {
        ImGui::GetWindowDrawList()->AddRect({low.x + 1, low.y + 1}, {high.x - 1, high.y - 1},
                                            kAmber, 0, 2.0f);
        const float width = ImGui::CalcTextSize("Paused").x;
        plate({high.x - width - 18, low.y + 10}, "Paused", kAmber);
    }
    float y = low.y + 10 + ImGui::GetTextLineHeight() + 13;
    if (c.ui.viewport.speed_shown_until > ImGui::GetTime()) {
        plate({low.x + 12, y},
              fmt::format("speed {:.3g} / s", c.ui.viewport.fly_speed * c.ui.preferences.fly_speed),
              kAmber);
        y += ImGui::GetTextLineHeight() + 13;
    }
    if (c.ui.viewport.view.zoom > 0)
        plate({low.x + 12, y}, fmt::format("zoom {:.4g} %", 100 * frame.zoom), kText);
    draw_toasts(c, low, high);
}

}  // namespace tp
