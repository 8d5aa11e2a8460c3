// The handles that move, turn and scale the selection in the picture.
// ImGuizmo needs ImGui before it.
// clang-format off
#include <imgui.h>
#include <ImGuizmo.h>
// clang-format on

#include "../fly_camera.h"
#include "../viewport/projection.h"
#include "../viewport/scene_extent.h"
#include "viewport_parts.h"

#include <teapath/scene/pose.h>

#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>

namespace tp {
namespace {

constexpr float kGizmoSize = 0.14f;  // of the picture

GizmoKind kind_of(Tool tool) {
    return tool == Tool::Move     ? GizmoKind::Move
           : tool == Tool::Rotate ? GizmoKind::Rotate
                                  : GizmoKind::Scale;
}

const char* name_of(GizmoKind kind) {
    return kind == GizmoKind::Move ? "Move" : kind == GizmoKind::Rotate ? "Rotate" : "Scale";
}

// Matrices as OpenGL has them, with clip planes that suit a gizmo at this place.
struct GizmoView {
    glm::mat4 view, projection;
};
GizmoView gizmo_view(const Camera& camera, const ViewportFrame& frame, const Double3& place) {
    const CameraAxes axes = axes_of(camera);
    const double depth = std::max(1e-6, glm::distance(place, camera.look_from));
    const double near = depth / 100, far = depth * 100;
    const bool is_parallel = camera.projection == ProjectionKind::Orthographic;
    const double height = seen_height(camera, near) / 2, width = height * frame.aspect();
    const Double2 middle = Double2(width, height) * camera.shift * 2.0;
    const double left = middle.x - width, right = middle.x + width, bottom = middle.y - height,
                 top = middle.y + height;
    return {glm::mat4(glm::lookAt(camera.look_from, camera.look_from + axes.forward, axes.up)),
            glm::mat4(is_parallel ? glm::ortho(left, right, bottom, top, -far, far)
                                  : glm::frustum(left, right, bottom, top, near, far))};
}

// Shows the gizmo at `matrix`, which a drag changes. Returns true if it did.
bool manipulate(const ViewportState& v, const ViewportFrame& frame, const Camera& camera,
                DoubleMat4& matrix) {
    const GizmoView view = gizmo_view(camera, frame, Double3(matrix[3]));
    const GizmoKind kind = kind_of(v.tool);
    const ImGuizmo::OPERATION operation = kind == GizmoKind::Move     ? ImGuizmo::TRANSLATE
                                          : kind == GizmoKind::Rotate ? ImGuizmo::ROTATE
                                                                      : ImGuizmo::SCALE;
    const float step = kind == GizmoKind::Move     ? v.move_step
                       : kind == GizmoKind::Rotate ? v.rotate_step
                                                   : v.scale_step;
    const float snap[3] = {step, step, step};
    // Ctrl turns snapping round for as long as it is held.
    const bool snaps = v.snap != ImGui::GetIO().KeyCtrl;
    ImGuizmo::SetOrthographic(camera.projection == ProjectionKind::Orthographic);
    ImGuizmo::SetDrawlist();
    ImGuizmo::SetGizmoSizeClipSpace(kGizmoSize);
    ImGuizmo::SetRect(
        static_cast<float>(frame.picture.low.x), static_cast<float>(frame.picture.low.y),
        static_cast<float>(frame.picture.size.x), static_cast<float>(frame.picture.size.y));
    glm::mat4 single(matrix);
    const bool changed =
        ImGuizmo::Manipulate(glm::value_ptr(view.view), glm::value_ptr(view.projection), operation,
                             v.local_axes ? ImGuizmo::LOCAL : ImGuizmo::WORLD,
                             glm::value_ptr(single), nullptr, snaps && step > 0 ? snap : nullptr);
    if (changed) matrix = DoubleMat4(single);
    return changed;
}

// Places an object so that the scene's time takes it to `shown`.
void place_object(const Transform& shown, PoseChanges& changes, Object& object) {
    const auto change = changes.of(object);
    if (!change || *change == DoubleMat4(1)) {
        object.transform = shown;
        return;
    }
    move_object(object, *change);
    object.transform = shown;
    move_object(object, glm::inverse(*change));
}

// Places the objects as the drag has them.
void place_objects(PanelContext& c, GizmoKind kind) {
    const GizmoDrag& drag = c.ui.viewport.gizmo;
    const std::vector<GizmoDrag::Start> placed = drag.placed(kind);
    const Object* first = find(c.document.scene(), placed.back().id);
    if (!first) return;
    const std::string what =
        placed.size() == 1 ? display_name(*first) : fmt::format("{} objects", placed.size());
    c.document.edit(fmt::format("{} {}", name_of(kind), what),
                    fmt::format("gizmo {} {}", name_of(kind), first->id.value), [&](Scene& s) {
                        PoseChanges changes(s);
                        for (const GizmoDrag::Start& p : placed)
                            if (Object* o = find_object(s, p.id))
                                place_object(p.transform, changes, *o);
                    });
}

}  // namespace

GizmoUse draw_gizmo(PanelContext& c, const ViewportFrame& frame) {
    ViewportState& v = c.ui.viewport;
    GizmoDrag& drag = v.gizmo;
    const std::vector<Object> posed =
        posed_copies(c, selected_objects(c.document.scene(), c.document.selection));
    const std::vector<const Object*> objects = addresses_of(posed);
    const bool is_gizmo_tool = v.tool != Tool::Select && v.tool != Tool::Focus;
    const Camera camera = active_camera(c.document.scene());
    if (!is_gizmo_tool || objects.empty() || !keeps_lines_straight(camera)) {
        if (std::exchange(drag.is_active, false)) c.document.end_merge();
        return {};
    }

    // At rest it stands in the middle of the selection; a drag carries it along.
    const GizmoKind kind = kind_of(v.tool);
    DoubleMat4 matrix = drag.now;
    if (!drag.is_active) {
        const ObjectId last = c.document.selection.back();
        const auto active =
            std::find_if(posed.begin(), posed.end(), [&](const Object& o) { return o.id == last; });
        const DoubleMat3 axes =
            gizmo_axes(active != posed.end() ? *active : posed.back(), v.local_axes);
        drag.begin(objects, extent_of(objects)->center, axes);
        drag.is_active = false;
        matrix = drag.start;
    }
    const bool changed = manipulate(v, frame, camera, matrix);
    GizmoUse use;
    use.is_over = ImGuizmo::IsOver() || ImGuizmo::IsUsing();
    if (ImGuizmo::IsUsing() && changed) {
        drag.is_active = true;
        drag.is_uniform = ImGuizmo::GetActiveHandleType() == ImGuizmo::MT_SCALE_XYZ;
        drag.now = matrix;
        place_objects(c, kind);
        use.changed = true;
    }
    if (drag.is_active && !ImGuizmo::IsUsing()) {
        drag.is_active = false;
        c.document.end_merge();
    }
    return use;
}

}  // namespace tp
