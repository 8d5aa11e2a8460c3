// Property rows: label left, field right, tooltip, reset by double-click on the label. Each returns
// true when it changed the value.
#pragma once

#include <teapath/core/enum_table.h>
#include <teapath/core/math.h>

#include <imgui.h>

#include <string>

namespace tp::ui {

/// Begins and ends the two columns of property rows.
bool begin_rows(const char* id);
void end_rows();

/// Puts a label in the left column and goes to the right one; true if the label was double-clicked.
bool label(const char* text, const char* help);

bool row(const char* name, double& value, double standard, double speed, double low, double high,
         const char* format, const char* help);
bool row(const char* name, float& value, float standard, float speed, float low, float high,
         const char* format, const char* help);
bool row(const char* name, int& value, int standard, int low, int high, const char* help);
bool row(const char* name, bool& value, const char* help);
bool row(const char* name, std::string& value, const char* help);
bool row(const char* name, Double3& value, const Double3& standard, double speed,
         const char* format, const char* help);
bool row(const char* name, Double2& value, const Double2& standard, double speed,
         const char* format, const char* help);
bool row_color(const char* name, Double3& linear, const char* help);
void row_text(const char* name, const std::string& text);

template <class Enum>
bool row(const char* name, Enum& value, const char* help) {
    label(name, help);
    bool changed = false;
    std::string current = "?";
    for (const auto& r : EnumTable<Enum>::rows)
        if (r.value == value) current = r.label;
    ImGui::SetNextItemWidth(-1);
    if (ImGui::BeginCombo((std::string("##") + name).c_str(), current.c_str())) {
        for (const auto& r : EnumTable<Enum>::rows) {
            if (ImGui::Selectable(std::string(r.label).c_str(), r.value == value) &&
                r.value != value) {
                value = r.value;
                changed = true;
            }
        }
        ImGui::EndCombo();
    }
    return changed;
}

/// A button that is grey with a reason where it cannot be pressed.
bool button(const char* text, bool enabled = true, const char* reason = nullptr);

void tooltip(const char* text);

/// A heading that folds what follows; true while it is open.
bool section(const char* name);

}  // namespace tp::ui
