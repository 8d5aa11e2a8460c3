// What is written over the picture: figures and notices.
#include "../viewport/projection.h"
#include "../widgets.h"
#include "viewport_parts.h"

#include <fmt/format.h>

#include <algorithm>

namespace tp {
namespace {

constexpr ImU32 kText = IM_COL32(230, 230, 230, 255);
constexpr ImU32 kError = IM_COL32(255, 140, 120, 255);

// From one plate to the next below it.
float plate_step() {
    return ImGui::GetTextLineHeight() + ui::px(12);
}

// Text on a dark plate; `at` is its top left.
void plate(const ImVec2& at, const std::string& text, ImU32 color) {
    ImDrawList* draw = ImGui::GetWindowDrawList();
    const ImVec2 size = ImGui::CalcTextSize(text.c_str()), pad(ui::px(6), ui::px(3));
    draw->AddRectFilled({at.x - pad.x, at.y - pad.y},
                        {at.x + size.x + pad.x, at.y + size.y + pad.y}, IM_COL32(0, 0, 0, 140),
                        ui::px(4));
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
    const float line = plate_step(), margin = ui::px(14);
    float y = high.y - ImGui::GetTextLineHeight() - ui::px(11);
    for (auto toast = c.ui.toasts.rbegin(); toast != c.ui.toasts.rend(); ++toast, y -= line) {
        const float width = ImGui::CalcTextSize(toast->text.c_str()).x;
        plate({std::max(low.x + margin, high.x - width - margin), y}, toast->text,
              toast->is_error ? kError : kText);
    }
}

}  // namespace

void draw_overlay(PanelContext& c, const ViewportFrame& frame) {
    // Within what is seen of the picture.
    const Double2 end = frame.picture.low + frame.picture.size;
    const ImVec2 low = im(glm::max(frame.picture.low, frame.panel.low));
    const ImVec2 high = im(glm::min(end, frame.panel.low + frame.panel.size));
    const float left = low.x + ui::px(14);
    float y = low.y + ui::px(11);
    plate({left, y}, status_text(c), kText);
    if (c.ui.paused) {
        const float width = ImGui::CalcTextSize("Paused").x, half_line = ui::px(2) / 2;
        ImGui::GetWindowDrawList()->AddRect({low.x + half_line, low.y + half_line},
                                            {high.x - half_line, high.y - half_line}, kAmber, 0,
                                            2 * half_line);
        plate({high.x - width - ui::px(14), y}, "Paused", kAmber);
    }
    y += plate_step();
    if (c.ui.viewport.speed_shown_until > ImGui::GetTime()) {
        plate({left, y},
              fmt::format("speed {:.3g} / s", c.ui.viewport.fly_speed * c.ui.preferences.fly_speed),
              kAmber);
        y += plate_step();
    }
    if (c.ui.viewport.view.zoom > 0) {
        plate({left, y}, fmt::format("zoom {:.4g} %", 100 * frame.zoom), kText);
        y += plate_step();
    }
    const bool has_handles =
        c.ui.viewport.tool != Tool::Select && c.ui.viewport.tool != Tool::Focus;
    if (has_handles && !c.document.selection.empty() &&
        !keeps_lines_straight(active_camera(c.document.scene())))
        plate({left, y}, "Panoramas show no handles", kText);
    draw_toasts(c, low, high);
}

}  // namespace tp
