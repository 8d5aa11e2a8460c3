// Which keys run which action: the shipped ones of the action table, and what a user made of them.
#pragma once

#include <array>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace tp {

class KeyMap {
public:
    using Chords = std::array<int, 2>;  // ImGuiKeyChord; 0 = none

    /// The chords of an action, by its id.
    Chords chords(std::string_view id) const;
    /// True if the user changed them.
    bool is_changed(std::string_view id) const { return changed_.count(std::string(id)) > 0; }
    void set(std::string_view id, Chords chords);
    void reset(std::string_view id) { changed_.erase(std::string(id)); }
    void reset_all() { changed_.clear(); }

    /// Ids of the other actions that a chord runs in the same place as action `id`.
    std::vector<std::string> conflicts(std::string_view id, int chord) const;
    /// True if a key of flying is part of the chord.
    bool flies(int chord) const;

    /// As text, for the settings file: {"file.open": ["Ctrl+O", ""]}, changed ones only.
    std::map<std::string, std::array<std::string, 2>> to_names() const;
    /// Takes what to_names gave; unknown ids and keys are left out and named in the log.
    void from_names(const std::map<std::string, std::array<std::string, 2>>& names);

private:
    std::map<std::string, Chords> changed_;
};

/// "Ctrl+Shift+Z"; "" for none.
std::string chord_name(int chord);
/// The same for people: "Left Ctrl", "Page Up".
std::string chord_label(int chord);
/// The chord of such a name; 0 if it names none.
int chord_from_name(std::string_view name);

}  // namespace tp
