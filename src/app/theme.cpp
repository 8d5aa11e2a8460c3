#include "theme.h"

#include "embedded.h"

#include <icons_font_awesome_6.h>
#include <imgui.h>

#include <string_view>

namespace tp {
namespace {

ImFont* console_font = nullptr;
ImFont* heading_font = nullptr;
const Palette* palette = &kDarkPalette;

ImFont* add_font(std::string_view file, float size, ImFontConfig config = {}) {
    const std::string_view bytes = embedded_file(file);
    config.FontDataOwnedByAtlas = false;
    return ImGui::GetIO().Fonts->AddFontFromMemoryTTF(
        const_cast<char*>(bytes.data()), static_cast<int>(bytes.size()), size, &config);
}

// Icons for the font that was added last.
void add_icons(float scale) {
    ImFontConfig config;
    config.MergeMode = true;
    config.GlyphMinAdvanceX = 18 * scale;
    add_font("Font_Awesome_6_Free-Solid-900.otf", 12 * scale, config);
}

void set_metrics(ImGuiStyle& style) {
    style.WindowRounding = style.FrameRounding = style.GrabRounding = style.PopupRounding =
        style.TabRounding = style.ChildRounding = 4;
    style.WindowPadding = {8, 8};
    style.FramePadding = {8, 4};
    style.ItemSpacing = {8, 4};
    style.ItemInnerSpacing = {4, 4};
    style.CellPadding = {4, 2};
    style.ScrollbarSize = 12;
    style.WindowBorderSize = 0;
    style.FrameBorderSize = 0;
    style.PopupBorderSize = 1;
    style.TabBarBorderSize = 1;
    style.DockingSeparatorSize = 4;
    style.WindowMenuButtonPosition = ImGuiDir_None;
    style.HoverDelayNormal = 0.5f;
}

void set_colors(ImVec4* c, const Palette& p) {
    c[ImGuiCol_Text] = to_color(p.text);
    c[ImGuiCol_TextDisabled] = to_color(p.dim);
    c[ImGuiCol_WindowBg] = to_color(p.panel);
    c[ImGuiCol_ChildBg] = to_color(p.panel, 0);
    c[ImGuiCol_PopupBg] = to_color(p.panel, 0.98f);
    c[ImGuiCol_Border] = c[ImGuiCol_Separator] = to_color(p.line);
    c[ImGuiCol_FrameBg] = c[ImGuiCol_Button] = to_color(p.field);
    c[ImGuiCol_FrameBgHovered] = c[ImGuiCol_ButtonHovered] = to_color(p.hover);
    c[ImGuiCol_FrameBgActive] = c[ImGuiCol_ButtonActive] = to_color(p.active);
    c[ImGuiCol_TitleBg] = c[ImGuiCol_TitleBgActive] = c[ImGuiCol_TitleBgCollapsed] =
        c[ImGuiCol_MenuBarBg] = c[ImGuiCol_DockingEmptyBg] = to_color(p.window);
    c[ImGuiCol_Tab] = c[ImGuiCol_TabDimmed] = to_color(p.window);
    c[ImGuiCol_TabHovered] = to_color(p.hover);
    c[ImGuiCol_TabSelected] = c[ImGuiCol_TabDimmedSelected] = to_color(p.panel);
    c[ImGuiCol_TabSelectedOverline] = to_color(p.accent);
    c[ImGuiCol_TabDimmedSelectedOverline] = to_color(p.panel);
    c[ImGuiCol_Header] = to_color(p.selected);
    c[ImGuiCol_HeaderHovered] = to_color(p.hover);
    c[ImGuiCol_HeaderActive] = to_color(p.active);
    c[ImGuiCol_CheckMark] = c[ImGuiCol_SliderGrab] = c[ImGuiCol_SliderGrabActive] =
        to_color(p.accent);
    c[ImGuiCol_CheckboxSelectedBg] = to_color(p.field);
    c[ImGuiCol_InputTextCursor] = c[ImGuiCol_UnsavedMarker] = to_color(p.text);
    c[ImGuiCol_TextLink] = to_color(p.accent_text);
    c[ImGuiCol_TreeLines] = c[ImGuiCol_TableBorderStrong] = c[ImGuiCol_TableBorderLight] =
        to_color(p.line);
    c[ImGuiCol_DragDropTargetBg] = to_color(p.accent, 0.15f);
    c[ImGuiCol_NavWindowingHighlight] = to_color(p.accent, 0.7f);
    c[ImGuiCol_PlotHistogramHovered] = c[ImGuiCol_PlotLinesHovered] = to_color(p.accent);
    c[ImGuiCol_PlotHistogram] = c[ImGuiCol_PlotLines] = to_color(p.accent);
    c[ImGuiCol_TextSelectedBg] = to_color(p.accent, 0.35f);
    c[ImGuiCol_NavCursor] = c[ImGuiCol_DragDropTarget] = to_color(p.accent);
    c[ImGuiCol_DockingPreview] = to_color(p.accent, 0.5f);
    c[ImGuiCol_SeparatorHovered] = c[ImGuiCol_SeparatorActive] = to_color(p.accent, 0.8f);
    c[ImGuiCol_ResizeGrip] = to_color(p.line);
    c[ImGuiCol_ResizeGripHovered] = c[ImGuiCol_ResizeGripActive] = to_color(p.accent, 0.8f);
    c[ImGuiCol_ScrollbarBg] = to_color(p.panel, 0);
    c[ImGuiCol_ScrollbarGrab] = to_color(p.active);
    c[ImGuiCol_ScrollbarGrabHovered] = c[ImGuiCol_ScrollbarGrabActive] = to_color(p.dim);
    c[ImGuiCol_TableRowBgAlt] = to_color(p.text, 0.03f);
    c[ImGuiCol_TableHeaderBg] = to_color(p.field);
    c[ImGuiCol_ModalWindowDimBg] = ImVec4(0, 0, 0, 0.45f);
}

}  // namespace

void load_fonts(float scale) {
    add_font("Roboto-Regular.ttf", 15 * scale);
    add_icons(scale);
    heading_font = add_font("Roboto-Bold.ttf", 15 * scale);
    add_icons(scale);
    console_font = add_font("Inconsolata-Medium.ttf", 14 * scale);
}

ImFont* monospaced_font() {
    return console_font;
}

ImFont* bold_font() {
    return heading_font;
}

const Palette& theme() {
    return *palette;
}

ImVec4 to_color(Rgb rgb, float alpha) {
    return {static_cast<float>(rgb.r) / 255, static_cast<float>(rgb.g) / 255,
            static_cast<float>(rgb.b) / 255, alpha};
}

void apply_theme(bool dark, float scale) {
    palette = dark ? &kDarkPalette : &kLightPalette;
    ImGuiStyle style;
    set_metrics(style);
    set_colors(style.Colors, *palette);
    style.ScaleAllSizes(scale);
    ImGui::GetStyle() = style;
}

}  // namespace tp
