// What is selected, with everything that can be changed about it. The rows of each kind of thing
// are in files of their own.
#include "../preview/previews.h"
#include "inspector.h"
#include "panels.h"

#include <icons_font_awesome_6.h>
#include <imgui.h>
#include <imgui_stdlib.h>

namespace tp {
namespace {

void draw_nothing(PanelContext&) {
    ui::empty_state(ICON_FA_ARROW_POINTER,
                    "Click something in the picture or in the tree to see it here. "
                    "The Add menu makes new things.");
}

void draw_selection(PanelContext& c, const std::vector<SceneItem>& items) {
    switch (items.back().kind) {
        case ItemKind::Object: object_inspector(c, items); break;
        case ItemKind::Generator: generator_inspector(c, items); break;
        case ItemKind::Camera: camera_inspector(c, items); break;
        case ItemKind::Material: material_inspector(c, items); break;
        case ItemKind::Texture: texture_inspector(c, items); break;
        case ItemKind::Model: model_inspector(c, items); break;
        case ItemKind::Background: background_inspector(c); break;
    }
}

struct ItemActivity {
    bool was_active = false;  // in the frame before
};

// A drag or a text that has ended is one step of the history; what follows is another.
void end_merge_when_released(PanelContext& c) {
    bool& was_active = c.ui.local.get<ItemActivity>().was_active;
    const bool is_active = ImGui::IsAnyItemActive();
    if (was_active && !is_active) c.document.end_merge();
    was_active = is_active;
}

// The picture of a material, or of what an object is made of; 0 for other things.
uint64_t picture_of(PanelContext& c, SceneItem item) {
    const Scene& scene = c.document.scene();
    MaterialId id{item.kind == ItemKind::Material ? item.id : 0};
    if (item.kind == ItemKind::Object)
        if (const Object* object = find(scene, ObjectId{item.id})) id = object->material;
    const Material* material = find(scene, id);
    return material && c.ui.previews ? c.ui.previews->material(scene, *material) : 0;
}

void draw_picture(uint64_t picture, ImVec2 low, ImVec2 high) {
    ImDrawList* draw = ImGui::GetWindowDrawList();
    const float rounding = ImGui::GetStyle().FrameRounding;
    if (picture)
        draw->AddImageRounded(static_cast<ImTextureID>(picture), low, high, {0, 0}, {1, 1},
                              IM_COL32_WHITE, rounding);
    else
        draw->AddRectFilled(low, high, ImGui::GetColorU32(ImGuiCol_FrameBg), rounding);
}

}  // namespace

void inspector_header(PanelContext& c, const std::vector<SceneItem>& items, const char* icon,
                      const std::string& kind) {
    const SceneItem item = items.back();
    const float line = ImGui::GetFrameHeight();
    if (item.kind == ItemKind::Material || item.kind == ItemKind::Object) {
        const ImVec2 low = ImGui::GetCursorScreenPos(), size{2.4f * line, 2.4f * line};
        ImGui::Dummy(size);
        draw_picture(picture_of(c, item), low, {low.x + size.x, low.y + size.y});
        ImGui::SameLine();
    }
    ImGui::BeginGroup();
    const float gap = ImGui::GetFontSize() * 0.5f;
    float text_left = ImGui::GetCursorPosX();  // of the kind, below the name
    if (items.size() > 1) {
        ImGui::AlignTextToFramePadding();
        ImGui::Text("%s  %d selected", icon, static_cast<int>(items.size()));
    } else if (item.kind == ItemKind::Background) {
        ImGui::AlignTextToFramePadding();
        ImGui::Text("%s  Background", icon);
    } else {
        ImGui::AlignTextToFramePadding();
        ImGui::TextUnformatted(icon);
        ImGui::SameLine(0, gap);
        text_left = ImGui::GetCursorPosX();
        std::string name = item_name(c.document.scene(), item);
        ImGui::SetNextItemWidth(-1);
        if (ImGui::InputText("##name", &name, ImGuiInputTextFlags_AutoSelectAll) && !name.empty())
            c.document.edit("Rename",
                            fmt::format("rename {} {}", static_cast<int>(item.kind), item.id),
                            [&](Scene& s) { rename_item(s, item, name); });
        ui::tooltip("The name in the tree and in the scene file");
    }
    ImGui::SetCursorPosX(text_left + ImGui::GetStyle().FramePadding.x);
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    ui::fitted_text(kind, ImGui::GetContentRegionAvail().x);
    ImGui::PopStyleColor();
    ImGui::EndGroup();
    ImGui::Spacing();
}

void draw_inspector(PanelContext& c) {
    if (begin_panel(c, "Inspector")) {
        const std::vector<SceneItem> items = c.document.selected_items();
        // Fields of one thing are not those of another: what is typed is not carried over.
        const SceneItem shown = items.empty() ? SceneItem{} : items.back();
        ImGui::PushID(static_cast<int>(shown.kind));
        ImGui::PushID(static_cast<int>(shown.id));
        if (items.empty())
            draw_nothing(c);
        else
            draw_selection(c, items);
        ImGui::PopID();
        ImGui::PopID();
    }
    ImGui::End();
    end_merge_when_released(c);
}

}  // namespace tp
