// From ImGui's keys and mouse to the camera and the selection.
#include "../actions.h"
#include "../fly_camera.h"
#include "../viewport/projection.h"
#include "../viewport/scene_extent.h"
#include "viewport_parts.h"

#include <fmt/format.h>
#include <imgui_internal.h>

#include <cmath>
#include <utility>

namespace tp {
namespace {

constexpr double kSpeedShownSeconds = 1;
constexpr float kClickPixels = 4;   // beyond which a click is a drag
constexpr double kZoomStep = 1.25;  // a notch

enum PickPurpose { kPickSelect, kPickAdd, kPickFocus, kPickPivot };

NavigationInput::Key button(ImGuiMouseButton b) {
    return {ImGui::IsMouseDown(b), ImGui::IsMouseClicked(b)};
}

// The keys of a held action, without left Ctrl, which has rules of its own.
NavigationInput::Key held(const PanelContext& c, const char* id) {
    NavigationInput::Key key;
    for (const int chord : c.ui.keys.chords(id)) {
        const auto k = static_cast<ImGuiKey>(chord & ~ImGuiMod_Mask_);
        if (k == ImGuiKey_None || k == ImGuiKey_LeftCtrl) continue;
        key.down |= ImGui::IsKeyDown(k);
        key.pressed |= ImGui::IsKeyPressed(k, false);
    }
    return key;
}

// A menu or a dialog has the keys for itself.
bool is_popup_open() {
    return ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
}

bool any_other_key_pressed() {
    for (int k = ImGuiKey_Tab; k < ImGuiKey_GamepadStart; ++k) {
        const bool is_modifier = k >= ImGuiKey_LeftCtrl && k <= ImGuiKey_RightSuper;
        if (!is_modifier && ImGui::IsKeyPressed(static_cast<ImGuiKey>(k), false)) return true;
    }
    return false;
}

NavigationInput read_input(const PanelContext& c, bool is_hovered) {
    static constexpr const char* kIds[kFlyKeyCount] = {
        "fly.forward", "fly.back", "fly.left", "fly.right", "fly.up", "fly.down", "fly.faster"};
    const ImGuiIO& io = ImGui::GetIO();
    NavigationInput in;
    in.seconds = static_cast<double>(io.DeltaTime);
    in.mouse_delta = from_im(io.MouseDelta);
    in.wheel = static_cast<double>(io.MouseWheel);
    in.is_hovered = is_hovered;
    in.has_focus = c.ui.viewport.has_focus;
    in.is_typing = io.WantTextInput || is_popup_open() || !c.ui.dialogs.key_to_set.empty();
    in.alt = io.KeyAlt;
    in.ctrl = io.KeyCtrl;
    in.shift = io.KeyShift;
    in.left = button(ImGuiMouseButton_Left);
    in.middle = button(ImGuiMouseButton_Middle);
    in.right = button(ImGuiMouseButton_Right);
    for (size_t i = 0; i < kFlyKeyCount; ++i)
        in.keys[i] = held(c, kIds[i]);
    for (const int chord : c.ui.keys.chords("fly.down"))
        if (chord == ImGuiKey_LeftCtrl)
            in.down_by_ctrl = {ImGui::IsKeyDown(ImGuiKey_LeftCtrl),
                               ImGui::IsKeyPressed(ImGuiKey_LeftCtrl, false)};
    in.other_key_pressed = any_other_key_pressed();
    return in;
}

// Asks what lies under a point of the screen; beside the picture there is nothing.
void ask_pick(PanelContext& c, const ViewportFrame& frame, const Double2& at, int purpose) {
    const Camera camera = active_camera(c.document.scene());
    const Double2 p = picture_point(frame.picture, at);
    const ViewRay ray = view_ray(camera, frame.aspect(), p.x, p.y);
    RenderWorker::PickQuery query;
    query.purpose = purpose;
    query.origin = ray.origin;
    query.direction = ray.direction;
    query.t_max = ray.t_max;
    if (p.x < 0 || p.y < 0 || p.x >= 1 || p.y >= 1) query.t_max = 0;
    c.worker.request_pick(query);
}

void focus_at(PanelContext& c, const Double3& point) {
    Camera camera = active_camera(c.document.scene());
    camera.focus_distance = glm::dot(point - camera.look_from, axes_of(camera).forward);
    if (!(camera.focus_distance > 0)) return;
    c.document.edit("Focus", "", [&](Scene& s) {
        if (Camera* target = find_camera(s, camera.id)) *target = camera;
    });
    c.toast(fmt::format("Focus at {:.4g}{}", camera.focus_distance,
                        camera.aperture > 0 ? "" : "; the aperture is 0, so everything is sharp"));
}

void take_picks(PanelContext& c) {
    const Scene& scene = c.document.scene();
    for (const int purpose : {kPickSelect, kPickAdd}) {
        const auto pick = c.worker.take_pick(purpose);
        if (!pick) continue;
        // A generator's objects are not the document's.
        const bool known = find(scene, pick->object) != nullptr;
        if (known || purpose == kPickSelect)
            c.document.select(known ? pick->object : ObjectId{}, purpose == kPickAdd);
        if (pick->object && !known)
            c.toast("This object is made by a generator and cannot be selected by itself");
    }
    if (const auto pick = c.worker.take_pick(kPickFocus)) {
        if (pick->object)
            focus_at(c, pick->point);
        else
            c.toast("There is nothing to focus on");
    }
    if (const auto pick = c.worker.take_pick(kPickPivot)) {
        NavigationState& state = c.ui.viewport.navigation;
        state.pivot = pick->object ? pick->point : active_camera(scene).look_at;
        state.has_pivot = true;
    }
}

// A press and a release at the same place select, or focus.
void handle_click(PanelContext& c, const ViewportFrame& frame, bool is_hovered) {
    ViewportState& v = c.ui.viewport;
    const ImGuiIO& io = ImGui::GetIO();
    const bool focuses = v.tool == Tool::Focus || (io.KeyCtrl && io.KeyAlt);
    if (is_hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Left) && (!io.KeyAlt || focuses))
        v.click = from_im(io.MousePos);
    if (v.click && ImGui::IsMouseDragging(ImGuiMouseButton_Left, kClickPixels)) v.click.reset();
    if (v.navigation.drag != Drag::None) v.click.reset();
    if (!v.click || ImGui::IsMouseDown(ImGuiMouseButton_Left)) return;
    const Double2 at = *std::exchange(v.click, std::nullopt);
    if (!ImGui::IsMouseReleased(ImGuiMouseButton_Left)) return;
    ask_pick(c, frame, at, focuses ? kPickFocus : io.KeyShift ? kPickAdd : kPickSelect);
}

// While a drag has the pointer, nothing else in the window reacts to it.
void hold_pointer(PanelContext& c) {
    ViewportState& v = c.ui.viewport;
    const bool looking = v.navigation.drag == Drag::Look;
    if (looking != v.is_looking) c.window.capture_cursor(looking);
    v.is_looking = looking;
    ImGuiWindow* window = ImGui::GetCurrentWindow();
    const ImGuiID id = window->GetID("drag");
    const bool drags = v.navigation.drag != Drag::None && v.navigation.drag != Drag::Released;
    if (drags) {
        ImGui::SetActiveID(id, window);
        ImGui::SetKeyOwner(ImGuiKey_MouseWheelY, id);
    } else if (ImGui::GetActiveID() == id) {
        ImGui::ClearActiveID();
    }
    if (looking) ImGui::SetMouseCursor(ImGuiMouseCursor_None);
    if (drags && !looking) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeAll);
}

