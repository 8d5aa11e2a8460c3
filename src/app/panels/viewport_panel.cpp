// The picture: flying, picking, the gizmo, the overlay.
// ImGuizmo needs ImGui before it.
// clang-format off
#include <imgui.h>
#include <ImGuizmo.h>
// clang-format on

#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>

// After imgui.h, which it needs.
#include "../actions.h"
#include "../fly_camera.h"
#include "panels.h"

#include <teapath/editor/scene_edits.h>

namespace tp {
namespace {

constexpr double kRadians = 3.14159265358979323846 / 180;
constexpr ImU32 kAmber = IM_COL32(232, 163, 61, 255);

// Where the picture lies on the screen.
struct ImageRect {
    ImVec2 low, size;
};

// A speed that crosses what the camera looks at in a few seconds.
double default_speed(const Camera& camera) {
    return std::max(0.05, glm::distance(camera.look_from, camera.look_at) / 3);
}

// The direction that two opposite held actions ask for: -1 to 1.
double held_axis(const PanelContext& c, const char* positive, const char* negative) {
    return (is_held(positive, c) ? 1 : 0) - (is_held(negative, c) ? 1 : 0);
}

// Keys and mouse while the picture has the focus. Returns true while the camera moves.
bool fly_with_input(PanelContext& c, bool hovered) {
    const ImGuiIO& io = ImGui::GetIO();
    bool& looking = c.ui.viewport.is_looking;
    if (hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Right)) looking = true;
    if (!ImGui::IsMouseDown(ImGuiMouseButton_Right)) looking = false;
    const bool keys = (c.ui.viewport.has_focus || looking) && !io.WantTextInput &&
                      !(io.KeyCtrl && !looking) && !io.KeyAlt;
    Camera camera = active_camera(c.document.scene());
    if (c.ui.viewport.fly_speed <= 0) c.ui.viewport.fly_speed = default_speed(camera);

    FlyInput input;
    if (keys) {
        input.right = held_axis(c, "fly.right", "fly.left");
        input.forward = held_axis(c, "fly.forward", "fly.back");
        input.up = held_axis(c, "fly.up", "fly.down");
    }
    if (looking) {
        input.yaw = static_cast<double>(io.MouseDelta.x) * 0.15;
        input.pitch = -static_cast<double>(io.MouseDelta.y) * 0.15;
    }
    input.speed = c.ui.viewport.fly_speed * (is_held("fly.faster", c) ? 4 : 1);
    input.seconds = std::min(0.1, static_cast<double>(io.DeltaTime));
    Camera moved = fly(camera, input);

