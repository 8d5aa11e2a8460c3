// The tree of everything in the scene. Only the rows in sight are drawn, so that a hundred thousand
// objects cost nothing.
#include "../widgets.h"
#include "add_menu.h"
#include "panels.h"
#include "scene_tree_parts.h"

#include <fmt/format.h>
#include <icons_font_awesome_6.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

namespace tp {
namespace {

struct SectionText {
    TreeSection section;
    const char* name;
    void (*add)(PanelContext&);  // items of the menu behind "+"; null: no such menu
};

constexpr SectionText kSections[] = {{TreeSection::Models, "Models", nullptr},
                                     {TreeSection::Objects, "Objects", add_object_items},
                                     {TreeSection::Lights, "Lights", add_light_items},
                                     {TreeSection::Cameras, "Cameras", nullptr},
                                     {TreeSection::Materials, "Materials", add_material_items},
                                     {TreeSection::Textures, "Textures", add_texture_items},
                                     {TreeSection::Background, "Background", nullptr}};

// A stretch of rows of the whole list: one heading and, where it is open, its things. The
// background is a single row without a heading.
struct Stretch {
    const SectionText* text = nullptr;
    bool has_heading = true;
    bool is_open = true;
    size_t first = 0;  // row of the heading, or of the first thing
    size_t count = 0;  // of things that are shown
    size_t end() const { return first + (has_heading ? 1 : 0) + (is_open ? count : 0); }
};

std::string fold_key(const SectionText& text) {
    return fmt::format("tree {}", text.name);
}

std::vector<Stretch> stretches(PanelContext& c) {
    std::vector<Stretch> all;
    size_t at = 0;
    const bool searches = !c.ui.tree.search.empty();
    const std::vector<std::string>& folded = c.ui.preferences.folded;
    for (const SectionText& text : kSections) {
        Stretch s{&text, text.section != TreeSection::Background, true, at,
                  c.ui.tree.rows.rows(text.section).size()};
        // Most scenes have no models.
        const bool is_needed = !searches && text.section != TreeSection::Models;
        if (s.count == 0 && !is_needed) continue;
        s.is_open =
            searches || std::find(folded.begin(), folded.end(), fold_key(text)) == folded.end();
        at = s.end();
        all.push_back(s);
    }
    return all;
}

void draw_heading(PanelContext& c, const Stretch& s, float height) {
    const SectionText& text = *s.text;
    ImGui::PushID(text.name);
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x, plus = ImGui::GetFrameHeight();
    tree_row_ground(low, width, height, false);
    if (tree_row_button("###section", width - plus, height)) {
        std::vector<std::string>& folded = c.ui.preferences.folded;
        const auto found = std::find(folded.begin(), folded.end(), fold_key(text));
        if (found == folded.end())
            folded.push_back(fold_key(text));
        else
            folded.erase(found);
    }
    ImDrawList* draw = ImGui::GetWindowDrawList();
    const float y = low.y + std::floor((height - ImGui::GetFontSize()) / 2);
    const ImU32 dim = ImGui::GetColorU32(ImGuiCol_TextDisabled);
    draw->AddText({low.x, y}, dim, s.is_open ? ICON_FA_CHEVRON_DOWN : ICON_FA_CHEVRON_RIGHT);
    const float left = low.x + ImGui::GetFontSize() * 1.2f, right = low.x + width - plus;
    const std::string name = ui::fitted(text.name, right - left);
    draw->AddText({left, y}, ImGui::GetColorU32(ImGuiCol_Text), name.c_str());
    const size_t total = c.ui.tree.rows.total(text.section);
    const std::string count =
        s.count == total ? fmt::format("{}", total) : fmt::format("{} of {}", s.count, total);
    const float after = left + ImGui::CalcTextSize(name.c_str()).x + ui::px(8);
    if (after + ImGui::CalcTextSize(count.c_str()).x < right)
        draw->AddText({after, y}, dim, count.c_str());
    if (text.add || text.section == TreeSection::Cameras) {
        ImGui::SetCursorScreenPos({low.x + width - plus, low.y + std::floor((height - plus) / 2)});
        if (ui::icon_button(ICON_FA_PLUS "##add", "Add")) {
            if (text.add)
                ImGui::OpenPopup("add");
            else
                add_camera(c);
        }
        if (text.add && ImGui::BeginPopup("add")) {
            text.add(c);
            ImGui::EndPopup();
        }
    }
    ImGui::SetCursorScreenPos({low.x, low.y + height});
    ImGui::PopID();
}

// The row of what was selected elsewhere, to be scrolled to; `rows` if it needs no scrolling.
size_t row_to_show(PanelContext& c, const std::vector<Stretch>& all, size_t rows) {
    SceneTreeState& tree = c.ui.tree;
    const std::vector<SceneItem> selected = c.document.selected_items();
    const SceneItem active = selected.empty() ? SceneItem{} : selected.back();
    if (active == tree.shown) return rows;
    tree.shown = active;
    for (const Stretch& s : all) {
        const std::vector<SceneItem>& items = tree.rows.rows(s.text->section);
        const auto found = std::find(items.begin(), items.end(), active);
        if (found == items.end() || !s.is_open) continue;
        return s.first + (s.has_heading ? 1 : 0) + static_cast<size_t>(found - items.begin());
    }
    return rows;
}

void draw_rows(PanelContext& c) {
    // Rows may edit the scene while it is walked.
    const ScenePtr scene = c.document.snapshot();
    const std::vector<Stretch> all = stretches(c);
    if (all.empty()) {
        ui::empty_state(ICON_FA_MAGNIFYING_GLASS, "Nothing has such a name.");
        return;
    }
    const size_t rows = all.back().end();
    const float height = std::floor(ImGui::GetFontSize() * 1.5f);
    const size_t wanted = row_to_show(c, all, rows);
    const float view = ImGui::GetWindowHeight(), top = static_cast<float>(wanted) * height;
    if (wanted < rows && (top < ImGui::GetScrollY() || top + height > ImGui::GetScrollY() + view))
        ImGui::SetScrollY(std::max(0.0f, top - view / 3));
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(rows), height);
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            const auto row = static_cast<size_t>(i);
            const auto s = std::find_if(all.begin(), all.end(), [row](const Stretch& stretch) {
                return row < stretch.end();
            });
            if (s->has_heading && row == s->first)
                draw_heading(c, *s, height);
            else
                draw_scene_row(c, *scene, s->text->section,
                               row - s->first - (s->has_heading ? 1 : 0), height);
        }
}

}  // namespace

void draw_scene_tree(PanelContext& c) {
    if (begin_panel(c, "Scene")) {
        SceneTreeState& tree = c.ui.tree;
        ImGui::SetNextItemWidth(-1);
        ImGui::InputTextWithHint("##search", ICON_FA_MAGNIFYING_GLASS "  Search", &tree.search,
                                 ImGuiInputTextFlags_EscapeClearsAll);
        tree.rows.update(c.document.snapshot(), tree.search);
        if (ImGui::BeginChild("tree")) {
            ImGui::PushStyleVarY(ImGuiStyleVar_ItemSpacing, 0);
            draw_rows(c);
            // A click beside the rows selects nothing.
            if (ImGui::IsWindowHovered() && !ImGui::IsAnyItemHovered() && ImGui::IsMouseClicked(0))
                c.document.select_items({});
            ImGui::PopStyleVar();
        }
        ImGui::EndChild();
    }
    ImGui::End();
}

}  // namespace tp
