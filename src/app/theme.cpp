#include "theme.h"

#include <icons_font_awesome_6.h>
#include <imgui.h>

#include <filesystem>
#include <string>

namespace tp {
namespace {

ImFont* console_font = nullptr;

ImVec4 grey(int level, float alpha = 1) {
    const float x = static_cast<float>(level) / 255.0f;
    return {x, x, x + (level < 128 ? 2 / 255.0f : 0), alpha};
}

// One accent, amber as tea: selection, the active tool, progress.
ImVec4 amber(float alpha) {
    return {232 / 255.0f, 163 / 255.0f, 61 / 255.0f, alpha};
}

ImFont* load(const std::string& file, float size) {
    if (!std::filesystem::exists(file)) return nullptr;
    return ImGui::GetIO().Fonts->AddFontFromFileTTF(file.c_str(), size);
}

struct Levels {
    int window, panel, field, hover, active, text, dim, line;
};

void apply(const Levels& l, float scale) {
    ImGuiStyle style;
    style.WindowRounding = style.FrameRounding = style.GrabRounding = style.PopupRounding =
        style.TabRounding = 4;
    style.WindowPadding = {8, 8};
    style.FramePadding = {8, 4};
    style.ItemSpacing = {8, 4};
    style.ItemInnerSpacing = {4, 4};
    style.CellPadding = {4, 2};
    style.ScrollbarSize = 12;
    style.WindowBorderSize = 0;
    style.FrameBorderSize = 0;
    style.TabBarBorderSize = 1;
    style.DockingSeparatorSize = 4;
    style.WindowMenuButtonPosition = ImGuiDir_None;
    ImVec4* c = style.Colors;
    c[ImGuiCol_Text] = grey(l.text);
    c[ImGuiCol_TextDisabled] = grey(l.dim);
    c[ImGuiCol_WindowBg] = c[ImGuiCol_ChildBg] = grey(l.panel);
    c[ImGuiCol_ChildBg].w = 0;
    c[ImGuiCol_PopupBg] = grey(l.panel, 0.98f);
    c[ImGuiCol_Border] = c[ImGuiCol_Separator] = grey(l.line);
    c[ImGuiCol_FrameBg] = grey(l.field);
    c[ImGuiCol_FrameBgHovered] = grey(l.hover);
    c[ImGuiCol_FrameBgActive] = grey(l.active);
    c[ImGuiCol_TitleBg] = c[ImGuiCol_TitleBgActive] = c[ImGuiCol_TitleBgCollapsed] =
        c[ImGuiCol_MenuBarBg] = grey(l.window);
    c[ImGuiCol_DockingEmptyBg] = grey(l.window);
    c[ImGuiCol_Tab] = c[ImGuiCol_TabDimmed] = grey(l.window);
    c[ImGuiCol_TabHovered] = grey(l.hover);
    c[ImGuiCol_TabSelected] = c[ImGuiCol_TabDimmedSelected] = grey(l.panel);
    c[ImGuiCol_TabSelectedOverline] = amber(1);
    c[ImGuiCol_TabDimmedSelectedOverline] = grey(l.panel);
    c[ImGuiCol_Button] = grey(l.field);
    c[ImGuiCol_ButtonHovered] = grey(l.hover);
    c[ImGuiCol_ButtonActive] = grey(l.active);
    c[ImGuiCol_Header] = amber(0.28f);
    c[ImGuiCol_HeaderHovered] = grey(l.hover);
    c[ImGuiCol_HeaderActive] = amber(0.4f);
    c[ImGuiCol_CheckMark] = c[ImGuiCol_SliderGrab] = c[ImGuiCol_SliderGrabActive] = amber(1);
    c[ImGuiCol_PlotHistogram] = c[ImGuiCol_PlotLines] = amber(1);
    c[ImGuiCol_TextSelectedBg] = amber(0.35f);
    c[ImGuiCol_NavCursor] = c[ImGuiCol_DragDropTarget] = amber(1);
    c[ImGuiCol_DockingPreview] = amber(0.5f);
    c[ImGuiCol_SeparatorHovered] = c[ImGuiCol_SeparatorActive] = amber(0.8f);
    c[ImGuiCol_ResizeGrip] = grey(l.line);
    c[ImGuiCol_ResizeGripHovered] = c[ImGuiCol_ResizeGripActive] = amber(0.8f);
    c[ImGuiCol_ScrollbarBg] = grey(l.panel, 0);
    c[ImGuiCol_ScrollbarGrab] = grey(l.hover);
    c[ImGuiCol_ScrollbarGrabHovered] = c[ImGuiCol_ScrollbarGrabActive] = grey(l.dim);
    c[ImGuiCol_TableRowBgAlt] = grey(l.text, 0.03f);
    style.ScaleAllSizes(scale);
    ImGui::GetStyle() = style;
}

}  // namespace

void load_fonts(float scale) {
    ImFontAtlas* fonts = ImGui::GetIO().Fonts;
    const std::string folder = TEAPATH_FONTS;
    if (!load(folder + "/Roboto/Roboto-Regular.ttf", 15 * scale)) fonts->AddFontDefault();
    ImFontConfig icons;
    icons.MergeMode = true;
    icons.GlyphMinAdvanceX = 18 * scale;
    const std::string icon_file =
        std::string(TEAPATH_ICON_FONT) + "/Font_Awesome_6_Free-Solid-900.otf";
    if (std::filesystem::exists(icon_file))
        fonts->AddFontFromFileTTF(icon_file.c_str(), 12 * scale, &icons);
    console_font = load(folder + "/Inconsolata-Medium.ttf", 14 * scale);
}

ImFont* monospaced_font() {
    return console_font ? console_font : ImGui::GetIO().Fonts->Fonts.front();
}

void apply_theme(bool dark, float scale) {
    if (dark)
        apply({30, 40, 54, 68, 80, 222, 150, 62}, scale);
    else
        apply({206, 226, 244, 250, 255, 24, 92, 190}, scale);
}

}  // namespace tp