    if (hovered && io.MouseWheel != 0) {
        if (looking)
            c.ui.viewport.fly_speed = std::clamp(
                c.ui.viewport.fly_speed * std::pow(1.2, static_cast<double>(io.MouseWheel)), 1e-4,
                1e6);
        else
            moved.vertical_fov =
                std::clamp(moved.vertical_fov - 2 * static_cast<double>(io.MouseWheel), 1.0, 120.0);
    }
    if (hovered && io.KeyAlt && ImGui::IsMouseDragging(ImGuiMouseButton_Left, 0))
        moved = orbit(moved, moved.look_at, static_cast<double>(io.MouseDelta.x) * 0.3,
                      -static_cast<double>(io.MouseDelta.y) * 0.3);
    if (hovered && ImGui::IsMouseDragging(ImGuiMouseButton_Middle, 0)) {
        const double distance = glm::distance(moved.look_from, moved.look_at);
        const double unit =
            2 * distance * std::tan(moved.vertical_fov * kRadians / 2) / c.ui.viewport.height;
        const Double3 view = glm::normalize(moved.look_at - moved.look_from),
                      right = glm::normalize(glm::cross(view, moved.up));
        const Double3 shift = (glm::cross(right, view) * static_cast<double>(io.MouseDelta.y) -
                               right * static_cast<double>(io.MouseDelta.x)) *
                              unit;
        moved.look_from += shift;
        moved.look_at += shift;
    }
    if (moved == camera) return false;
    c.document.fly(moved);
    return true;
}

// Matrices for the gizmo, as OpenGL has them.
struct GizmoView {
    glm::mat4 view, projection;
};
GizmoView gizmo_view(const Camera& camera, const ImageRect& rect) {
    return {glm::mat4(glm::lookAt(camera.look_from, camera.look_at, camera.up)),
            glm::perspective(static_cast<float>(camera.vertical_fov * kRadians),
                             rect.size.x / rect.size.y, 0.01f, 10000.0f)};
}

// Moves, turns or scales the active object. Returns true while it is dragged.
bool draw_gizmo(PanelContext& c, const ImageRect& rect) {
    if (c.ui.viewport.tool == Tool::Select || c.document.selection.empty()) return false;
    const Object* object = find(c.document.scene(), c.document.selection.back());
    if (!object) return false;
    const GizmoView view = gizmo_view(active_camera(c.document.scene()), rect);
    ImGuizmo::SetDrawlist();
    ImGuizmo::SetRect(rect.low.x, rect.low.y, rect.size.x, rect.size.y);
    // The gizmo stands at the object's middle, whatever its own origin is.
    const Extent extent = extent_of(*object);
    const Double3 offset = extent.center - object->transform.translation;
    glm::mat4 matrix = glm::mat4(world_from_object(object->transform));
    matrix[3] = glm::vec4(glm::vec3(extent.center), 1);
    const ImGuizmo::OPERATION operation = c.ui.viewport.tool == Tool::Move     ? ImGuizmo::TRANSLATE
                                          : c.ui.viewport.tool == Tool::Rotate ? ImGuizmo::ROTATE
                                                                               : ImGuizmo::SCALE;
    const float step = c.ui.viewport.tool == Tool::Rotate ? 15.0f : 0.1f;
    const float snap[3] = {step, step, step};
    const bool changed =
        ImGuizmo::Manipulate(glm::value_ptr(view.view), glm::value_ptr(view.projection), operation,
                             c.ui.viewport.tool == Tool::Move ? ImGuizmo::WORLD : ImGuizmo::LOCAL,
                             glm::value_ptr(matrix), nullptr, c.ui.viewport.snap ? snap : nullptr);
    if (changed) {
        float t[3], r[3], s[3];
        ImGuizmo::DecomposeMatrixToComponents(glm::value_ptr(matrix), t, r, s);
        Transform transform = object->transform;
        if (c.ui.viewport.tool == Tool::Move)
            transform.translation = Double3(t[0], t[1], t[2]) - offset;
        if (c.ui.viewport.tool == Tool::Rotate) transform.rotation = Double3(r[0], r[1], r[2]);
        if (c.ui.viewport.tool == Tool::Scale)
            transform.scale = glm::max(Double3(s[0], s[1], s[2]), Double3(1e-4));
        const char* names[] = {"", "Move", "Rotate", "Scale"};
        const char* name = names[static_cast<int>(c.ui.viewport.tool)];
        c.document.edit(fmt::format("{} {}", name, display_name(*object)),
                        fmt::format("gizmo {} {}", name, object->id.value), [&](Scene& scene) {
                            if (Object* o = find_object(scene, object->id))
                                o->transform = transform;
                        });
    }
    static bool was_used = false;
    if (was_used && !ImGuizmo::IsUsing()) c.document.end_merge();
    was_used = ImGuizmo::IsUsing();
    return changed;
}

// A circle around each selected object, where it is seen.
void draw_selection(PanelContext& c, const ImageRect& rect) {
    const Camera camera = active_camera(c.document.scene());
    const GizmoView view = gizmo_view(camera, rect);
    ImDrawList* draw = ImGui::GetWindowDrawList();
    for (const ObjectId id : c.document.selection) {
        const Object* object = find(c.document.scene(), id);
        if (!object) continue;
        const Extent e = extent_of(*object);
        const glm::vec4 clip = view.projection * view.view * glm::vec4(glm::vec3(e.center), 1);
        if (clip.w <= 0) continue;
        const ImVec2 p(rect.low.x + (clip.x / clip.w * 0.5f + 0.5f) * rect.size.x,
                       rect.low.y + (0.5f - clip.y / clip.w * 0.5f) * rect.size.y);
        const float radius =
            static_cast<float>(e.radius / std::tan(camera.vertical_fov * kRadians / 2)) / clip.w *
            rect.size.y / 2;
        draw->AddCircle(p, std::clamp(radius, 4.0f, 4000.0f), kAmber, 64, 1.5f);
    }
}

void overlay_text(const ImVec2& at, const std::string& text, ImU32 color) {
    ImDrawList* draw = ImGui::GetWindowDrawList();
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    draw->AddRectFilled({at.x - 6, at.y - 3}, {at.x + size.x + 6, at.y + size.y + 3},
                        IM_COL32(0, 0, 0, 140), 4);
    draw->AddText(at, color, text.c_str());
}

void draw_overlay(PanelContext& c, const ImageRect& rect) {
    std::string text =
        fmt::format("{} / {} spp", c.status.samples, c.document.scene().render.samples);
    if (c.status.is_preview) text += "  preview";
    overlay_text({rect.low.x + 12, rect.low.y + 10}, text, IM_COL32(230, 230, 230, 255));
    if (c.ui.paused) {
        ImGui::GetWindowDrawList()->AddRect(
            rect.low, {rect.low.x + rect.size.x, rect.low.y + rect.size.y}, kAmber, 0, 2.0f);
        overlay_text({rect.low.x + rect.size.x - 70, rect.low.y + 10}, "Paused", kAmber);
    }
    // Notices, newest at the bottom.
    const double now = ImGui::GetTime();
    while (!c.ui.toasts.empty() && c.ui.toasts.front().until < now)
        c.ui.toasts.pop_front();
    float y = rect.low.y + rect.size.y - 30;
    for (auto toast = c.ui.toasts.rbegin(); toast != c.ui.toasts.rend(); ++toast, y -= 28) {
        const float width = ImGui::CalcTextSize(toast->text.c_str()).x;
        overlay_text({std::max(rect.low.x + 12, rect.low.x + rect.size.x - width - 18), y},
                     toast->text,
                     toast->is_error ? IM_COL32(255, 140, 120, 255) : IM_COL32(230, 230, 230, 255));
    }
}

}  // namespace

