#include "navigation.h"

#include "../fly_camera.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tp {
namespace {

constexpr double kOrbitDegrees = 0.3;  // a pixel
constexpr double kSpeedStep = 1.2;     // a notch of the wheel
constexpr double kLowestSpeed = 1e-4, kHighestSpeed = 1e6;

// Begins and ends drags.
void follow_buttons(NavigationState& state, const NavigationInput& in) {
    const bool none_down = !in.left.down && !in.middle.down && !in.right.down;
    const bool is_over =
        (state.drag == Drag::Look && !in.right.down) ||
        ((state.drag == Drag::Pan || state.drag == Drag::PanPicture) && !in.middle.down) ||
        (state.drag == Drag::Orbit && !in.left.down) || (state.drag == Drag::Released && none_down);
    if (is_over) state.drag = Drag::None;
    if (state.drag != Drag::None || !in.is_hovered) return;
    if (in.right.pressed)
        state.drag = Drag::Look;
    else if (in.middle.pressed)
        state.drag = in.shift ? Drag::PanPicture : Drag::Pan;
    else if (in.left.pressed && in.alt && !in.ctrl)
        state.drag = Drag::Orbit;
    if (state.drag == Drag::None) return;
    state.skips_delta = state.drag == Drag::Look;
    state.has_pivot = false;
    state.wants_pivot = state.drag == Drag::Orbit || state.drag == Drag::Pan;
}

// The movement of the pointer that belongs to the drag.
Double2 drag_delta(NavigationState& state, const NavigationInput& in) {
    if (state.drag == Drag::None || state.drag == Drag::Released) return {0, 0};
    if (in.right.pressed || in.middle.pressed || in.left.pressed) return {0, 0};
    if (in.mouse_delta == Double2(0, 0)) return {0, 0};
    if (std::exchange(state.skips_delta, false)) return {0, 0};
    return in.mouse_delta;
}

// Which keys fly: none of a chord, none while typing.
std::array<bool, kFlyKeyCount> flying_keys(NavigationState& state, const NavigationInput& in) {
    const bool looking = state.drag == Drag::Look;
    const bool active = (in.has_focus || looking) && !in.is_typing;
    std::array<bool, kFlyKeyCount> flying{};
    for (size_t i = 0; i < kFlyKeyCount; ++i) {
        const auto& key = in.keys[i];
        const bool is_modifier = i == static_cast<size_t>(FlyKey::Faster);
        if (!key.down) state.is_shortcut[i] = false;
        const bool in_chord = key.pressed && (in.ctrl || in.alt);
        if (key.down && !is_modifier && (in.is_typing || in_chord)) state.is_shortcut[i] = true;
        flying[i] = active && key.down && !state.is_shortcut[i];
    }

    // Left Ctrl flies where it is alone: at once while looking, else after a moment.
    if (!in.down_by_ctrl.down) {
        state.ctrl_seconds = 0;
        state.ctrl_is_shortcut = false;
    } else {
        const bool clicks = in.left.down || in.middle.down;
        if (in.other_key_pressed || in.is_typing || in.alt || clicks || (in.wheel != 0 && !looking))
            state.ctrl_is_shortcut = true;
        const bool was_ripe = state.ctrl_seconds >= kCtrlDelay;
        state.ctrl_seconds += in.seconds;
        if (active && !state.ctrl_is_shortcut && (looking || was_ripe))
            flying[static_cast<size_t>(FlyKey::Down)] = true;
    }
    return flying;
}

FlyInput fly_input(const std::array<bool, kFlyKeyCount>& flying) {
    const auto axis = [&](FlyKey positive, FlyKey negative) {
        return (flying[static_cast<size_t>(positive)] ? 1.0 : 0.0) -
               (flying[static_cast<size_t>(negative)] ? 1.0 : 0.0);
    };
    FlyInput input;
    input.right = axis(FlyKey::Right, FlyKey::Left);
    input.up = axis(FlyKey::Up, FlyKey::Down);
    input.forward = axis(FlyKey::Forward, FlyKey::Back);
    return input;
}

}  // namespace

NavigationResult navigate(NavigationState& state, const NavigationInput& in,
                          const NavigationSettings& settings, const Camera& camera) {
    NavigationResult result;
    result.camera = camera;
    result.fly_speed = settings.fly_speed;
    follow_buttons(state, in);
    const Double2 delta = drag_delta(state, in);
    const std::array<bool, kFlyKeyCount> flying = flying_keys(state, in);

    // The wheel.
    const bool looking = state.drag == Drag::Look;
    if (std::isfinite(in.wheel) && in.wheel != 0 && looking)
        result.fly_speed = std::clamp(settings.fly_speed * std::pow(kSpeedStep, in.wheel),
                                      kLowestSpeed, kHighestSpeed);
    else if (in.wheel != 0 && in.is_hovered && in.shift)
        result.picture_zoom_steps = in.wheel;
    else if (in.wheel != 0 && in.is_hovered && state.drag == Drag::None)
        result.camera = widened(result.camera, -in.wheel);

    // Keys and the look.
    FlyInput input = fly_input(flying);
    if (looking) {
        input.yaw = delta.x * settings.look_degrees;
        input.pitch = -delta.y * settings.look_degrees;
    }
    const bool faster = flying[static_cast<size_t>(FlyKey::Faster)];
    input.speed = result.fly_speed * (faster ? kFasterFactor : 1);
    input.seconds = std::clamp(in.seconds, 0.0, kLongestFrame);
    result.camera = fly(result.camera, input);

    // Drags about a point, once it is known.
    const CameraAxes axes = axes_of(camera);
    const double depth = glm::dot(state.pivot - camera.look_from, axes.forward);
    if (state.drag == Drag::Orbit && state.has_pivot)
        result.camera =
            orbit(result.camera, state.pivot, delta.x * kOrbitDegrees, -delta.y * kOrbitDegrees);
    if (state.drag == Drag::Pan && state.has_pivot && depth > 0)
        result.camera = pan(result.camera, delta, settings.picture_height, depth);
    if (state.drag == Drag::PanPicture) result.picture_shift = delta;
    return result;
}

bool release_pointer(NavigationState& state) {
    if (state.drag == Drag::None || state.drag == Drag::Released) return false;
    state.drag = Drag::Released;
    return true;
}

}  // namespace tp
