// The user's settings: the interface, flying, saving, and every key. They belong to the user and
// not to the scene, act at once and are kept in the settings file.
#include "../widgets.h"
#include "dialogs.h"
#include "key_settings.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>

namespace tp {
namespace {

constexpr std::array<float, 9> kScales = {0, 0.75f, 1, 1.25f, 1.5f, 1.75f, 2, 2.5f, 3};

std::string scale_name(float scale) {
    return scale > 0 ? fmt::format("{:.0f} %", static_cast<double>(scale) * 100)
                     : "From the monitor";
}

void draw_interface(Preferences& p) {
    if (!ui::begin_rows("interface")) return;
    ui::label("Theme", "Colours of the panels");
    const bool was_dark = p.dark_theme;
    if (ImGui::RadioButton("Dark", was_dark)) p.dark_theme = true;
    ImGui::SameLine();
    if (ImGui::RadioButton("Light", !was_dark)) p.dark_theme = false;
    ui::label("Scale", "Size of text and controls");
    ImGui::SetNextItemWidth(-1);
    if (ImGui::BeginCombo("##scale", scale_name(p.interface_scale).c_str())) {
        for (const float scale : kScales)
            if (ImGui::Selectable(scale_name(scale).c_str(), scale == p.interface_scale))
                p.interface_scale = scale;
        ImGui::EndCombo();
    }
    ui::row("Smooth pixels", p.smooth_picture,
            "Interpolates between the pixels of a picture that is shown larger or smaller");
    ui::row({.name = "Autosave",
             .help = "Minutes between the copies that are kept for recovery; 0 is never",
             .speed = 0.1,
             .low = 0,
             .high = 60,
             .unit = " min",
             .whole = true},
            p.autosave_minutes, Preferences{}.autosave_minutes);
    ui::row("Native dialogs", p.native_dialogs,
            "Files are chosen in the desktop's own dialogs, where it has some");
    ui::end_rows();
}

void draw_flying(Preferences& p) {
    const Preferences standard;
    if (!ui::begin_rows("flying")) return;
    ui::row("Speed", p.fly_speed, standard.fly_speed, 0.01, 0.1, 10, "%.2f\xc3\x97",
            "Times the speed that suits the size of the scene");
    ui::row("Turning", p.look_degrees, standard.look_degrees, 0.002, 0.01, 1, "%.3f\xc2\xb0 / px",
            "Degrees that the camera turns for each pixel of the mouse");
    ui::end_rows();
}

}  // namespace

void draw_settings_window(PanelContext& c) {
    DialogState& d = c.ui.dialogs;
    if (!d.show_settings) {
        d.key_to_set.clear();
        return;
    }
    const float font = ImGui::GetFontSize();
    const ImGuiViewport* main = ImGui::GetMainViewport();
    ImGui::SetNextWindowPos(main->GetWorkCenter(), ImGuiCond_Appearing, {0.5f, 0.5f});
    ImGui::SetNextWindowSize(
        {std::min(38 * font, main->WorkSize.x - 16), std::min(30 * font, main->WorkSize.y - 16)},
        ImGuiCond_Appearing);
    // While a key is waited for, none goes round among the buttons.
    const ImGuiWindowFlags flags = ImGuiWindowFlags_NoDocking | ImGuiWindowFlags_NoSavedSettings |
                                   (d.key_to_set.empty() ? 0 : ImGuiWindowFlags_NoNavInputs);
    if (ImGui::Begin("Settings", &d.show_settings, flags)) {
        const bool waited = !d.key_to_set.empty();
        if (ImGui::BeginTabBar("settings", ImGuiTabBarFlags_DrawSelectedOverline)) {
            if (ImGui::BeginTabItem("General")) {
                ImGui::SeparatorText("Interface");
                draw_interface(c.ui.preferences);
                ImGui::SeparatorText("Flying");
                draw_flying(c.ui.preferences);
                ImGui::EndTabItem();
            }
            if (ImGui::BeginTabItem("Keys")) {
                draw_key_settings(c);
                ImGui::EndTabItem();
            } else {
                d.key_to_set.clear();
            }
            ImGui::EndTabBar();
        }
        if (!waited && ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows) &&
            !ImGui::GetIO().WantTextInput && ImGui::IsKeyPressed(ImGuiKey_Escape, false))
            d.show_settings = false;
    }
    ImGui::End();
}

}  // namespace tp
