// Rows of one to four numbers.
#include "theme.h"
#include "widget_number.h"
#include "widgets.h"

#include <teapath/editor/number_text.h>

#include <fmt/format.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

namespace tp::ui {
namespace {

// ImGui wants ids that are not shown.
std::string hidden(const char* name) {
    return std::string("##") + name;
}

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

}  // namespace

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

}  // namespace tp::ui
