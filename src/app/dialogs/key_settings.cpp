#include "key_settings.h"

#include "../actions.h"
#include "../widgets.h"

#include <fmt/format.h>
#include <icons_font_awesome_6.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cctype>

namespace tp {
namespace {

bool is_modifier(int key) {
    return key >= ImGuiKey_LeftCtrl && key <= ImGuiKey_RightSuper;
}

// The chord that is pressed in this frame, 0 for none. A modifier is a key by itself where the
// action acts while a key is held, and part of a chord otherwise.
int pressed_chord(bool is_held) {
    for (int key = ImGuiKey_NamedKey_BEGIN; key < ImGuiKey_GamepadStart; ++key) {
        if (!ImGui::IsKeyPressed(static_cast<ImGuiKey>(key), false)) continue;
        if (is_held) return key;
        if (!is_modifier(key)) return key | ImGui::GetIO().KeyMods;
    }
    return 0;
}

void set_key(PanelContext& c, const Action& a, size_t slot, int chord) {
    KeyMap::Chords chords = c.ui.keys.chords(a.id);
    chords[slot] = chord;
    if (chords[0] == chords[1]) chords[1] = 0;
    if (chords[0] == 0) std::swap(chords[0], chords[1]);
    c.ui.keys.set(a.id, chords);
    c.ui.preferences.keys = c.ui.keys.to_names();
}

// Takes the key that is waited for.
void take_key(PanelContext& c) {
    DialogState& d = c.ui.dialogs;
    if (d.key_to_set.empty()) return;
    const Action& a = action(d.key_to_set);
    const int chord = pressed_chord(a.scope == ActionScope::Held);
    if (chord == 0) return;
    if (chord != ImGuiKey_Escape) set_key(c, a, static_cast<size_t>(d.key_slot), chord);
    d.key_to_set.clear();
    d.key_was_taken = true;
}

// What else the action's keys do, as text; empty for nothing.
std::string conflicts_of(const KeyMap& keys, const Action& a) {
    std::string text;
    for (const int chord : keys.chords(a.id))
        for (const std::string& other : keys.conflicts(a.id, chord))
            text += (text.empty() ? "also: " : ", ") + std::string(action(other).label);
    return text;
}

bool matches(const std::string& search, const std::string& text) {
    const auto same = [](char a, char b) {
        return std::tolower(static_cast<unsigned char>(a)) ==
               std::tolower(static_cast<unsigned char>(b));
    };
    return std::search(text.begin(), text.end(), search.begin(), search.end(), same) != text.end();
}

void draw_key_button(PanelContext& c, const Action& a, size_t slot, float width) {
    DialogState& d = c.ui.dialogs;
    const int chord = c.ui.keys.chords(a.id)[slot];
    const bool waits = d.key_to_set == a.id && d.key_slot == static_cast<int>(slot);
    const std::string text = waits ? "press a key\xe2\x80\xa6" : chord_label(chord);
    if (waits) ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_CheckMark));
    if (ImGui::Button(fmt::format("{}###{}{}", text, a.id, slot).c_str(), {width, 0})) {
        d.key_to_set = a.id;
        d.key_slot = static_cast<int>(slot);
    }
    if (waits) ImGui::PopStyleColor();
    ui::tooltip(
        "Click, then press the new key. Esc leaves it as it is, a right click takes it "
        "away.");
    if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) set_key(c, a, slot, 0);
}

void draw_row(PanelContext& c, const Action& a) {
    const float width = ImGui::GetFontSize() * 8;
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(a.label);
    ui::tooltip(a.help);
    ImGui::TableNextColumn();
    draw_key_button(c, a, 0, width);
    ImGui::TableNextColumn();
    draw_key_button(c, a, 1, width);
    ImGui::TableNextColumn();
    if (c.ui.keys.is_changed(a.id)) {
        if (ImGui::Button(fmt::format(ICON_FA_ROTATE_LEFT "###reset {}", a.id).c_str())) {
            c.ui.keys.reset(a.id);
            c.ui.preferences.keys = c.ui.keys.to_names();
        }
        ui::tooltip("As shipped");
        ImGui::SameLine();
    }
    if (const std::string text = conflicts_of(c.ui.keys, a); !text.empty()) {
        ImGui::TextColored(ImGui::GetStyleColorVec4(ImGuiCol_CheckMark), "%s", text.c_str());
        ui::tooltip(text.c_str());
    }
}

}  // namespace

void draw_key_settings(PanelContext& c) {
    take_key(c);
    std::string& search = c.ui.dialogs.key_search;
    ImGui::SetNextItemWidth(ImGui::GetFontSize() * 14);
    ImGui::InputTextWithHint("##search", "Search", &search);
    ImGui::SameLine();
    if (ui::button("Reset all", !c.ui.preferences.keys.empty(), "All keys are as shipped")) {
        c.ui.keys.reset_all();
        c.ui.preferences.keys = c.ui.keys.to_names();
    }
    if (!ImGui::BeginTable(
            "keys", 4,
            ImGuiTableFlags_ScrollY | ImGuiTableFlags_PadOuterX | ImGuiTableFlags_SizingFixedFit))
        return;
    ImGui::TableSetupColumn("action", ImGuiTableColumnFlags_WidthFixed, ImGui::GetFontSize() * 12);
    ImGui::TableSetupColumn("key");
    ImGui::TableSetupColumn("other");
    ImGui::TableSetupColumn("note", ImGuiTableColumnFlags_WidthStretch);
    std::string group;
    for (const Action& a : actions()) {
        if (a.more || !matches(search, a.label)) continue;
        if (group != group_of(a)) {
            group = group_of(a);
            ImGui::TableNextRow();
            ImGui::TableNextColumn();
            ImGui::TextDisabled("%s", group.c_str());
        }
        draw_row(c, a);
    }
    ImGui::EndTable();
}

}  // namespace tp
