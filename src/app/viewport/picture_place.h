// Where the picture lies in its panel: fitted or zoomed, moved by the user; and the way from a
// point of the screen to one of the picture. Pure functions of numbers.
#pragma once

#include <teapath/core/math.h>

namespace tp {

/// How the user looks at the picture; no part of the scene.
struct PictureView {
    double zoom = 0;      // screen pixels a picture pixel; 0 = as large as the panel allows
    Double2 shift{0, 0};  // of the picture's middle from the panel's, in screen pixels

    friend bool operator==(const PictureView&, const PictureView&) = default;
};

/// A rectangle on the screen.
struct PlaceRect {
    Double2 low{0, 0}, size{0, 0};
};

inline constexpr double kLowestZoom = 1.0 / 16, kHighestZoom = 64;
inline constexpr double kPixelGridZoom = 8;  // from here on the pixels are told apart by lines

/// The zoom that is in force: the user's, or the one that fits a picture of `pixels` into `panel`.
double zoom_in_force(const PictureView& view, const Double2& panel, const Double2& pixels);

/// Where the picture lies in a panel at `low` of size `panel`.
PlaceRect picture_place(const PictureView& view, const Double2& low, const Double2& panel,
                        const Double2& pixels);

/// The view zoomed by `factor` so that the point of the picture under `at`, which is relative to
/// the panel's middle, stays there.
PictureView zoomed(const PictureView& view, double factor, const Double2& at, const Double2& panel,
                   const Double2& pixels);

/// The view moved by screen pixels; some of the picture stays in the panel.
PictureView shifted(const PictureView& view, const Double2& by, const Double2& panel,
                    const Double2& pixels);

/// The point of the picture, in [0, 1]^2 with (0, 0) at its top left, that a point of the screen
/// shows; beyond that range outside.
Double2 picture_point(const PlaceRect& place, const Double2& at);

}  // namespace tp
