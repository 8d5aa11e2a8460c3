#include "layouts.h"

#include "layout_file.h"
#include "panels/panels.h"

#include <teapath/core/error.h>

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <string_view>
#include <utility>

namespace tp {
namespace {

std::filesystem::path layout_folder() {
    return configuration_folder() / "layouts";
}

// The panel drawn last would have the focus, and its tab be in front: put right once all are there.
void put_in_front(PanelContext& c) {
    LayoutState& layout = c.ui.layout;
    if (layout.frames_to_front == 0) return;
    --layout.frames_to_front;
    if (layout.frames_to_front == 2) c.ui.viewport.wants_focus = true;
    if (layout.frames_to_front > 0) return;
    for (const std::string& title : layout.in_front)
        if (const ImGuiWindow* window = ImGui::FindWindowByName(title.c_str()))
            if (window->DockNode && window->DockNode->TabBar)
                window->DockNode->TabBar->SelectedTabId =
                    window->DockNode->TabBar->NextSelectedTabId = window->TabId;
}

void hide_tab_bar(ImGuiID node) {
    if (ImGuiDockNode* n = ImGui::DockBuilderGetNode(node))
        n->LocalFlags |= ImGuiDockNodeFlags_HiddenTabBar;
}

// Where there is no room for columns: the picture, and below it a tab for each panel.
void build_small(ImGuiID middle) {
    const ImGuiID bottom =
        ImGui::DockBuilderSplitNode(middle, ImGuiDir_Down, 0.5f, nullptr, &middle);
    ImGui::DockBuilderDockWindow("Viewport", middle);
    for (const Panel& panel : panels())
        if (std::string_view(panel.title) != "Viewport")
            ImGui::DockBuilderDockWindow(panel.title, bottom);
    hide_tab_bar(middle);
}

// Tree and inspector right, as high as the window; options left, console and metrics below, the
// picture between them.
void build_edit(ImGuiID middle, const ImVec2& size) {
    const float font = ImGui::GetFontSize();
    if (size.x < 48 * font || size.y < 24 * font) return build_small(middle);
    const float side = std::clamp(18 * font / size.x, 0.12f, 0.23f);
    const float low = std::clamp(11 * font / size.y, 0.12f, 0.28f);
    ImGuiID right = ImGui::DockBuilderSplitNode(middle, ImGuiDir_Right, side, nullptr, &middle);
    ImGuiID bottom = ImGui::DockBuilderSplitNode(middle, ImGuiDir_Down, low, nullptr, &middle);
    const ImGuiID left =
        ImGui::DockBuilderSplitNode(middle, ImGuiDir_Left, side / (1 - side), nullptr, &middle);
    // Where there is no room for both, the inspector is a tab beside the tree.
    ImGuiID inspector = right;
    if (size.y > 36 * font)
        inspector = ImGui::DockBuilderSplitNode(right, ImGuiDir_Down, 0.64f, nullptr, &right);
    const ImGuiID metrics =
        ImGui::DockBuilderSplitNode(bottom, ImGuiDir_Right, 0.5f, nullptr, &bottom);
    ImGui::DockBuilderDockWindow("Viewport", middle);
    ImGui::DockBuilderDockWindow("Options", left);
    ImGui::DockBuilderDockWindow("Scene", right);
    ImGui::DockBuilderDockWindow("Inspector", inspector);
    ImGui::DockBuilderDockWindow("Console", bottom);
    ImGui::DockBuilderDockWindow("Metrics", metrics);
    ImGui::DockBuilderDockWindow("History", metrics);
    hide_tab_bar(middle);
}

// The picture alone; the other panels have a place for when they are opened.
void build_render(ImGuiID middle) {
    ImGuiID right = ImGui::DockBuilderSplitNode(middle, ImGuiDir_Right, 0.25f, nullptr, &middle);
    ImGui::DockBuilderDockWindow("Viewport", middle);
    for (const Panel& panel : panels())
        if (std::string_view(panel.title) != "Viewport")
            ImGui::DockBuilderDockWindow(panel.title, right);
    hide_tab_bar(middle);
}

// Metrics large, with what explains them.
void build_inspect(ImGuiID middle, const ImVec2& size) {
    const float font = ImGui::GetFontSize();
    const float low = std::clamp(14 * font / size.y, 0.15f, 0.35f);
    ImGuiID right = ImGui::DockBuilderSplitNode(middle, ImGuiDir_Right, 0.42f, nullptr, &middle);
    const ImGuiID inspector =
        ImGui::DockBuilderSplitNode(right, ImGuiDir_Down, 0.42f, nullptr, &right);
    const ImGuiID bottom =
        ImGui::DockBuilderSplitNode(middle, ImGuiDir_Down, low, nullptr, &middle);
    ImGui::DockBuilderDockWindow("Viewport", middle);
    ImGui::DockBuilderDockWindow("Metrics", right);
    for (const char* title : {"Inspector", "Scene", "Options"})
        ImGui::DockBuilderDockWindow(title, inspector);
    for (const char* title : {"Console", "History"})
        ImGui::DockBuilderDockWindow(title, bottom);
    hide_tab_bar(middle);
}

void build(PanelContext& c, ImGuiID dockspace, std::string_view name) {
    const ImVec2 size = ImGui::GetMainViewport()->WorkSize;
    ImGui::DockBuilderRemoveNode(dockspace);
    ImGui::DockBuilderAddNode(dockspace, ImGuiDockNodeFlags_DockSpace);
    ImGui::DockBuilderSetNodeSize(dockspace, size);
    c.ui.preferences.closed_panels.clear();
    if (name == "Render") {
        build_render(dockspace);
        for (const Panel& panel : panels())
            if (std::string_view(panel.title) != "Viewport")
                c.ui.preferences.set_panel_open(panel.title, false);
    } else if (name == "Inspect") {
        build_inspect(dockspace, size);
    } else {
        build_edit(dockspace, size);
    }
    ImGui::DockBuilderFinish(dockspace);
    c.ui.layout.in_front = {"Metrics", "Console", name == "Inspect" ? "Inspector" : "Scene"};
    c.ui.layout.frames_to_front = 6;
}

void refresh(LayoutState& layout) {
    if (std::exchange(layout.is_stale, false)) layout.saved = layout_names(layout_folder());
}

void open_layout(PanelContext& c, const std::string& name) {
    try {
        const Layout layout = load_layout(layout_folder(), name);
        c.ui.preferences.closed_panels = layout.closed_panels;
        c.ui.layout.places = layout.places;
    } catch (const Error& error) {
        c.toast(error.what(), true);
    }
}

void remove_layout(PanelContext& c, const std::string& name) {
    try {
        delete_layout(layout_folder(), name);
    } catch (const Error& error) {
        c.toast(error.what(), true);
    }
    c.ui.layout.is_stale = true;
}

}  // namespace

void apply_saved_layout(UiState& ui) {
    if (ui.layout.places.empty()) return;
    const std::string places = std::exchange(ui.layout.places, {});
    ImGui::LoadIniSettingsFromMemory(places.data(), places.size());
}

void draw_dock_space(PanelContext& c) {
    const ImGuiID dockspace = ImGui::GetID("dockspace");
    std::string wanted = std::exchange(c.ui.layout.built_in, {});
    if (std::exchange(c.ui.reset_layout, false)) wanted = "Edit";
    if (!wanted.empty() || !ImGui::DockBuilderGetNode(dockspace)) build(c, dockspace, wanted);
    const int flags = ImGuiDockNodeFlags_NoCloseButton;  // a panel's tab has one
    ImGui::DockSpaceOverViewport(dockspace, ImGui::GetMainViewport(), flags);
    put_in_front(c);
}

void choose_layout(PanelContext& c, const char* name) {
    c.ui.layout.built_in = name;
}

void draw_saved_layouts(PanelContext& c) {
    refresh(c.ui.layout);
    const std::vector<std::string> names = c.ui.layout.saved;
    if (!names.empty()) ImGui::Separator();
    for (const std::string& name : names)
        if (ImGui::MenuItem((name + "##saved").c_str())) open_layout(c, name);
    ImGui::Separator();
    if (ImGui::MenuItem("Save as\xe2\x80\xa6")) c.ui.dialogs.show_save_layout = true;
    if (ImGui::BeginMenu("Delete", !names.empty())) {
        for (const std::string& name : names)
            if (ImGui::MenuItem(name.c_str())) remove_layout(c, name);
        ImGui::EndMenu();
    }
}

}  // namespace tp
