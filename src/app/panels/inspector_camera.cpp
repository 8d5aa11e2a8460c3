// Inspector of cameras; the options panel shows the same rows for the active one.
#include "inspector.h"

#include <teapath/scene/enum_tables.h>

#include <icons_font_awesome_6.h>

#include <cmath>

namespace tp {
namespace {

constexpr double kDegrees = 180 / 3.14159265358979323846;

// What the direction of view is in the thesis' terms; an edit turns the camera about itself.
void direction_row(PropertyRows<Camera>& rows) {
    const Camera& camera = rows.active();
    const Double3 view = camera.look_at - camera.look_from;
    const double length = glm::length(view);
    if (!(length > 0)) return;
    double angles[2] = {std::atan2(view.x, -view.z) * kDegrees,
                        std::asin(view.y / length) * kDegrees};
    const unsigned changed = ui::row({.name = "Direction",
                                      .help = "Degrees to the right of -z, and above the horizon",
                                      .speed = 0.2,
                                      .low = -180,
                                      .high = 180,
                                      .decimals = 1,
                                      .unit = "\xc2\xb0"},
                                     angles, nullptr, 2);
    if (changed == 0) return;
    const double yaw = angles[0] / kDegrees,
                 pitch = std::min(89.0, std::max(-89.0, angles[1])) / kDegrees;
    const Double3 direction{std::sin(yaw) * std::cos(pitch), std::sin(pitch),
                            -std::cos(yaw) * std::cos(pitch)};
    rows.apply("Direction", true, [&](Camera& c) {
        c.look_at = c.look_from + direction * glm::distance(c.look_at, c.look_from);
    });
}

void film_rows(PropertyRows<Camera>& rows) {
    ProjectionKind projection = rows.active().projection;
    const ProjectionKind standard = rows.standard().projection;
    if (ui::row("Projection", projection, "How directions come onto the film", &standard,
                !rows.is_same([](auto& c) -> auto& { return c.projection; })))
        rows.apply("Projection", false, [&](Camera& c) {
            c.projection = projection;
            if (projection != ProjectionKind::Fisheye)
                c.vertical_fov = std::min(c.vertical_fov, 170.0);
        });
    if (projection == ProjectionKind::Orthographic)
        rows.number(
            {.name = "Height",
             .help = "What the height of the picture shows, in scene units",
             .speed = 0.01,
             .low = 1e-6,
             .high = 1e9,
             .relative = true},
            [](auto& c) -> auto& { return c.film_height; });
    else if (projection != ProjectionKind::Equirectangular)
        rows.number(
            {.name = "Field of view",
             .help = "Vertical angle of the picture; the wheel over the picture changes it too",
             .speed = 0.2,
             .low = 1,
             .high = projection == ProjectionKind::Fisheye ? 360.0 : 170.0,
             .decimals = 1,
             .unit = "\xc2\xb0"},
            [](auto& c) -> auto& { return c.vertical_fov; });
    rows.number(
        {.name = "Shift",
         .help = "Of the film to the right and up, in its width and height",
         .speed = 0.002,
         .low = -100,
         .high = 100},
        [](auto& c) -> auto& { return c.shift; });
}

void lens_rows(PropertyRows<Camera>& rows) {
    rows.number(
        {.name = "Aperture",
         .help = "Diameter of the lens in scene units; 0 is a pinhole, everything sharp",
         .speed = 0.002,
         .low = 0,
         .high = 1e6,
         .relative = true},
        [](auto& c) -> auto& { return c.aperture; });
    if (rows.active().aperture > 0) {
        rows.number(
            {.name = "Blades",
             .help = "Corners of the aperture; below 3 it is round",
             .speed = 0.05,
             .low = 0,
             .high = 32},
            [](auto& c) -> auto& { return c.blades; });
        if (rows.active().blades >= 3)
            rows.number(
                {.name = "Blade rotation",
                 .help = "Counter-clockwise from a corner at the top",
                 .speed = 0.5,
                 .decimals = 1,
                 .unit = "\xc2\xb0"},
                [](auto& c) -> auto& { return c.blade_rotation; });
    }
    rows.number(
        {.name = "Focus distance",
         .help = "Distance of the sharp plane; 0 is the point that is looked at",
         .speed = 0.01,
         .low = 0,
         .high = 1e9,
         .relative = true},
        [](auto& c) -> auto& { return c.focus_distance; });
    rows.number(
        {.name = "Near clip",
         .help = "Hides what is nearer; 0 is off",
         .speed = 0.01,
         .low = 0,
         .high = 1e9,
         .relative = true},
        [](auto& c) -> auto& { return c.near_clip; });
    rows.number(
        {.name = "Far clip",
         .help = "Hides what is farther; 0 is off",
         .speed = 0.05,
         .low = 0,
         .high = 1e9,
         .relative = true},
        [](auto& c) -> auto& { return c.far_clip; });
}

}  // namespace

PropertyRows<Camera> camera_property_rows(PanelContext& c, const std::vector<CameraId>& ids) {
    std::vector<const Camera*> things;
    std::vector<CameraId> known;
    for (const CameraId id : ids)
        if (const Camera* camera = find(c.document.scene(), id)) {
            things.push_back(camera);
            known.push_back(id);
        }
    const std::string what = known.size() == 1 ? item_name(c.document.scene(), item_of(known[0]))
                                               : fmt::format("{} cameras", known.size());
    // A view has no default; what the file has is what one goes back to.
    const Camera* in_file = find(*c.document.history().front().scene, known.back());
    return PropertyRows<Camera>(
        c, what, fmt::format("camera {}", known.back().value), std::move(things),
        [known](Scene& s, size_t i) { return find_camera(s, known[i]); },
        in_file ? *in_file : *find(c.document.scene(), known.back()));
}

void camera_rows(PropertyRows<Camera>& rows) {
    film_rows(rows);
    rows.number(
        {.name = "Position",
         .help = "Where the camera is, in scene units",
         .speed = 0.01,
         .is_axis = true},
        [](auto& c) -> auto& { return c.look_from; });
    rows.number(
        {.name = "Look at",
         .help = "The point in the middle of the picture",
         .speed = 0.01,
         .is_axis = true},
        [](auto& c) -> auto& { return c.look_at; });
    direction_row(rows);
    rows.number(
        {.name = "Up", .help = "What is up in the picture", .speed = 0.01, .is_axis = true},
        [](auto& c) -> auto& { return c.up; });
    lens_rows(rows);
}

void camera_inspector(PanelContext& c, const std::vector<SceneItem>& items) {
    std::vector<CameraId> ids;
    for (const SceneItem item : items)
        ids.push_back({item.id});
    const CameraId shown = ids.back();
    const bool is_active = active_camera(c.document.scene()).id == shown;
    inspector_header(c, items, ICON_FA_VIDEO, is_active ? "Camera, looked through" : "Camera");
    if (!is_active) {
        if (ImGui::Button("Look through it"))
            c.document.edit("Choose camera", "", [&](Scene& s) { s.active_camera = shown; });
        const Camera current = active_camera(c.document.scene());
        ImGui::SameLine();
        if (ImGui::Button("Take the view"))
            c.document.edit("Take the view", "", [&](Scene& s) {
                if (Camera* camera = find_camera(s, shown)) {
                    const Camera before = *camera;
                    *camera = current;
                    camera->id = before.id;
                    camera->name = before.name;
                }
            });
        ui::tooltip("Puts this camera where you look from now");
    }
    const ScenePtr scene = c.document.snapshot();
    PropertyRows<Camera> rows = camera_property_rows(c, ids);
    if (!ui::begin_rows("camera")) return;
    camera_rows(rows);
    ui::end_rows();
}

}  // namespace tp
