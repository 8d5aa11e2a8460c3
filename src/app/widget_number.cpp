// The field is ImGui's drag behaviour with a text field of our own, for ImGui's reads no
// expressions and shows what it edits with the same few digits.
#include "widget_number.h"

#include "theme.h"

#include <teapath/editor/expression.h>
#include <teapath/editor/number_text.h>

#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace tp::ui {
namespace {

// What is being typed; one field at a time is.
std::array<char, 128> typed{};

void start_text(const NumberRow& r, double value, bool mixed) {
    typed.fill(0);
    if (mixed) return;
    const std::string text = exact_number(value, r.single);
    text.copy(typed.data(), typed.size() - 1);
}

// The value of what was typed; a unit at its end is no part of it.
std::optional<double> typed_value(const NumberRow& r, double before) {
    std::string text = typed.data();
    const std::string unit = r.unit;
    if (!unit.empty() && text.size() > unit.size() && text.ends_with(unit))
        text.resize(text.size() - unit.size());
    return evaluate(text, before);
}

double in_range(const NumberRow& r, double value) {
    value = std::clamp(value, r.low, r.high);
    return r.whole ? std::round(value) : value;
}

// True in the frame in which typing begins.
bool begins_typing(ImGuiID id, bool hovered) {
    const ImGuiContext& g = *GImGui;
    const bool clicked = hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Left);
    const bool by_keys =
        g.NavActivateId == id && (g.NavActivateFlags & ImGuiActivateFlags_PreferInput) != 0;
    return by_keys || (clicked && (g.IO.KeyCtrl || g.IO.MouseClickedCount[0] == 2));
}

// Dragging keeps to round steps: a tenth of the speed's power of ten.
std::string drag_format(const NumberRow& r, double speed) {
    const int places =
        r.whole ? 0 : std::clamp(1 - static_cast<int>(std::floor(std::log10(speed))), 0, 9);
    return "%." + std::to_string(places) + "f";
}

bool drag(ImGuiID id, const NumberRow& r, double& value) {
    double speed = r.speed;
    if (r.relative) speed = std::max(speed, std::abs(value) * 0.005);
    const std::string format = drag_format(r, speed);
    return ImGui::DragBehavior(id, ImGuiDataType_Double, &value, static_cast<float>(speed), &r.low,
                               &r.high, format.c_str(), ImGuiSliderFlags_AlwaysClamp);
}

void draw(const ImRect& box, ImGuiID id, const NumberRow& r, double value, bool mixed, bool hovered,
          const ImVec4* mark) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const ImU32 ground = ImGui::GetColorU32(ImGui::GetActiveID() == id ? ImGuiCol_FrameBgActive
                                            : hovered                  ? ImGuiCol_FrameBgHovered
                                                                       : ImGuiCol_FrameBg);
    ImGui::RenderNavCursor(box, id);
    ImGui::RenderFrame(box.Min, box.Max, ground, false, style.FrameRounding);
    if (mark) {
        const float height = std::max(2.0f, std::floor(ImGui::GetFontSize() / 8));
        ImGui::GetWindowDrawList()->AddRectFilled({box.Min.x, box.Max.y - height}, box.Max,
                                                  ImGui::GetColorU32(*mark), style.FrameRounding,
                                                  ImDrawFlags_RoundCornersBottom);
    }
    const float padding = std::min(style.FramePadding.x, box.GetWidth() / 10);
    const float space = box.GetWidth() - 2 * padding;
    const char* const mark_of_mixed =
        ImGui::CalcTextSize("mixed").x <= space ? "mixed" : "\xe2\x80\x93";
    const std::string text = mixed ? mark_of_mixed : shown_number(r, value, space);
    if (mixed) ImGui::PushStyleColor(ImGuiCol_Text, style.Colors[ImGuiCol_TextDisabled]);
    ImGui::RenderTextClipped({box.Min.x + padding, box.Min.y}, {box.Max.x - padding, box.Max.y},
                             text.c_str(), nullptr, nullptr, {1, 0.5f});
    if (mixed) ImGui::PopStyleColor();
}

}  // namespace

std::string shown_number(const NumberRow& r, double value, float width) {
    // Units go first, then digits, where the field is narrow. One digit alone would be another
    // number.
    for (int digits = 4; digits >= 2; --digits) {
        const std::string number = short_number(value, r.decimals, digits);
        for (const char* unit : {r.unit, ""}) {
            const std::string text = number + unit;
            if (ImGui::CalcTextSize(text.c_str()).x <= width) return text;
        }
    }
    return "\xe2\x80\xa6";
}

bool number_field(const char* label, const NumberRow& r, double& value, bool mixed,
                  const ImVec4* mark) {
    ImGuiWindow* window = ImGui::GetCurrentWindow();
    if (window->SkipItems) return false;
    ImGuiContext& g = *GImGui;
    const ImGuiID id = window->GetID(label);
    const ImVec2 low = window->DC.CursorPos;
    const ImRect box(
        low, {low.x + std::max(1.0f, ImGui::CalcItemWidth()), low.y + ImGui::GetFrameHeight()});
    ImGui::ItemSize(box, g.Style.FramePadding.y);
    if (!ImGui::ItemAdd(box, id, &box, ImGuiItemFlags_Inputable)) return false;
    const bool hovered = ImGui::ItemHoverable(box, id, g.LastItemData.ItemFlags);
    const bool begins = !ImGui::TempInputIsActive(id) && begins_typing(id, hovered);
    IMGUI_TEST_ENGINE_ITEM_INFO(id, label,
                                g.LastItemData.StatusFlags | ImGuiItemStatusFlags_Inputable);

    const double before = value;
    if (begins || ImGui::TempInputIsActive(id)) {
        // Typing: the value changes once, at the end.
        if (begins) start_text(r, value, mixed);
        ImGui::TempInputText(box, id, label, typed.data(), typed.size());
        if (!ImGui::IsItemDeactivatedAfterEdit()) return false;
        const std::optional<double> result = typed_value(r, before);
        if (result) value = in_range(r, *result);
        return result && (mixed || value != before);
    }
    if ((hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) || g.NavActivateId == id) {
        ImGui::SetActiveID(id, window);
        ImGui::SetFocusID(id, window);
        ImGui::FocusWindow(window);
        g.ActiveIdUsingNavDirMask = (1 << ImGuiDir_Left) | (1 << ImGuiDir_Right);
    }
    if (drag(id, r, value)) value = in_range(r, value);
    draw(box, id, r, value, mixed && value == before, hovered, mark);
    if (value == before) return false;
    ImGui::MarkItemEdited(id);
    return true;
}

}  // namespace tp::ui
