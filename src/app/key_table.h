// The table of keys as people read it: for the window of keys and for docs/keys.md, out of the
// action table and the key map.
#pragma once

#include "keymap.h"

#include <string>
#include <vector>

namespace tp {

struct KeyRow {
    std::string group;  // the heading it stands under
    std::string keys;   // "Ctrl+Shift+Z, Ctrl+Y"
    std::string label;
    std::string help;  // one sentence
};

/// A row for each action that has a key, in the order of the menus, then the mouse's. The nine
/// bookmarks are one row while they are as shipped.
std::vector<KeyRow> key_table(const KeyMap& keys);

}  // namespace tp
