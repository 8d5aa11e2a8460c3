#include "key_table.h"

#include "actions.h"

#include <teapath/app/app.h>

#include <fmt/format.h>

#include <algorithm>

namespace tp {
namespace {

// What the mouse does, which is not to be changed.
const std::vector<KeyRow>& mouse_rows() {
    static const std::vector<KeyRow> rows = {
        {"Mouse", "Right drag", "Look around",
         "The keys of flying act meanwhile, whatever has the focus"},
        {"Mouse", "Wheel", "Field of view", "From 1 to 120 degrees"},
        {"Mouse", "Right button and wheel", "Speed of flying", "It is shown for a second"},
        {"Mouse", "Middle drag", "Pan", "What is under the pointer follows it"},
        {"Mouse", "Alt and left drag", "Orbit",
         "About what is under the pointer; with Shift too where the desktop keeps Alt for itself"},
        {"Mouse", "Click", "Select", "A click on nothing selects nothing"},
        {"Mouse", "Shift and click", "Add to the selection", "Or take away from it"},
        {"Mouse", "Ctrl+Alt and click", "Focus", "Sets the distance that is sharp"},
        {"Mouse", "Shift and wheel", "Zoom the picture",
         "At the pointer; lines between the pixels from 8 times on"},
        {"Mouse", "Shift and middle drag", "Move the picture", "On the screen"}};
    return rows;
}

std::string keys_of(const KeyMap& keys, const Action& a) {
    const KeyMap::Chords chords = keys.chords(a.id);
    std::string text = chord_label(chords[0]);
    if (chords[1] != 0) text += (text.empty() ? "" : ", ") + chord_label(chords[1]);
    return text;
}

// True for "camera.bookmark_1" to "camera.bookmark_9", and the keys that set them, as shipped.
bool is_numbered(const KeyMap& keys, const Action& a) {
    const std::string_view id = a.id;
    return id.size() > 2 && id[id.size() - 2] == '_' && id.back() >= '1' && id.back() <= '9' &&
           !keys.is_changed(id);
}

// "Ctrl+1" and "Go to bookmark 1" as "Ctrl+1 … 9" and "Go to bookmark 1 … 9".
KeyRow joined(KeyRow row) {
    row.keys += " \xe2\x80\xa6 9";
    row.label += " \xe2\x80\xa6 9";
    return row;
}

}  // namespace

std::vector<KeyRow> key_table(const KeyMap& keys) {
    const auto all_as_shipped = [&](std::string_view stem) {
        return std::all_of(actions().begin(), actions().end(), [&](const Action& a) {
            const std::string_view id = a.id;
            return id.substr(0, stem.size()) != stem || is_numbered(keys, a);
        });
    };
    std::vector<KeyRow> rows;
    for (const Action& a : actions()) {
        KeyRow row{group_of(a), keys_of(keys, a), a.label, a.help};
        if (row.keys.empty()) continue;
        const std::string_view id = a.id;
        if (is_numbered(keys, a) && all_as_shipped(id.substr(0, id.size() - 1))) {
            if (id.back() != '1') continue;
            row = joined(row);
        }
        rows.push_back(row);
    }
    // Groups stay together, in the order in which they first appear.
    std::vector<std::string> order;
    for (const KeyRow& r : rows)
        if (std::find(order.begin(), order.end(), r.group) == order.end()) order.push_back(r.group);
    std::stable_sort(rows.begin(), rows.end(), [&](const KeyRow& a, const KeyRow& b) {
        return std::find(order.begin(), order.end(), a.group) <
               std::find(order.begin(), order.end(), b.group);
    });
    rows.insert(rows.end(), mouse_rows().begin(), mouse_rows().end());
    return rows;
}

std::string keys_page() {
    std::string page =
        "# Keys\n\n"
        "Made by `teapath --print-keys > docs/keys.md` from the table of actions; do not edit. "
        "Keys can be\n"
        "changed in Edit > Settings. In the viewport they act while it has the focus, never while "
        "text is\n"
        "typed. F1 shows this table in the window.\n";
    std::string group;
    for (const KeyRow& row : key_table(KeyMap{})) {
        if (row.group != group)
            page += fmt::format("\n## {}\n\n| key | action | |\n| --- | --- | --- |\n",
                                group = row.group);
        page += fmt::format("| {} | {} | {} |\n", row.keys, row.label, row.help);
    }
    return page;
}

}  // namespace tp