// Zoom and place of the picture on the screen.
void move_picture(PanelContext& c, const ViewportFrame& frame, const NavigationResult& result) {
    ViewportState& v = c.ui.viewport;
    const Double2 middle = frame.panel.low + frame.panel.size * 0.5;
    if (result.picture_zoom_steps != 0)
        v.view = zoomed(v.view, std::pow(kZoomStep, result.picture_zoom_steps),
                        from_im(ImGui::GetMousePos()) - middle, frame.panel.size, frame.pixels);
    if (result.picture_shift != Double2(0, 0))
        v.view = shifted(v.view, result.picture_shift, frame.panel.size, frame.pixels);
}

}  // namespace

bool handle_viewport_input(PanelContext& c, const ViewportFrame& frame, bool is_over_gizmo) {
    ViewportState& v = c.ui.viewport;
    const bool is_hovered = frame.is_hovered && !is_over_gizmo;
    const Camera camera = active_camera(c.document.scene());
    if (v.fly_speed <= 0) v.fly_speed = natural_speed(c.document.scene());

    // Answers first, so that a drag goes on about its pivot.
    take_picks(c);
    const double factor = c.ui.preferences.fly_speed;
    const NavigationSettings settings{v.fly_speed * factor, c.ui.preferences.look_degrees,
                                      frame.picture.size.y};
    const NavigationInput input = read_input(c, is_hovered);
    const NavigationResult result = navigate(v.navigation, input, settings, camera);
    if (std::exchange(v.navigation.wants_pivot, false))
        ask_pick(c, frame, from_im(ImGui::GetMousePos()), kPickPivot);
    if (result.fly_speed != settings.fly_speed) {
        v.fly_speed = result.fly_speed / factor;
        v.speed_shown_until = ImGui::GetTime() + kSpeedShownSeconds;
    }
    hold_pointer(c);
    handle_click(c, frame, is_hovered);
    move_picture(c, frame, result);
    if (result.camera == camera) return false;
    c.document.fly(result.camera);
    return true;
}

}  // namespace tp
