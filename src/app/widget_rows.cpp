// Rows of labels and fields: what all have in common, and those of switches, texts and choices.
#include "widgets.h"

#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace tp::ui {
namespace {

// ImGui wants ids that are not shown.
std::string hidden(const char* name) {
    return std::string("##") + name;
}

// The row that is being drawn; rows do not nest.
struct {
    std::string name;
    ImVec2 low;
    bool was_reset = false;
} current;

// The whole row, label and field; the table would clip it to the field.
bool is_right_clicked() {
    const ImVec2 high{ImGui::GetCurrentTable()->WorkRect.Max.x,
                      current.low.y + ImGui::GetFrameHeight() + ImGui::GetStyle().CellPadding.y};
    return ImGui::IsMouseClicked(ImGuiMouseButton_Right) && ImGui::IsWindowHovered() &&
           ImGui::GetCurrentWindow()->InnerClipRect.Contains(ImGui::GetMousePos()) &&
           ImGui::IsMouseHoveringRect(current.low, high, false);
}

}  // namespace

bool begin_rows(const char* id) {
    if (!ImGui::BeginTable(id, 2, ImGuiTableFlags_SizingStretchProp)) return false;
    ImGui::TableSetupColumn("label", ImGuiTableColumnFlags_WidthStretch, 0.43f);
    ImGui::TableSetupColumn("field", ImGuiTableColumnFlags_WidthStretch, 0.57f);
    return true;
}

void end_rows() {
    ImGui::EndTable();
}

void begin_row(const char* name, const char* help, bool differs) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float gutter = std::floor(ImGui::GetFontSize() * 0.7f), height = ImGui::GetFrameHeight(),
                width = std::max(1.0f, ImGui::GetContentRegionAvail().x);
    ImGui::InvisibleButton(name, {width, height});
    current = {name, low, ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0)};
    ImDrawList* draw = ImGui::GetWindowDrawList();
    if (differs)
        draw->AddCircleFilled({low.x + gutter * 0.4f, low.y + height / 2}, gutter * 0.22f,
                              ImGui::GetColorU32(ImGuiCol_TextDisabled));
    const std::string text(name, ImGui::FindRenderedTextEnd(name));
    const std::string cut = fitted(text, width - gutter);
    draw->AddText({low.x + gutter, low.y + ImGui::GetStyle().FramePadding.y},
                  ImGui::GetColorU32(ImGuiCol_Text), cut.c_str());
    const std::string all = cut == text ? std::string(help ? help : "")
                                        : text + (help && *help ? std::string("\n") + help : "");
    tooltip(all.c_str());
    ImGui::TableNextColumn();
    ImGui::SetNextItemWidth(-std::numeric_limits<float>::min());
}

RowEnd end_row(const std::string& copied, bool can_reset) {
    RowEnd end;
    end.reset = can_reset && current.was_reset;
    if (copied.empty() && !can_reset) return end;
    const std::string id = current.name + "##menu";
    if (is_right_clicked()) ImGui::OpenPopup(id.c_str());
    if (!ImGui::BeginPopup(id.c_str())) return end;
    if (ImGui::MenuItem("Copy", nullptr, false, !copied.empty()))
        ImGui::SetClipboardText(copied.c_str());
    const char* clipboard = ImGui::GetClipboardText();
    if (ImGui::MenuItem("Paste", nullptr, false, !copied.empty() && clipboard && *clipboard))
        end.paste = clipboard;
    if (ImGui::MenuItem("Reset to default", nullptr, false, can_reset)) end.reset = true;
    ImGui::EndPopup();
    return end;
}

bool label(const char* text, const char* help) {
    begin_row(text, help);
    return current.was_reset;
}

bool row(const char* name, bool& value, const char* help, const bool* standard, bool mixed) {
    begin_row(name, help, standard && (mixed || value != *standard));
    ImGui::PushItemFlag(ImGuiItemFlags_MixedValue, mixed);
    bool changed = ImGui::Checkbox(hidden(name).c_str(), &value);
    ImGui::PopItemFlag();
    tooltip(help);
    const RowEnd end = end_row(value ? "true" : "false", standard != nullptr);
    if (end.reset && (mixed || value != *standard)) {
        value = *standard;
        changed = true;
    }
    if (end.paste && (*end.paste == "true" || *end.paste == "false")) {
        changed |= value != (*end.paste == "true");
        value = *end.paste == "true";
    }
    return changed;
}

bool row(const char* name, std::string& value, const char* help, bool mixed) {
    begin_row(name, help);
    bool changed = false;
    if (mixed) {
        std::string common;
        changed = ImGui::InputTextWithHint(hidden(name).c_str(), "mixed", &common);
        if (changed) value = common;
    } else {
        changed = ImGui::InputText(hidden(name).c_str(), &value);
    }
    tooltip(help);
    return changed;
}

bool row_choice(const char* name, int& index, const std::vector<std::string>& labels,
                const char* help, int standard, bool mixed) {
    begin_row(name, help, standard >= 0 && (mixed || index != standard));
    const std::string label_text = mixed       ? "mixed"
                                   : index < 0 ? ""
                                               : labels[static_cast<size_t>(index)];
    const float space = ImGui::GetContentRegionAvail().x - ImGui::GetFrameHeight() -
                        ImGui::GetStyle().FramePadding.x;
    bool changed = false;
    if (ImGui::BeginCombo(hidden(name).c_str(), fitted(label_text, space).c_str())) {
        for (int i = 0; i < static_cast<int>(labels.size()); ++i) {
            const bool is_current = i == index && !mixed;
            if (ImGui::Selectable(labels[static_cast<size_t>(i)].c_str(), is_current) &&
                !is_current) {
                index = i;
                changed = true;
            }
            if (is_current) ImGui::SetItemDefaultFocus();
        }
        ImGui::EndCombo();
    }
    tooltip(help);
    const RowEnd end = end_row(label_text, standard >= 0);
    const auto pasted =
        end.paste ? std::find(labels.begin(), labels.end(), *end.paste) : labels.end();
    const int wanted = end.reset                ? standard
                       : pasted != labels.end() ? static_cast<int>(pasted - labels.begin())
                                                : index;
    if (wanted != index || (end.reset && mixed)) changed = true;
    index = wanted;
    return changed;
}

void row_text(const char* name, const std::string& text, const char* help) {
    begin_row(name, help);
    ImGui::AlignTextToFramePadding();
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    end_row(text, false);
}

}  // namespace tp::ui
