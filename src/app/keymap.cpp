#include "keymap.h"

#include "actions.h"

#include <teapath/core/log.h>

#include <imgui.h>

#include <algorithm>
#include <utility>

namespace tp {
namespace {

constexpr std::pair<const char*, int> kModifiers[] = {{"Ctrl+", ImGuiMod_Ctrl},
                                                      {"Shift+", ImGuiMod_Shift},
                                                      {"Alt+", ImGuiMod_Alt},
                                                      {"Super+", ImGuiMod_Super}};

constexpr std::pair<const char*, const char*> kShortNames[] = {
    {" Arrow", ""}, {"Comma", ","}, {"Equal", "="}, {"Minus", "-"}, {"Escape", "Esc"}};

int key_of(int chord) {
    return chord & ~ImGuiMod_Mask_;
}

}  // namespace

KeyMap::Chords KeyMap::chords(std::string_view id) const {
    const auto found = changed_.find(std::string(id));
    if (found != changed_.end()) return found->second;
    const Action& shipped = action(id);
    return {shipped.keys[0], shipped.keys[1]};
}

void KeyMap::set(std::string_view id, Chords chords) {
    const Action& shipped = action(id);
    if (chords == Chords{shipped.keys[0], shipped.keys[1]})
        reset(id);
    else
        changed_[std::string(id)] = chords;
}

std::vector<std::string> KeyMap::conflicts(std::string_view id, int chord) const {
    std::vector<std::string> found;
    if (chord == 0) return found;
    for (const Action& other : actions()) {
        if (other.id == id) continue;
        const Chords theirs = chords(other.id);
        if (std::find(theirs.begin(), theirs.end(), chord) != theirs.end())
            found.emplace_back(other.id);
    }
    return found;
}

bool KeyMap::flies(int chord) const {
    for (const Action& a : actions()) {
        if (a.scope != ActionScope::Held) continue;
        for (const int held : chords(a.id))
            if (held != 0 && key_of(held) == key_of(chord)) return true;
    }
    return false;
}

std::map<std::string, std::array<std::string, 2>> KeyMap::to_names() const {
    std::map<std::string, std::array<std::string, 2>> names;
    for (const auto& [id, chords] : changed_)
        names[id] = {chord_name(chords[0]), chord_name(chords[1])};
    return names;
}

void KeyMap::from_names(const std::map<std::string, std::array<std::string, 2>>& names) {
    changed_.clear();
    for (const auto& [id, keys] : names) {
        const bool known = std::any_of(actions().begin(), actions().end(),
                                       [&id = id](const Action& a) { return a.id == id; });
        if (known)
            set(id, {chord_from_name(keys[0]), chord_from_name(keys[1])});
        else
            log_warning("key settings: there is no action {}", id);
    }
}

std::string chord_name(int chord) {
    if (chord == 0) return "";
    std::string name;
    for (const auto& [text, bit] : kModifiers)
        if (chord & bit) name += text;
    return key_of(chord) ? name + ImGui::GetKeyName(static_cast<ImGuiKey>(key_of(chord))) : name;
}

std::string chord_label(int chord) {
    // ImGui writes the names of keys as one word: a space goes before each capital and number.
    std::string label;
    for (const char letter : chord_name(chord)) {
        const bool is_capital = letter >= 'A' && letter <= 'Z';
        if (is_capital && !label.empty() && label.back() >= 'a' && label.back() <= 'z')
            label += ' ';
        label += letter;
    }
    for (const auto& [from, to] : kShortNames)
        if (const size_t at = label.find(from); at != label.npos)
            label.replace(at, std::string_view(from).size(), to);
    return label;
}

int chord_from_name(std::string_view name) {
    int chord = 0;
    for (const auto& [text, bit] : kModifiers) {
        if (name.substr(0, std::string_view(text).size()) != text) continue;
        chord |= bit;
        name.remove_prefix(std::string_view(text).size());
    }
    for (int key = ImGuiKey_NamedKey_BEGIN; key < ImGuiKey_NamedKey_END; ++key)
        if (name == ImGui::GetKeyName(static_cast<ImGuiKey>(key))) return chord | key;
    return 0;
}

}  // namespace tp
