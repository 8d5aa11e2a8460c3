// One row of the scene tree.
#include "../preview/previews.h"
#include "../theme.h"
#include "../widgets.h"
#include "scene_tree_parts.h"
#include "texture_slots.h"

#include <teapath/editor/scene_edits.h>

#include <icons_font_awesome_6.h>
#include <imgui.h>
#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>

namespace tp {
namespace {

// What a row is about, in the snapshot that is drawn.
struct Row {
    SceneItem item;
    const Object* object = nullptr;
    const Camera* camera = nullptr;
    const Material* material = nullptr;
    const Texture* texture = nullptr;
    std::string name{};
};

Row row_of(const Scene& scene, SceneItem item, size_t position) {
    Row row{.item = item};
    switch (item.kind) {
        case ItemKind::Object:
            row.object = &scene.objects[position];
            row.name = display_name(*row.object);
            return row;
        case ItemKind::Camera: row.camera = &scene.cameras[position]; break;
        case ItemKind::Material:
            row.material = &scene.materials[position];
            row.name = display_name(*row.material);
            return row;
        case ItemKind::Texture: row.texture = &scene.textures[position]; break;
        case ItemKind::Generator:
        case ItemKind::Model:
        case ItemKind::Background: break;
    }
    row.name = item_name(scene, item);
    return row;
}

const char* icon_of(const Row& row, TreeSection section) {
    if (section == TreeSection::Lights) return ICON_FA_LIGHTBULB;
    switch (row.item.kind) {
        case ItemKind::Object: return object_icon(*row.object);
        case ItemKind::Generator: return ICON_FA_TABLE_CELLS;
        case ItemKind::Camera: return ICON_FA_VIDEO;
        case ItemKind::Model: return ICON_FA_CUBES;
        case ItemKind::Material: return ICON_FA_PALETTE;
        case ItemKind::Texture: return texture_icon(row.texture->kind);
        case ItemKind::Background: break;
    }
    return ICON_FA_CLOUD_SUN;
}

void draw_icon(PanelContext& c, const Scene& scene, const Row& row, TreeSection section, ImVec2 low,
               float size) {
    ImDrawList* draw = ImGui::GetWindowDrawList();
    uint64_t picture = 0;
    if (c.ui.previews && row.material) picture = c.ui.previews->material(scene, *row.material);
    if (c.ui.previews && row.texture) picture = c.ui.previews->texture(scene, *row.texture);
    if (picture) {
        draw->AddImageRounded(static_cast<ImTextureID>(picture), low, {low.x + size, low.y + size},
                              {0, 0}, {1, 1}, IM_COL32_WHITE, ui::px(3));
        return;
    }
    const char* const icon = icon_of(row, section);
    const ImVec2 text = ImGui::CalcTextSize(icon);
    draw->AddText({low.x + (size - text.x) / 2, low.y + (size - text.y) / 2},
                  ImGui::GetColorU32(ImGuiCol_TextDisabled), icon);
}

// The eye: an object is visible, a camera is looked through.
void draw_eye(PanelContext& c, const Scene& scene, const Row& row, bool is_hovered) {
    if (!row.object && !row.camera) return;
    const bool is_on = row.object ? row.object->visible : active_camera(scene).id == row.camera->id;
    // What is as usual is quiet: the eye shows where it says something or can be reached.
    const bool says_something = row.object ? !is_on : is_on && scene.cameras.size() > 1;
    if (!is_hovered && !says_something) return;
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    const bool pressed = ui::icon_button(is_on ? ICON_FA_EYE "##eye" : ICON_FA_EYE_SLASH "##eye",
                                         row.object ? "Show or hide" : "Look through this camera");
    ImGui::PopStyleColor();
    if (!pressed) return;
    if (row.camera) {
        c.document.edit("Choose camera", "",
                        [id = row.camera->id](Scene& s) { s.active_camera = id; });
        return;
    }
    // A selected row stands for the whole selection.
    std::vector<ObjectId> ids = {row.object->id};
    if (c.document.is_selected(row.object->id)) ids = c.document.selection;
    c.document.edit(is_on ? "Hide" : "Show", "", [&](Scene& s) { set_visible(s, ids, !is_on); });
}

void draw_rename(PanelContext& c, const Row& row, float height) {
    SceneTreeState& tree = c.ui.tree;
    ImGui::SetNextItemWidth(-1);
    ImGui::PushStyleVarY(ImGuiStyleVar_FramePadding,
                         std::floor((height - ImGui::GetFontSize()) / 2));
    const bool is_new =
        ImGui::GetFocusID() != ImGui::GetID("##rename") && !ImGui::IsAnyItemActive();
    if (is_new) ImGui::SetKeyboardFocusHere();
    const bool done =
        ImGui::InputText("##rename", &tree.rename_text,
                         ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
    ImGui::PopStyleVar();
    const bool left = ImGui::IsItemDeactivated();
    if (!done && !left) return;
    tree.is_renaming = false;
    const bool cancelled = ImGui::IsKeyPressed(ImGuiKey_Escape);
    if (!cancelled && !tree.rename_text.empty() && tree.rename_text != row.name)
        c.document.edit("Rename", "",
                        [&](Scene& s) { rename_item(s, row.item, tree.rename_text); });
}

void drag_and_drop(PanelContext& c, const Row& row) {
    if (row.material && ImGui::BeginDragDropSource()) {
        const MaterialId id = row.material->id;
        ImGui::SetDragDropPayload("material", &id, sizeof id);
        ImGui::TextUnformatted(row.name.c_str());
        ImGui::EndDragDropSource();
    }
    if (!row.object || !ImGui::BeginDragDropTarget()) return;
    if (const ImGuiPayload* payload = ImGui::AcceptDragDropPayload("material")) {
        const MaterialId id = *static_cast<const MaterialId*>(payload->Data);
        std::vector<ObjectId> ids = {row.object->id};
        if (c.document.is_selected(row.object->id)) ids = c.document.selection;
        c.document.edit("Set material", "", [&](Scene& s) { assign_material(s, ids, id); });
    }
    ImGui::EndDragDropTarget();
}

}  // namespace

bool tree_row_ground(ImVec2 low, float width, float height, bool is_selected) {
    const ImVec2 high{low.x + width, low.y + height};
    const bool hovered = ImGui::IsMouseHoveringRect(low, high) && ImGui::IsWindowHovered();
    if (is_selected || hovered)
        ImGui::GetWindowDrawList()->AddRectFilled(
            low, high, ImGui::GetColorU32(is_selected ? ImGuiCol_Header : ImGuiCol_HeaderHovered),
            ImGui::GetStyle().FrameRounding);
    return hovered;
}

bool tree_row_button(const char* id, float width, float height) {
    for (const ImGuiCol color : {ImGuiCol_Header, ImGuiCol_HeaderHovered, ImGuiCol_HeaderActive})
        ImGui::PushStyleColor(color, ImVec4(0, 0, 0, 0));
    const bool pressed = ImGui::Selectable(id, false, ImGuiSelectableFlags_None, {width, height});
    ImGui::PopStyleColor(3);
    return pressed;
}

const char* object_icon(const Object& o) {
    switch (o.shape.index()) {
        case 0: return ICON_FA_CIRCLE;
        case 5: return ICON_FA_CUBE;
        case 6: return ICON_FA_COMPACT_DISC;
        case 7: return ICON_FA_PLAY;
        case 8: return ICON_FA_SHAPES;
        default: return ICON_FA_SQUARE;
    }
}

void start_rename(PanelContext& c, SceneItem item) {
    if (item.kind == ItemKind::Background) return;
    c.ui.tree.is_renaming = true;
    c.ui.tree.renamed = item;
    c.ui.tree.rename_text = item_name(c.document.scene(), item);
}

void draw_scene_row(PanelContext& c, const Scene& scene, TreeSection section, size_t index,
                    float height) {
    SceneTreeState& tree = c.ui.tree;
    const SceneItem item = tree.rows.rows(section)[index];
    const Row row = row_of(scene, item, tree.rows.positions(section)[index]);
    ImGui::PushID(static_cast<int>(item.kind));
    ImGui::PushID(static_cast<int>(item.id));
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x,
                indent = section == TreeSection::Background ? 0 : ImGui::GetFontSize() * 0.8f,
                icon = height - ui::px(4), gap = ui::px(6), eye = ImGui::GetFrameHeight();
    if (tree.is_renaming && tree.renamed == item) {
        draw_icon(c, scene, row, section, {low.x + indent, low.y + ui::px(2)}, icon);
        ImGui::SetCursorScreenPos({low.x + indent + icon + ui::px(2), low.y});
        draw_rename(c, row, height);
    } else {
        const bool is_selected = c.document.is_selected(item);
        const bool hovered = tree_row_ground(low, width, height, is_selected);
        const float clickable = row.object || row.camera ? width - eye : width;
        if (tree_row_button("###row", clickable, height))
            select_by_click(c, section, index, ImGui::GetIO().KeyCtrl, ImGui::GetIO().KeyShift);
        if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0) && !ImGui::GetIO().KeyCtrl)
            start_rename(c, item);
        drag_and_drop(c, row);
        if (ImGui::BeginPopupContextItem("menu")) {
            if (ImGui::IsWindowAppearing())
                tree.menu_items = is_selected ? c.document.selected_items() : std::vector{item};
            scene_row_menu(c, tree.menu_items);
            ImGui::EndPopup();
        }
        draw_icon(c, scene, row, section, {low.x + indent, low.y + ui::px(2)}, icon);
        const float space = width - indent - icon - gap - eye;
        const std::string text = ui::fitted(row.name, space);
        const bool is_dim = row.object && !row.object->visible;
        ImGui::GetWindowDrawList()->AddText(
            {low.x + indent + icon + gap, low.y + std::floor((height - ImGui::GetFontSize()) / 2)},
            ImGui::GetColorU32(is_dim ? ImGuiCol_TextDisabled : ImGuiCol_Text), text.c_str());
        if (text != row.name && hovered) ImGui::SetItemTooltip("%s", row.name.c_str());
        ImGui::SetCursorScreenPos({low.x + width - eye, low.y + std::floor((height - eye) / 2)});
        draw_eye(c, scene, row, hovered);
    }
    ImGui::SetCursorScreenPos({low.x, low.y + height});
    ImGui::PopID();
    ImGui::PopID();
}

}  // namespace tp
