// What mouse and keyboard do to the camera, as a function of one frame's input and of what the
// frames before left behind. No ImGui, no window, no document: tests drive it frame by frame.
#pragma once

#include <teapath/core/math.h>
#include <teapath/scene/camera.h>

#include <array>

namespace tp {

/// The keys of flying, in the order of NavigationInput::keys.
enum class FlyKey { Forward, Back, Left, Right, Up, Down, Faster };
inline constexpr size_t kFlyKeyCount = 7;

/// One frame's input as the viewport sees it.
struct NavigationInput {
    struct Key {
        bool down = false;
        bool pressed = false;  // it went down in this frame
    };

    double seconds = 0;         // since the last frame
    Double2 mouse_delta{0, 0};  // pixels to the right and down
    double wheel = 0;           // notches; positive away from the user
    bool is_hovered = false;    // the pointer is over the picture and over nothing before it
    bool has_focus = false;     // the viewport has the keyboard
    bool is_typing = false;     // a text field or a dialog has the keyboard
    bool alt = false, ctrl = false, shift = false;
    Key left, middle, right;  // mouse buttons
    std::array<Key, kFlyKeyCount> keys;
    Key down_by_ctrl;                // left Ctrl where it is a key of flying down; not in `keys`
    bool other_key_pressed = false;  // any key but Ctrl, Shift and Alt went down in this frame
};

enum class Drag {
    None,
    Look,        // right button
    Pan,         // middle button: the camera
    Orbit,       // Alt and left button
    PanPicture,  // Shift and middle button: the picture on the screen
    Released     // given up with Esc; nothing until the buttons are up
};

/// What a frame leaves for the next one.
struct NavigationState {
    Drag drag = Drag::None;
    bool skips_delta = false;  // the next movement of the mouse is the capture's, not the user's
    std::array<bool, kFlyKeyCount> is_shortcut{};  // the key went down as part of a chord
    double ctrl_seconds = 0;                       // that left Ctrl has been down alone
    bool ctrl_is_shortcut = false;                 // a key went down while Ctrl was
    bool wants_pivot = false;                      // a drag began: trace what is under the pointer
    bool has_pivot = false;
    Double3 pivot{0, 0, 0};  // what an orbit turns about, what a pan takes along
};

struct NavigationSettings {
    double fly_speed = 1;       // scene units a second
    double look_degrees = 0.1;  // a pixel of the mouse
    double picture_height = 1;  // pixels
};

/// What came of a frame.
struct NavigationResult {
    Camera camera;
    double fly_speed = 1;           // changed by the wheel while the right button is held
    Double2 picture_shift{0, 0};    // pixels that the picture is dragged on the screen
    double picture_zoom_steps = 0;  // notches of Shift and wheel
};

inline constexpr double kFasterFactor = 4;     // of left Shift
inline constexpr double kCtrlDelay = 0.15;     // seconds that left Ctrl is down before it flies
inline constexpr double kLongestFrame = 0.25;  // seconds of flying that one frame may stand for

/// One frame. A key that goes down while Ctrl or Alt is down belongs to a shortcut and never flies
/// until it is up again; movement of the pointer in the frame of a button's press, and the first
/// one after a capture, never turns the camera.
NavigationResult navigate(NavigationState& state, const NavigationInput& input,
                          const NavigationSettings& settings, const Camera& camera);

/// Esc: gives the pointer free. False if it was not held.
bool release_pointer(NavigationState& state);

}  // namespace tp
