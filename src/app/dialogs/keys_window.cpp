// The table of keys, from the action table and what the user made of it.
#include "../actions.h"
#include "../widgets.h"
#include "dialogs.h"

#include <imgui.h>

namespace tp {
namespace {

// What the mouse does, which is not to be changed.
constexpr std::pair<const char*, const char*> kMouse[] = {
    {"right drag", "look around"},
    {"wheel", "field of view; with the right button: speed"},
    {"middle drag", "pan"},
    {"Alt + left drag", "orbit"},
    {"click", "select, Shift adds"}};

std::string keys_of(const PanelContext& c, const Action& a) {
    const KeyMap::Chords chords = c.ui.keys.chords(a.id);
    std::string text = chord_name(chords[0]);
    if (chords[1] != 0) text += (text.empty() ? "" : ", ") + chord_name(chords[1]);
    return text;
}

}  // namespace

void draw_keys_window(PanelContext& c) {
    if (!c.ui.dialogs.show_keys) return;
    if (ImGui::Begin("Keys", &c.ui.dialogs.show_keys,
                     ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoDocking)) {
        if (ui::begin_rows("keys")) {
            for (const Action& a : actions())
                if (const std::string keys = keys_of(c, a); !keys.empty())
                    ui::row_text(keys.c_str(), a.label);
            for (const auto& [what, does] : kMouse)
                ui::row_text(what, does);
            ui::end_rows();
        }
    }
    ImGui::End();
}

}  // namespace tp
