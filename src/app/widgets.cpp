// Buttons, headings, tooltips and texts that fit; the rows are in widget_rows.cpp.
#include "widgets.h"

#include "theme.h"

#include <icons_font_awesome_6.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace tp::ui {
namespace {

// The part of a label that is shown: what comes before "##".
std::string shown(const char* name) {
    return {name, ImGui::FindRenderedTextEnd(name)};
}

// A heading's line: chevron, bold text, the whole width to click. True when it was clicked.
bool heading_line(const char* name, const char* icon, bool clickable) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float width = std::max(1.0f, ImGui::GetContentRegionAvail().x),
                height = ImGui::GetFrameHeight();
    const ImVec2 low = ImGui::GetCursorScreenPos();
    ImDrawList* draw = ImGui::GetWindowDrawList();
    bool pressed = false;
    if (clickable)
        pressed = ImGui::InvisibleButton(name, {width, height});
    else
        ImGui::Dummy({width, height});
    if (clickable && (ImGui::IsItemHovered() || ImGui::IsItemFocused()))
        draw->AddRectFilled(low, {low.x + width, low.y + height},
                            ImGui::GetColorU32(ImGuiCol_HeaderHovered), style.FrameRounding);
    const float y = low.y + style.FramePadding.y;
    float x = low.x + style.FramePadding.x / 2;
    if (icon) {
        draw->AddText({x, y}, ImGui::GetColorU32(ImGuiCol_TextDisabled), icon);
        x += ImGui::GetFontSize() * 1.2f;
    }
    ImGui::PushFont(bold_font(), 0);
    const std::string text = fitted(shown(name), low.x + width - x);
    draw->AddText({x, y}, ImGui::GetColorU32(ImGuiCol_Text), text.c_str());
    ImGui::PopFont();
    return pressed;
}

// Lets the window's tests know that the item drawn last is a heading that folds.
void mark_as_heading(const char* name, bool open) {
    [[maybe_unused]] ImGuiContext& g = *ImGui::GetCurrentContext();
    [[maybe_unused]] const ImGuiItemStatusFlags flags =
        ImGuiItemStatusFlags_Openable | (open ? ImGuiItemStatusFlags_Opened : 0);
    IMGUI_TEST_ENGINE_ITEM_INFO(g.LastItemData.ID, name, g.LastItemData.StatusFlags | flags);
}

}  // namespace

float px(float pixels) {
    return std::round(pixels * ImGui::GetFontSize() / 15);
}

void tooltip(const char* text) {
    if (!text || !*text) return;
    if (!ImGui::IsItemHovered(ImGuiHoveredFlags_ForTooltip | ImGuiHoveredFlags_AllowWhenDisabled))
        return;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(ImGui::GetFontSize() * 24);
    ImGui::TextUnformatted(text);
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

std::string fitted(const std::string& text, float width) {
    if (ImGui::CalcTextSize(text.c_str()).x <= width) return text;
    const std::string dots = "\xe2\x80\xa6";
    // Bisection over the bytes that are kept; a character is never cut in two.
    size_t low = 0, high = text.size();
    while (low < high) {
        const size_t middle = (low + high + 1) / 2;
        if (ImGui::CalcTextSize((text.substr(0, middle) + dots).c_str()).x <= width)
            low = middle;
        else
            high = middle - 1;
    }
    while (low > 0 && low < text.size() && (static_cast<unsigned char>(text[low]) & 0xc0) == 0x80)
        --low;
    return text.substr(0, low) + dots;
}

void fitted_text(const std::string& text, float width) {
    const std::string cut = fitted(text, width);
    ImGui::TextUnformatted(cut.c_str());
    if (cut != text) tooltip(text.c_str());
}

bool button(const char* text, bool enabled, const char* reason) {
    ImGui::BeginDisabled(!enabled);
    const bool pressed = ImGui::Button(text);
    ImGui::EndDisabled();
    if (!enabled) tooltip(reason);
    return pressed;
}

bool icon_button(const char* icon, const char* help, bool enabled) {
    ImGui::BeginDisabled(!enabled);
    ImGui::PushStyleColor(ImGuiCol_Button, ImVec4(0, 0, 0, 0));
    ImGui::PushStyleVarX(ImGuiStyleVar_FramePadding, 0);
    const float size = ImGui::GetFrameHeight();
    const bool pressed = ImGui::Button(icon, {size, size});
    ImGui::PopStyleVar();
    ImGui::PopStyleColor();
    ImGui::EndDisabled();
    tooltip(help);
    return pressed;
}

bool section(const char* name) {
    ImGuiStorage* storage = ImGui::GetStateStorage();
    const ImGuiID id = ImGui::GetID(name);
    bool open = storage->GetBool(id, true);
    if (heading_line(name, open ? ICON_FA_CHEVRON_DOWN : ICON_FA_CHEVRON_RIGHT, true))
        storage->SetBool(id, open = !open);
    mark_as_heading(name, open);
    return open;
}

bool section(const char* name, std::vector<std::string>& folded) {
    const auto found = std::find(folded.begin(), folded.end(), name);
    bool open = found == folded.end();
    if (heading_line(name, open ? ICON_FA_CHEVRON_DOWN : ICON_FA_CHEVRON_RIGHT, true)) {
        if (open)
            folded.emplace_back(name);
        else
            folded.erase(found);
        open = !open;
    }
    mark_as_heading(name, open);
    return open;
}

void heading(const char* name) {
    ImGui::Separator();
    heading_line(name, nullptr, false);
}

void empty_state(const char* icon, const char* text) {
    const ImVec2 space = ImGui::GetContentRegionAvail();
    const float wrap = std::min(space.x, ImGui::GetFontSize() * 18);
    if (wrap < 1) return;
    const ImVec2 size = ImGui::CalcTextSize(text, nullptr, false, wrap);
    const float line = ImGui::GetFontSize();
    const float top = ImGui::GetCursorPosY() + std::max(0.0f, (space.y - size.y - 3 * line) * 0.4f);
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    ImGui::PushFont(nullptr, ImGui::GetStyle().FontSizeBase * 1.8f);
    const float left = ImGui::GetCursorPosX();
    ImGui::SetCursorPos({left + (space.x - ImGui::CalcTextSize(icon).x) / 2, top});
    ImGui::TextUnformatted(icon);
    ImGui::PopFont();
    ImGui::PushStyleVarY(ImGuiStyleVar_ItemSpacing, 0);
    for (const char *at = text, *end = text + std::strlen(text); at < end;) {
        const char* const rest = ImGui::GetFont()->CalcWordWrapPosition(line, at, end, wrap);
        const char* const stop = std::max(rest, at + 1);  // a word that is too long
        ImGui::SetCursorPosX(left + (space.x - ImGui::CalcTextSize(at, stop).x) / 2);
        ImGui::TextUnformatted(at, stop);
        at = stop;
        while (at < end && *at == ' ')
            ++at;
    }
    ImGui::PopStyleVar();
    ImGui::PopStyleColor();
}

}  // namespace tp::ui
