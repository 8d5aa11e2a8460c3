// One field that holds a number: drag to change, Ctrl-click, double click or Tab to type, with
// expressions. No row around it.
#pragma once

#include "widgets.h"

namespace tp::ui {

/// The number as the field shows it in that many pixels, with its unit.
std::string shown_number(const NumberRow& r, double value, float width);

/// `label` is the ImGui id. With `mixed` the field shows that there is no one value. Returns true
/// when the value was changed; it stays within the row's range.
bool number_field(const char* label, const NumberRow& r, double& value, bool mixed,
                  const ImVec4* mark = nullptr);

}  // namespace tp::ui
