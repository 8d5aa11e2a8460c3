// The picture in its panel: its size, its place, and the parts that act on it or are drawn over it.
#include "../viewport/scene_extent.h"
#include "panels.h"
#include "viewport_parts.h"

#include <teapath/scene/pose.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace tp {
namespace {

constexpr ImU32 kSurround = IM_COL32(46, 46, 46, 255);  // about 18 % of the light of white

constexpr int kFramesToSettle = 4;

// The size that the picture is rendered at.
void choose_size(PanelContext& c, const Double2& panel) {
    ViewportState& v = c.ui.viewport;
    if (v.fixed_size) {
        v.width = c.document.scene().render.width;
        v.height = c.document.scene().render.height;
        return;
    }
    const Double2 scale = from_im(ImGui::GetIO().DisplayFramebufferScale);
    v.width = std::max(1, static_cast<int>(panel.x * scale.x));
    v.height = std::max(1, static_cast<int>(panel.y * scale.y));
}

ViewportFrame place_picture(const PanelContext& c, const PlaceRect& panel) {
    const ViewportState& v = c.ui.viewport;
    const Double2 scale = from_im(ImGui::GetIO().DisplayFramebufferScale);
    ViewportFrame frame;
    frame.panel = panel;
    frame.pixels = Double2(v.width, v.height) / scale;
    frame.picture = picture_place(v.view, panel.low, panel.size, frame.pixels);
    frame.zoom = frame.picture.size.x / frame.pixels.x;
    return frame;
}

// In pixels of the window's framebuffer.
PlaceRect framebuffer_place(const PlaceRect& rect) {
    const ImGuiViewport& viewport = *ImGui::GetWindowViewport();
    const Double2 scale = from_im(viewport.FramebufferScale);
    return {(rect.low - from_im(viewport.Pos)) * scale, rect.size * scale};
}

// What a selected model consists of, found where model or scene are others than before.
struct ModelParts {
    ScenePtr scene;
    SceneItem model;
    std::vector<const Object*> objects;
};

// The objects that are selected, by themselves or as those of a model.
std::vector<const Object*> objects_to_outline(const PanelContext& c) {
    const Scene& scene = c.document.scene();
    if (!c.document.selection.empty()) return selected_objects(scene, c.document.selection);
    const std::vector<SceneItem> items = c.document.selected_items();
    if (items.empty() || items.back().kind != ItemKind::Model) return {};
    ModelParts& known = c.ui.local.get<ModelParts>();
    if (known.scene != c.document.snapshot() || known.model != items.back()) {
        known = {c.document.snapshot(), items.back(), {}};
        for (const Object& object : scene.objects)
            if (object.part.model == ModelId{known.model.id}) known.objects.push_back(&object);
    }
    return known.objects;
}

void draw_layers(PanelContext& c, const ViewportFrame& frame) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(im(frame.panel.low), im(frame.panel.low + frame.panel.size), kSurround);
    LayerFrame layers;
    layers.panel = framebuffer_place(frame.panel);
    layers.picture = framebuffer_place(frame.picture);
    layers.texture = c.texture.id();
    layers.is_nearest = !c.ui.preferences.smooth_picture || frame.zoom >= kPixelGridZoom;
    layers.has_pixel_grid = frame.zoom >= kPixelGridZoom;
    layers.has_ground_grid = c.ui.preferences.ground_grid;
    layers.scale = c.window.scale();
    layers.camera = active_camera(c.document.scene());
    const std::vector<const Object*> selected = objects_to_outline(c);
    if (animation_length(c.document.scene()) > 0) {
        const std::vector<Object> posed = posed_copies(c, selected);
        layers.selection = outline_parts(addresses_of(posed), c.layers.most_outline_triangles());
    } else {
        layers.selection = outline_parts(selected, c.layers.most_outline_triangles());
    }
    c.layers.add_to(list, std::move(layers));
}

void draw_contents(PanelContext& c, const PlaceRect& panel) {
    ViewportState& v = c.ui.viewport;
    choose_size(c, panel.size);
    ViewportFrame frame = place_picture(c, panel);
    v.panel_size = panel.size;
    v.picture_pixels = frame.pixels;

    // No item of its own under the pointer: the gizmo acts only where there is none.
    ImGui::Dummy(im(panel.size));
    frame.is_hovered = ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem) &&
                       ImGui::IsMouseHoveringRect(im(panel.low), im(panel.low + panel.size));
    const bool clicked =
        ImGui::IsMouseClicked(0) || ImGui::IsMouseClicked(1) || ImGui::IsMouseClicked(2);
    // Panels that appear take the keyboard: the viewport gets it after the first frames.
    const bool gets_focus = v.wants_focus && ImGui::GetFrameCount() > kFramesToSettle;
    if ((frame.is_hovered && clicked) || gets_focus) ImGui::SetWindowFocus();
    if (gets_focus) v.wants_focus = false;
    v.has_focus = ImGui::IsWindowFocused();

    draw_layers(c, frame);
    const GizmoUse gizmo = draw_gizmo(c, frame);
    v.is_moving = handle_viewport_input(c, frame, gizmo.is_over) || gizmo.changed;
    draw_overlay(c, frame);
    draw_welcome(c, frame);
}

}  // namespace

void draw_viewport(PanelContext& c) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
    const bool open =
        begin_panel(c, "Viewport",
                    ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse |
                        ImGuiWindowFlags_NoNavInputs);
    ImGui::PopStyleVar();
    c.ui.viewport.is_moving = c.ui.viewport.has_focus = false;
    ImVec2 space = ImGui::GetContentRegionAvail();
    const float timeline = timeline_height(c);
    space.y -= timeline;
    if (open && space.x >= 1 && space.y >= 1) {
        const ImVec2 below(ImGui::GetCursorPosX(), ImGui::GetCursorPosY() + space.y);
        draw_contents(c, {from_im(ImGui::GetCursorScreenPos()), from_im(space)});
        ImGui::SetCursorPos(below);
        draw_timeline(c);
    }
    ImGui::End();
}

}  // namespace tp