void draw_viewport(PanelContext& c) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
    const bool open = ImGui::Begin(
        "Viewport", nullptr, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    ImGui::PopStyleVar();
    c.ui.viewport.is_moving = c.ui.viewport.has_focus = false;
    const ImVec2 space = ImGui::GetContentRegionAvail();
    if (open && space.x >= 1 && space.y >= 1) {
        c.ui.viewport.width = static_cast<int>(space.x);
        c.ui.viewport.height = static_cast<int>(space.y);
        const ImageRect rect{ImGui::GetCursorScreenPos(), space};
        if (c.texture.id())
            ImGui::Image(static_cast<ImTextureID>(c.texture.id()), space);
        else
            ImGui::Dummy(space);
        const bool hovered = ImGui::IsItemHovered();
        if (hovered &&
            (ImGui::IsMouseClicked(0) || ImGui::IsMouseClicked(1) || ImGui::IsMouseClicked(2)))
            ImGui::SetWindowFocus();

        c.ui.viewport.has_focus = ImGui::IsWindowFocused();
        c.ui.viewport.is_moving = draw_gizmo(c, rect);
        const bool over_gizmo = c.ui.viewport.tool != Tool::Select &&
                                !c.document.selection.empty() &&
                                (ImGuizmo::IsOver() || ImGuizmo::IsUsing());
        if (hovered && !over_gizmo && !ImGui::GetIO().KeyAlt && ImGui::IsMouseClicked(0)) {
            const ImVec2 mouse = ImGui::GetMousePos();
            c.worker.request_pick(static_cast<double>((mouse.x - rect.low.x) / rect.size.x),
                                  static_cast<double>((mouse.y - rect.low.y) / rect.size.y));
        }
        if (const auto pick = c.worker.take_pick()) {
            // A generator's objects have ids that the document does not know.
            if (find(c.document.scene(), pick->object) || !pick->object)
                c.document.select(pick->object, ImGui::GetIO().KeyShift);
        }
        if (fly_with_input(c, hovered && !over_gizmo)) c.ui.viewport.is_moving = true;
        draw_selection(c, rect);
        draw_overlay(c, rect);
    }
    ImGui::End();
}

}  // namespace tp
