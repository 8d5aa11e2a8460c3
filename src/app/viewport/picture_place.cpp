#include "picture_place.h"

#include <algorithm>

namespace tp {
namespace {

// Keeps at least a margin of the picture in the panel.
Double2 limited_shift(const Double2& shift, double zoom, const Double2& panel,
                      const Double2& pixels) {
    const Double2 margin = glm::min(Double2(32), panel * 0.5);
    const Double2 reach = glm::max(Double2(0), (panel + pixels * zoom) * 0.5 - margin);
    return glm::clamp(shift, -reach, reach);
}

}  // namespace

double zoom_in_force(const PictureView& view, const Double2& panel, const Double2& pixels) {
    if (view.zoom > 0) return std::clamp(view.zoom, kLowestZoom, kHighestZoom);
    if (!(pixels.x > 0) || !(pixels.y > 0)) return 1;
    return std::max(1e-6, std::min(panel.x / pixels.x, panel.y / pixels.y));
}

PlaceRect picture_place(const PictureView& view, const Double2& low, const Double2& panel,
                        const Double2& pixels) {
    const double zoom = zoom_in_force(view, panel, pixels);
    const Double2 size = pixels * zoom;
    const Double2 shift =
        view.zoom > 0 ? limited_shift(view.shift, zoom, panel, pixels) : Double2(0, 0);
    // Whole pixels, so that a picture at zoom 1 is shown as it is.
    return {glm::round(low + (panel - size) * 0.5 + shift), size};
}

PictureView zoomed(const PictureView& view, double factor, const Double2& at, const Double2& panel,
                   const Double2& pixels) {
    const double before = zoom_in_force(view, panel, pixels);
    const double after = std::clamp(before * factor, kLowestZoom, kHighestZoom);
    const Double2 shift = view.zoom > 0 ? view.shift : Double2(0, 0);
    return {after, limited_shift(at - (at - shift) * (after / before), after, panel, pixels)};
}

PictureView shifted(const PictureView& view, const Double2& by, const Double2& panel,
                    const Double2& pixels) {
    const double zoom = zoom_in_force(view, panel, pixels);
    const Double2 shift = view.zoom > 0 ? view.shift : Double2(0, 0);
    return {zoom, limited_shift(shift + by, zoom, panel, pixels)};
}

Double2 picture_point(const PlaceRect& place, const Double2& at) {
    return (at - place.low) / glm::max(place.size, Double2(1e-9));
}

}  // namespace tp
