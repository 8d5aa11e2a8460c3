// What the viewport shows under the interface, drawn by the shaders of shaders/: the picture with
// its pixel grid, the ground grid, the outline of the selection; of panoramas the picture alone.
#pragma once

#include "../viewport/outline.h"
#include "../viewport/picture_place.h"

#include <teapath/scene/camera.h>

#include <cstdint>
#include <memory>
#include <vector>

struct ImDrawList;

namespace tp {

/// One frame of it. Places are in pixels of the window's framebuffer, from its top left.
struct LayerFrame {
    PlaceRect panel;    // nothing is drawn outside
    PlaceRect picture;  // may reach beyond the panel
    uint64_t texture = 0;
    bool is_nearest = false;  // pixels are not interpolated
    bool has_pixel_grid = false;
    bool has_ground_grid = false;
    float scale = 1;  // of the interface: lines grow with it
    Camera camera;
    std::vector<OutlinePart> selection;
};

class ViewportLayers {
public:
    /// Needs a GL context. Throws Error(Device) where the shaders do not compile.
    ViewportLayers();
    ~ViewportLayers();
    ViewportLayers(const ViewportLayers&) = delete;
    ViewportLayers& operator=(const ViewportLayers&) = delete;

    /// Has the frame drawn at this place of the list, when the interface is. The last frame given
    /// counts: once a frame of the window.
    void add_to(ImDrawList& list, LayerFrame frame);

    /// Triangles of meshes that a frame may have for its outlines: what the driver draws in some
    /// milliseconds.
    size_t most_outline_triangles() const { return most_triangles_; }

private:
    struct Gl;
    void draw();
    void draw_picture();
    void draw_ground_grid();
    void trace_selection();
    void draw_outline();

    std::unique_ptr<Gl> gl_;
    LayerFrame frame_;
    size_t most_triangles_ = 0;
};

}  // namespace tp
