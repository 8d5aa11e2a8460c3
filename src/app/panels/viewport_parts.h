// The parts of the viewport panel, each in a file of its own.
#pragma once

#include "../context.h"

#include <imgui.h>

namespace tp {

inline constexpr ImU32 kAmber = IM_COL32(232, 163, 61, 255);

/// The viewport in this frame.
struct ViewportFrame {
    PlaceRect panel;    // its space on the screen
    PlaceRect picture;  // where the picture lies; may reach beyond the panel
    Double2 pixels;     // the picture's size at zoom 1, in the screen's units
    double zoom = 1;    // screen pixels a picture pixel
    bool is_hovered = false;

    double aspect() const { return picture.size.x / picture.size.y; }
};

inline ImVec2 im(const Double2& v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y)};
}
inline Double2 from_im(const ImVec2& v) {
    return {static_cast<double>(v.x), static_cast<double>(v.y)};
}

/// Keys and mouse: flies, selects, focuses, moves the picture. Returns true while the camera moves.
bool handle_viewport_input(PanelContext& c, const ViewportFrame& frame, bool is_over_gizmo);

/// Draws the gizmo of the selection and places the objects that it drags.
struct GizmoUse {
    bool is_over = false;  // the pointer belongs to the gizmo
    bool changed = false;  // it moved something in this frame
};
GizmoUse draw_gizmo(PanelContext& c, const ViewportFrame& frame);

/// The objects as the scene's time has them; forms of meshes as the newest picture has them.
std::vector<Object> posed_copies(const PanelContext& c, const std::vector<const Object*>& objects);

inline std::vector<const Object*> addresses_of(const std::vector<Object>& objects) {
    std::vector<const Object*> addresses;
    for (const Object& object : objects)
        addresses.push_back(&object);
    return addresses;
}

/// Height that the time line takes below the picture; 0 where nothing is animated.
float timeline_height(const PanelContext& c);
/// Draws it at the cursor, and moves the time on while it plays.
void draw_timeline(PanelContext& c);

/// Samples, time, speed, the frame of a paused render, notices.
void draw_overlay(PanelContext& c, const ViewportFrame& frame);
/// The card of the first start; any key or click closes it for good.
void draw_welcome(PanelContext& c, const ViewportFrame& frame);

}  // namespace tp
