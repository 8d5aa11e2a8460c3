// The card of the first start: six keys.
#include "../actions.h"
#include "../widgets.h"
#include "viewport_parts.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace tp {
namespace {

// A key or button of the mouse that goes down in this frame.
bool is_anything_pressed() {
    for (int k = ImGuiKey_NamedKey_BEGIN; k < ImGuiKey_NamedKey_END; ++k)
        if (ImGui::IsKeyPressed(static_cast<ImGuiKey>(k), false)) return true;
    return false;
}

std::string key(const PanelContext& c, const char* id) {
    return chord_label(c.ui.keys.chords(id)[0]);
}

using Rows = std::array<std::pair<std::string, const char*>, 6>;

Rows rows(const PanelContext& c) {
    const std::string fly = key(c, "fly.forward") + " " + key(c, "fly.left") + " " +
                            key(c, "fly.back") + " " + key(c, "fly.right");
    return {{{fly, "fly; hold the right button to look around"},
             {"Wheel", "field of view"},
             {"Click", "select, then edit in the inspector"},
             {key(c, "render.pause"), "pause and resume"},
             {key(c, "edit.undo"), "undo, whatever it was"},
             {key(c, "help.keys"), "all keys"}}};
}

}  // namespace

void draw_welcome(PanelContext& c, const ViewportFrame& frame) {
    if (c.ui.preferences.seen_welcome) return;
    if (is_anything_pressed()) {
        c.ui.preferences.seen_welcome = true;
        return;
    }
    // Two columns, keys to the right of theirs, on a card in the middle of the panel.
    const Rows table = rows(c);
    float keys = 0, texts = 0;
    for (const auto& [name, what] : table) {
        keys = std::max(keys, ImGui::CalcTextSize(name.c_str()).x);
        texts = std::max(texts, ImGui::CalcTextSize(what).x);
    }
    const float font = ImGui::GetFontSize(), line = 1.7f * font, gap = font, pad = 1.6f * font;
    const ImVec2 size(keys + gap + texts + 2 * pad,
                      line * static_cast<float>(table.size()) + 2 * pad);
    // Where the panel is small, the card lies over its neighbours, within the window.
    const ImGuiViewport* window = ImGui::GetMainViewport();
    const Double2 from = from_im(window->WorkPos), room = from_im(window->WorkSize) - from_im(size);
    const Double2 wanted = frame.panel.low + (frame.panel.size - from_im(size)) * 0.5;
    const ImVec2 low = im(glm::floor(glm::clamp(wanted, from, from + glm::max(room, Double2(0)))));
    ImDrawList* draw = ImGui::GetForegroundDrawList(ImGui::GetWindowViewport());
    draw->AddRectFilled(low, {low.x + size.x, low.y + size.y}, IM_COL32(24, 24, 26, 240),
                        ui::px(6));
    float y = low.y + pad + (line - font) / 2;
    for (const auto& [name, what] : table) {
        const float width = ImGui::CalcTextSize(name.c_str()).x;
        draw->AddText({low.x + pad + keys - width, y}, kAmber, name.c_str());
        draw->AddText({low.x + pad + keys + gap, y}, IM_COL32(230, 230, 230, 255), what);
        y += line;
    }
}

}  // namespace tp
