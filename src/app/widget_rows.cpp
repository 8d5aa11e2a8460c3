// Rows of labels and fields.
#include "theme.h"
#include "widget_number.h"
#include "widgets.h"

#include <teapath/editor/number_text.h>

#include <fmt/format.h>
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

const char* const kAxisNames[] = {"x", "y", "z", "w"};

// "0 to 1", where there are limits that mean something.
std::string range_text(const NumberRow& r) {
    const bool has_low = r.low > -1e9, has_high = r.high < 1e9;
    if (has_low && has_high)
        return fmt::format("{} to {}{}", short_number(r.low, 0), short_number(r.high, 0), r.unit);
    if (has_low) return fmt::format("{}{} or more", short_number(r.low, 0), r.unit);
    return {};
}

std::string number_help(const NumberRow& r, const double* standards, int count) {
    std::string text = r.help;
    std::string facts = range_text(r);
    if (standards) {
        facts += facts.empty() ? "Default " : "; default ";
        for (int i = 0; i < count; ++i)
            facts += (i > 0 ? ", " : "") + short_number(standards[i], 0) +
                     (i + 1 == count ? r.unit : "");
    }
    if (!facts.empty()) text += (text.empty() ? "" : "\n") + facts;
    return text;
}

std::string copied_numbers(const NumberRow& r, const double* values, int count) {
    std::string text;
    for (int i = 0; i < count; ++i)
        text += (i > 0 ? ", " : "") + exact_number(values[i], r.single);
    return text;
}

// Takes as many numbers as there are; one number goes to all components. Returns the changed ones.
unsigned paste_numbers(const NumberRow& r, const std::string& text, double* values, int count) {
    const std::vector<double> numbers = numbers_of(text);
    if (numbers.size() != 1 && numbers.size() != static_cast<size_t>(count)) return 0;
    unsigned changed = 0;
    for (int i = 0; i < count; ++i) {
        double x =
            std::clamp(numbers[numbers.size() == 1 ? 0 : static_cast<size_t>(i)], r.low, r.high);
        if (r.whole) x = std::round(x);
        if (x != values[i]) changed |= 1u << i;
        values[i] = x;
    }
    return changed;
}

// printf's format into a row's places and unit: "%.1f\xc2\xb0", "%.2f EV".
void take_format(NumberRow& r, const char* format) {
    const std::string text = format;
    const size_t point = text.find('.');
    r.decimals = point != std::string::npos && point + 1 < text.size() ? text[point + 1] - '0' : 0;
    const char* const end = ImParseFormatFindEnd(ImParseFormatFindStart(format));
    r.unit = end;
}

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

unsigned row(const NumberRow& r, double* values, const double* standards, int count,
             unsigned mixed) {
    bool differs = mixed != 0 && standards;
    for (int i = 0; standards && i < count; ++i)
        differs |= values[i] != standards[i];
    const std::string help = number_help(r, standards, count);
    begin_row(r.name, help.c_str(), differs);
    const std::string copied = copied_numbers(r, values, count);

    // The fields, as wide as each other.
    unsigned changed = 0;
    const float space = ImGui::GetContentRegionAvail().x,
                gap = std::floor(ImGui::GetFontSize() / 6);
    const float width =
        std::floor((space - gap * static_cast<float>(count - 1)) / static_cast<float>(count));
    const float left = ImGui::GetCursorScreenPos().x;
    for (int i = 0; i < count; ++i) {
        if (i > 0) {
            ImGui::SameLine(0, 0);
            ImGui::SetCursorScreenPos({std::floor(left + static_cast<float>(i) * (width + gap)),
                                       ImGui::GetCursorScreenPos().y});
        }
        ImGui::SetNextItemWidth(i + 1 == count ? left + space - ImGui::GetCursorScreenPos().x
                                               : width);
        const std::string id = count == 1 ? hidden(r.name) : hidden(r.name) + kAxisNames[i];
        const ImVec4 mark = to_color(theme().axis[std::min(i, 2)], 0.75f);
        if (number_field(id.c_str(), r, values[i], (mixed >> i & 1) != 0,
                         r.is_axis && i < 3 ? &mark : nullptr))
            changed |= 1u << i;
        tooltip(help.c_str());
    }

    const RowEnd end = end_row(copied, standards != nullptr);
    if (end.paste) changed |= paste_numbers(r, *end.paste, values, count);
    if (end.reset && standards) {
        for (int i = 0; i < count; ++i) {
            if (values[i] != standards[i] || (mixed >> i & 1) != 0) changed |= 1u << i;
            values[i] = standards[i];
        }
    }
    return changed;
}

bool row(const NumberRow& r, double& value, double standard) {
    return row(r, &value, &standard, 1) != 0;
}

bool row(const NumberRow& r, float& value, float standard) {
    NumberRow as_float = r;
    as_float.single = true;
    double wide = static_cast<double>(value);
    const double wide_standard = static_cast<double>(standard);
    if (row(as_float, &wide, &wide_standard, 1) == 0) return false;
    value = static_cast<float>(wide);
    return true;
}

bool row(const NumberRow& r, int& value, int standard) {
    NumberRow as_int = r;
    as_int.whole = true;
    as_int.decimals = 0;
    as_int.low = std::max(r.low, -2147483648.0);
    as_int.high = std::min(r.high, 2147483647.0);
    double wide = value;
    const double wide_standard = standard;
    if (row(as_int, &wide, &wide_standard, 1) == 0) return false;
    value = static_cast<int>(wide);
    return true;
}

bool row(const NumberRow& r, Double2& value, const Double2& standard) {
    return row(r, &value.x, &standard.x, 2) != 0;
}

bool row(const NumberRow& r, Double3& value, const Double3& standard) {
    return row(r, &value.x, &standard.x, 3) != 0;
}

bool row(const char* name, double& value, double standard, double speed, double low, double high,
         const char* format, const char* help) {
    NumberRow r{.name = name, .help = help, .speed = speed, .low = low, .high = high};
    take_format(r, format);
    return row(r, value, standard);
}

bool row(const char* name, float& value, float standard, float speed, float low, float high,
         const char* format, const char* help) {
    NumberRow r{.name = name,
                .help = help,
                .speed = static_cast<double>(speed),
                .low = static_cast<double>(low),
                .high = static_cast<double>(high)};
    take_format(r, format);
    return row(r, value, standard);
}

bool row(const char* name, int& value, int standard, int low, int high, const char* help) {
    const NumberRow r{.name = name,
                      .help = help,
                      .speed = 0.25,
                      .low = static_cast<double>(low),
                      .high = static_cast<double>(high),
                      .relative = true};
    return row(r, value, standard);
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
