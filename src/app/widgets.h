// Property rows: label left, field right. Every row can be dragged or typed into (expressions too),
// reset by a double click on its label, copied and pasted by its menu, shows a dot where it differs
// from its default and says in a tooltip what it means. Each row is one call that returns whether
// it changed the value. What belongs to many things at once is in panels/property_rows.h.
#pragma once

#include <teapath/core/enum_table.h>
#include <teapath/core/math.h>

#include <imgui.h>

#include <optional>
#include <string>
#include <vector>

namespace tp::ui {

/// Begins and ends the two columns of property rows.
bool begin_rows(const char* id);
void end_rows();

/// What a number is and how it is edited.
struct NumberRow {
    const char* name = "";
    const char* help = "";
    double speed = 0.01;  // of a pixel of dragging; with `relative` a share of the value at least
    double low = -1e15, high = 1e15;
    int decimals = 2;  // places that are always shown
    const char* unit = "";
    bool whole = false;     // integers only
    bool single = false;    // float: its digits are shown so
    bool relative = false;  // dragging is faster where the value is larger
    bool is_axis = false;   // components are x, y, z
};

/// A row of one to four numbers. Bits of `mixed` name components whose value differs between the
/// things that are edited. Returns a bit for each component that was changed.
unsigned row(const NumberRow& r, double* values, const double* standards, int count,
             unsigned mixed = 0);

bool row(const NumberRow& r, double& value, double standard);
bool row(const NumberRow& r, float& value, float standard);
bool row(const NumberRow& r, int& value, int standard);
bool row(const NumberRow& r, Double2& value, const Double2& standard);
bool row(const NumberRow& r, Double3& value, const Double3& standard);

// The same by arguments; `format` is printf's, what follows its number is the unit.
bool row(const char* name, double& value, double standard, double speed, double low, double high,
         const char* format, const char* help);
bool row(const char* name, float& value, float standard, float speed, float low, float high,
         const char* format, const char* help);
bool row(const char* name, int& value, int standard, int low, int high, const char* help);

/// `standard` may be null: no default is known.
bool row(const char* name, bool& value, const char* help, const bool* standard = nullptr,
         bool mixed = false);
bool row(const char* name, std::string& value, const char* help, bool mixed = false);

/// A linear colour as swatch, picker and text; radiance above 1 is kept.
bool row_color(const char* name, Double3& linear, const char* help,
               const Double3* standard = nullptr, bool mixed = false);

/// The field of such a row alone, that many pixels wide.
bool color_field(const char* id, Double3& linear, const char* help, bool mixed, float width);
/// A linear colour as text, and back from that or from "#rrggbb"; false if it is neither.
std::string color_text(const Double3& linear);
bool take_color(const std::string& text, Double3& linear);
/// What the screen shows for it; brighter ones are scaled down to their hue.
ImVec4 swatch_color(const Double3& linear);

/// One of several labels; -1 for none. Returns true when `index` was changed.
bool row_choice(const char* name, int& index, const std::vector<std::string>& labels,
                const char* help, int standard = -1, bool mixed = false);

/// Text that cannot be edited; it is wrapped.
void row_text(const char* name, const std::string& text, const char* help = nullptr);

template <class Enum>
bool row(const char* name, Enum& value, const char* help, const Enum* standard = nullptr,
         bool mixed = false) {
    std::vector<std::string> labels;
    int index = -1, standard_index = -1;
    for (const auto& r : EnumTable<Enum>::rows) {
        if (r.value == value) index = static_cast<int>(labels.size());
        if (standard && r.value == *standard) standard_index = static_cast<int>(labels.size());
        labels.emplace_back(r.label);
    }
    if (!row_choice(name, index, labels, help, standard_index, mixed)) return false;
    value = EnumTable<Enum>::rows[static_cast<size_t>(index)].value;
    return true;
}

/// A row around any field: begin it, draw the field, end it.
struct RowEnd {
    bool reset = false;                // the default is asked for
    std::optional<std::string> paste;  // text from the clipboard is to be taken
};
void begin_row(const char* name, const char* help, bool differs = false);
/// `copied` is what "Copy" gives; empty: the row has nothing to copy or paste.
RowEnd end_row(const std::string& copied, bool can_reset);

/// Puts a label in the left column and goes to the right one; true if the label was double-clicked.
bool label(const char* text, const char* help);

/// Pixels of a design at scale 1, at the scale of the interface.
float px(float pixels);

/// A button that is grey with a reason where it cannot be pressed.
bool button(const char* text, bool enabled = true, const char* reason = nullptr);
/// A button without a frame, as wide as a frame is high.
bool icon_button(const char* icon, const char* help, bool enabled = true);

void tooltip(const char* text);

/// The text, cut with "…" where it is wider than `width` pixels.
std::string fitted(const std::string& text, float width);
/// The text, cut so; a tooltip has all of it where something was cut.
void fitted_text(const std::string& text, float width);

/// A heading that folds what follows; true while it is open.
bool section(const char* name);
/// The same with the state kept by the caller: `folded` lists the names of folded headings.
bool section(const char* name, std::vector<std::string>& folded);
/// A heading that does not fold.
void heading(const char* name);

/// Text in the middle of the rest of a panel that has nothing to show.
void empty_state(const char* icon, const char* text);

}  // namespace tp::ui
