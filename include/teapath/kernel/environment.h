// Sampling of an environment image: a cell of its latitude-longitude grid by two alias tables, of
// rows and within the row, then a point of the cell (Pharr, Jakob, Humphreys, "Physically Based
// Rendering", 4th edition, 12.5; their tables are by inversion).
#pragma once

#include <teapath/core/frame.h>
#include <teapath/kernel/background.h>

namespace tp {

struct EnvironmentSample {
    Vec3 direction;
    Real pdf;  // over solid angle; 0: nothing was found
};

/// The column of `table` that `u` picks; `u` becomes a number of its own in [0, 1).
TP_HD uint32_t pick_cell(const EnvironmentCell* table, uint32_t count, Real& u) {
    const Real scaled = u * static_cast<Real>(count);
    const uint32_t column = min(static_cast<uint32_t>(scaled), count - 1);
    const EnvironmentCell& cell = table[column];
    const Real rest = min(scaled - static_cast<Real>(column), kOneMinusEpsilon);
    if (rest < cell.alias_threshold) {
        u = min(rest / cell.alias_threshold, kOneMinusEpsilon);
        return column;
    }
    u = min((rest - cell.alias_threshold) / (1 - cell.alias_threshold), kOneMinusEpsilon);
    return cell.alias;
}

/// Density over solid angle of a point in that cell, at that height.
TP_HD Real cell_pdf(const EnvironmentView& view, uint32_t column, uint32_t row, Real sine) {
    if (!(sine > 0)) return 0;
    const Real cells = static_cast<Real>(view.width) * static_cast<Real>(view.height);
    return view.rows[row].probability * view.cells[row * view.width + column].probability * cells /
           (2 * kPi * kPi * sine);
}

/// A direction of the image by the light that comes from it.
TP_HD EnvironmentSample sample_image(const EnvironmentView& view,
                                     const BackgroundRecord& background, Vec2 u) {
    const uint32_t row = pick_cell(view.rows.data, view.height, u.y);
    const uint32_t column = pick_cell(view.cells.data + row * view.width, view.width, u.x);
    const Real phi = (static_cast<Real>(column) + u.x) / static_cast<Real>(view.width) * 2 * kPi;
    const Real theta = (static_cast<Real>(row) + u.y) / static_cast<Real>(view.height) * kPi;
    const Real sine = std::sin(theta);
    const Vec3 turned{sine * std::sin(phi), std::cos(theta), -sine * std::cos(phi)};
    return {{turned.x * background.cos_rotation + turned.z * background.sin_rotation, turned.y,
             turned.z * background.cos_rotation - turned.x * background.sin_rotation},
            cell_pdf(view, column, row, sine)};
}

/// Density over solid angle of sample_image.
TP_HD Real image_pdf(const EnvironmentView& view, const BackgroundRecord& background,
                     Vec3 direction) {
    const Vec3 d = turned_to_image(background, direction);
    const Vec2 uv = equirectangular_uv(d);
    const uint32_t column =
        min(static_cast<uint32_t>(uv.x * static_cast<Real>(view.width)), view.width - 1);
    const uint32_t row =
        min(static_cast<uint32_t>(uv.y * static_cast<Real>(view.height)), view.height - 1);
    return cell_pdf(view, column, row, safe_sqrt(1 - d.y * d.y));
}

/// A direction to the disk of the sun, uniform over solid angle.
TP_HD Vec3 sample_sun(const BackgroundRecord& background, Vec2 u) {
    const Real away = u.x * background.sun_chord2 / 2;  // 1 - cosine
    const Real sine = safe_sqrt(away * (2 - away));
    const Real phi = 2 * kPi * u.y;
    return normalize(frame_around(background.sun_direction)
                         .to_world({sine * std::cos(phi), sine * std::sin(phi), 1 - away}));
}

/// Density with which sample_environment gives that direction.
TP_HD Real environment_pdf(const EnvironmentView& view, const BackgroundRecord& background,
                           Vec3 direction) {
    const Real share = background.sun_probability;
    const Real pdf = share < 1 ? (1 - share) * image_pdf(view, background, direction) : Real(0);
    if (!(share > 0) || !meets_sun(background, direction)) return pdf;
    return pdf + share / (kPi * background.sun_chord2);
}

/// A direction by the light that comes from it, of image and sun.
TP_HD EnvironmentSample sample_environment(const EnvironmentView& view,
                                           const BackgroundRecord& background, Vec2 u) {
    const Real share = background.sun_probability;
    if (u.x < share) {
        const Vec3 d = sample_sun(background, {u.x / share, u.y});
        return {d, environment_pdf(view, background, d)};
    }
    u.x = min((u.x - share) / (1 - share), kOneMinusEpsilon);
    EnvironmentSample sample = sample_image(view, background, u);
    sample.pdf *= 1 - share;
    if (share > 0 && meets_sun(background, sample.direction))
        sample.pdf += share / (kPi * background.sun_chord2);
    return sample;
}

}  // namespace tp
