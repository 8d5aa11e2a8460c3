#include "widgets.h"

#include <teapath/core/color.h>

#include <imgui_stdlib.h>

#include <cmath>

namespace tp::ui {
namespace {

// ImGui wants ids that are not shown.
std::string hidden(const char* name) {
    return std::string("##") + name;
}

}  // namespace

bool begin_rows(const char* id) {
    if (!ImGui::BeginTable(id, 2, ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_PadOuterX))
        return false;
    ImGui::TableSetupColumn("label", ImGuiTableColumnFlags_WidthStretch, 0.4f);
    ImGui::TableSetupColumn("field", ImGuiTableColumnFlags_WidthStretch, 0.6f);
    return true;
}

void end_rows() {
    ImGui::EndTable();
}

void tooltip(const char* text) {
    if (text &&
        ImGui::IsItemHovered(ImGuiHoveredFlags_ForTooltip | ImGuiHoveredFlags_AllowWhenDisabled)) {
        ImGui::BeginTooltip();
        ImGui::PushTextWrapPos(ImGui::GetFontSize() * 24);
        ImGui::TextUnformatted(text);
        ImGui::PopTextWrapPos();
        ImGui::EndTooltip();
    }
}

bool label(const char* text, const char* help) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(text);
    const bool reset = ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0);
    tooltip(help);
    ImGui::TableNextColumn();
    return reset;
}

bool row(const char* name, double& value, double standard, double speed, double low, double high,
         const char* format, const char* help) {
    const bool reset = label(name, help);
    ImGui::SetNextItemWidth(-1);
    bool changed = ImGui::DragScalar(hidden(name).c_str(), ImGuiDataType_Double, &value,
                                     static_cast<float>(speed), &low, &high, format,
                                     ImGuiSliderFlags_AlwaysClamp);
    tooltip(help);
    if (reset && value != standard) {
        value = standard;
        changed = true;
    }
    return changed && std::isfinite(value);
}

bool row(const char* name, float& value, float standard, float speed, float low, float high,
         const char* format, const char* help) {
    double wide = static_cast<double>(value);
    const bool changed = row(name, wide, static_cast<double>(standard), static_cast<double>(speed),
                             static_cast<double>(low), static_cast<double>(high), format, help);
    value = static_cast<float>(wide);
    return changed;
}

bool row(const char* name, int& value, int standard, int low, int high, const char* help) {
    const bool reset = label(name, help);
    ImGui::SetNextItemWidth(-1);
    bool changed = ImGui::DragInt(hidden(name).c_str(), &value, 0.25f, low, high, "%d",
                                  ImGuiSliderFlags_AlwaysClamp);
    tooltip(help);
    if (reset && value != standard) {
        value = standard;
        changed = true;
    }
    return changed;
}

bool row(const char* name, bool& value, const char* help) {
    label(name, help);
    const bool changed = ImGui::Checkbox(hidden(name).c_str(), &value);
    tooltip(help);
    return changed;
}

bool row(const char* name, std::string& value, const char* help) {
    label(name, help);
    ImGui::SetNextItemWidth(-1);
    const bool changed = ImGui::InputText(hidden(name).c_str(), &value);
    tooltip(help);
    return changed;
}

bool row(const char* name, Double3& value, const Double3& standard, double speed,
         const char* format, const char* help) {
    const bool reset = label(name, help);
    ImGui::SetNextItemWidth(-1);
    bool changed = ImGui::DragScalarN(hidden(name).c_str(), ImGuiDataType_Double, &value.x, 3,
                                      static_cast<float>(speed), nullptr, nullptr, format);
    tooltip(help);
    if (reset && value != standard) {
        value = standard;
        changed = true;
    }
    return changed && std::isfinite(value.x + value.y + value.z);
}

bool row(const char* name, Double2& value, const Double2& standard, double speed,
         const char* format, const char* help) {
    const bool reset = label(name, help);
    ImGui::SetNextItemWidth(-1);
    bool changed = ImGui::DragScalarN(hidden(name).c_str(), ImGuiDataType_Double, &value.x, 2,
                                      static_cast<float>(speed), nullptr, nullptr, format);
    tooltip(help);
    if (reset && value != standard) {
        value = standard;
        changed = true;
    }
    return changed && std::isfinite(value.x + value.y);
}

bool row_color(const char* name, Double3& linear, const char* help) {
    label(name, help);
    float srgb[3];
    for (int c = 0; c < 3; ++c) {
        const auto x = static_cast<float>(linear[c]);
        srgb[c] = x <= 1 ? srgb_from_linear(x) : x;  // radiance above 1 stays a number
    }
    ImGui::SetNextItemWidth(-1);
    const bool changed = ImGui::ColorEdit3(
        hidden(name).c_str(), srgb,
        ImGuiColorEditFlags_DisplayHex | ImGuiColorEditFlags_HDR | ImGuiColorEditFlags_Float);
    tooltip(help);
    if (changed)
        for (int c = 0; c < 3; ++c)
            linear[c] = static_cast<double>(
                srgb[c] <= 1 ? linear_from_srgb(srgb[c] < 0 ? 0 : srgb[c]) : srgb[c]);
    return changed;
}

void row_text(const char* name, const std::string& text) {
    label(name, nullptr);
    ImGui::TextUnformatted(text.c_str());
}

bool button(const char* text, bool enabled, const char* reason) {
    ImGui::BeginDisabled(!enabled);
    const bool pressed = ImGui::Button(text);
    ImGui::EndDisabled();
    if (!enabled) tooltip(reason);
    return pressed;
}

bool section(const char* name) {
    ImGui::PushStyleColor(ImGuiCol_Header, ImGui::GetStyleColorVec4(ImGuiCol_FrameBg));
    ImGui::PushStyleColor(ImGuiCol_HeaderActive, ImGui::GetStyleColorVec4(ImGuiCol_FrameBgActive));
    const bool open = ImGui::CollapsingHeader(name, ImGuiTreeNodeFlags_DefaultOpen);
    ImGui::PopStyleColor(2);
    return open;
}

}  // namespace tp::ui
