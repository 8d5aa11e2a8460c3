// The row of a colour: swatch, hex field, and a picker with linear values.
#include "theme.h"
#include "widget_number.h"
#include "widgets.h"

#include <teapath/core/color.h>
#include <teapath/editor/number_text.h>

#include <imgui_stdlib.h>

#include <algorithm>

namespace tp::ui {
namespace {

// Radiance above 1 as a colour within 1 and what multiplies it.
double scale_of(const Double3& linear) {
    return std::max({1.0, linear.x, linear.y, linear.z});
}

std::vector<float> srgb_of(const Double3& linear) {
    const Double3 within = linear / scale_of(linear);
    std::vector<float> srgb;
    for (int i = 0; i < 3; ++i)
        srgb.push_back(srgb_from_linear(static_cast<float>(within[i])));
    return srgb;
}

Double3 linear_of(const std::vector<float>& srgb, double scale) {
    Double3 linear;
    for (int i = 0; i < 3; ++i)
        linear[i] = scale * static_cast<double>(linear_from_srgb(srgb[static_cast<size_t>(i)]));
    return linear;
}

// What the field of the row shows: hex, or numbers where hex has none for them.
std::string text_of(const Double3& linear) {
    if (scale_of(linear) <= 1) return hex_of(srgb_of(linear));
    return short_number(linear.x, 0, 3) + ", " + short_number(linear.y, 0, 3) + ", " +
           short_number(linear.z, 0, 3);
}

bool picker(Double3& linear) {
    bool changed = false;
    const double scale = scale_of(linear);
    std::vector<float> srgb = srgb_of(linear);
    ImGui::SetNextItemWidth(ImGui::GetFontSize() * 13);
    if (ImGui::ColorPicker3("##picker", srgb.data(),
                            ImGuiColorEditFlags_NoSidePreview | ImGuiColorEditFlags_NoSmallPreview |
                                ImGuiColorEditFlags_DisplayHSV | ImGuiColorEditFlags_DisplayHex |
                                ImGuiColorEditFlags_NoOptions | ImGuiColorEditFlags_NoLabel)) {
        linear = linear_of(srgb, scale);
        changed = true;
    }
    ImGui::TextDisabled("Linear");
    const NumberRow r{.name = "linear",
                      .help = "",
                      .speed = 0.002,
                      .low = 0,
                      .high = 1e6,
                      .decimals = 3,
                      .relative = true};
    const float width = (ImGui::GetFontSize() * 13 - px(8)) / 3;
    for (int i = 0; i < 3; ++i) {
        if (i > 0) ImGui::SameLine(0, px(4));
        ImGui::SetNextItemWidth(width);
        const ImVec4 mark = to_color(theme().axis[i], 0.75f);
        const char* const ids[] = {"##red", "##green", "##blue"};
        changed |= number_field(ids[i], r, linear[i], false, &mark);
    }
    return changed;
}

}  // namespace

std::string color_text(const Double3& linear) {
    return exact_number(linear.x) + ", " + exact_number(linear.y) + ", " + exact_number(linear.z);
}

bool take_color(const std::string& text, Double3& linear) {
    if (const std::vector<float> srgb = srgb_of_hex(text); !srgb.empty()) {
        linear = linear_of(srgb, 1);
        return true;
    }
    const std::vector<double> numbers = numbers_of(text);
    if (numbers.size() != 1 && numbers.size() != 3) return false;
    for (size_t i = 0; i < 3; ++i)
        linear[static_cast<int>(i)] = std::max(0.0, numbers[numbers.size() == 1 ? 0 : i]);
    return true;
}

ImVec4 swatch_color(const Double3& linear) {
    const std::vector<float> srgb = srgb_of(linear);
    return {srgb[0], srgb[1], srgb[2], 1};
}

bool color_field(const char* id, Double3& linear, const char* help, bool mixed, float width) {
    bool changed = false;
    ImGui::PushID(id);
    const float size = ImGui::GetFrameHeight(), gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const ImVec4 swatch =
        mixed ? ImGui::GetStyleColorVec4(ImGuiCol_FrameBgActive) : swatch_color(linear);
    if (ImGui::ColorButton("##swatch", swatch,
                           ImGuiColorEditFlags_NoTooltip | ImGuiColorEditFlags_NoDragDrop,
                           {size * 1.4f, size}))
        ImGui::OpenPopup("##colour");
    tooltip(help);
    ImGui::SameLine(0, gap);
    ImGui::SetNextItemWidth(std::max(1.0f, width - size * 1.4f - gap));
    std::string text = mixed ? "" : text_of(linear);
    if (ImGui::InputTextWithHint(
            "##hex", "mixed", &text,
            ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll))
        changed = take_color(text, linear);
    tooltip("sRGB as #rrggbb, or linear values as 0.2, 0.4, 0.8; Enter takes them");
    if (ImGui::BeginPopup("##colour")) {
        changed |= picker(linear);
        ImGui::EndPopup();
    }
    ImGui::PopID();
    return changed;
}

bool row_color(const char* name, Double3& linear, const char* help, const Double3* standard,
               bool mixed) {
    begin_row(name, help, standard && (mixed || linear != *standard));
    bool changed = color_field(name, linear, help, mixed, ImGui::GetContentRegionAvail().x);
    const RowEnd end = end_row(color_text(linear), standard != nullptr);
    if (end.paste) changed |= take_color(*end.paste, linear);
    if (end.reset && (mixed || linear != *standard)) {
        linear = *standard;
        changed = true;
    }
    return changed;
}

}  // namespace tp::ui
