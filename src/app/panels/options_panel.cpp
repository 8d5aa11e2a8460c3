// Settings of the camera, of sampling and of the display; all of them are in the scene file.
#include "../widgets.h"
#include "panels.h"

#include <teapath/editor/scene_edits.h>
#include <teapath/scene/enum_tables.h>

#include <imgui.h>

namespace tp {
namespace {

void draw_camera(PanelContext& c) {
    Camera camera = active_camera(c.document.scene());
    const Camera standard;
    bool changed = false;
    if (ui::begin_rows("camera")) {
        changed |= ui::row(
            "Field of view", camera.vertical_fov, standard.vertical_fov, 0.2, 1, 170,
            "%.1f\xc2\xb0",
            "Vertical angle of the picture. The mouse wheel over the picture changes it too.");
        changed |= ui::row("Position", camera.look_from, standard.look_from, 0.02, "%.2f",
                           "Where the camera is, in scene units");
        changed |= ui::row("Look at", camera.look_at, standard.look_at, 0.02, "%.2f",
                           "The point in the middle of the picture");
        changed |= ui::row("Up", camera.up, standard.up, 0.01, "%.2f", "What is up in the picture");
        changed |= ui::row("Aperture", camera.aperture, 0.0, 0.002, 0, 1e6, "%.3f",
                           "Diameter of the lens in scene units; 0 is a pinhole, everything sharp");
        changed |= ui::row("Focus distance", camera.focus_distance, 0.0, 0.02, 0, 1e6, "%.2f",
                           "Distance of the sharp plane; 0 is the point looked at");
        changed |= ui::row("Near clip", camera.near_clip, 0.0, 0.02, 0, 1e6, "%.2f",
                           "Hides what is nearer; 0 is off");
        changed |= ui::row("Far clip", camera.far_clip, 0.0, 0.1, 0, 1e6, "%.1f",
                           "Hides what is farther; 0 is off");
        ui::end_rows();
    }
    const bool valid =
        glm::length(glm::cross(camera.look_at - camera.look_from, camera.up)) > 1e-6 &&
        (camera.far_clip == 0 || camera.far_clip > camera.near_clip);
    if (changed && valid)
        c.document.edit("Change camera", "camera", [&](Scene& s) {
            if (Camera* target = find_camera(s, camera.id)) *target = camera;
        });
}

void draw_sampling(PanelContext& c) {
    RenderSettings render = c.document.scene().render;
    const RenderSettings standard;
    PathSettings& path = render.path;
    bool changed = false;
    if (ui::begin_rows("sampling")) {
        changed |= ui::row("Samples", render.samples, 1024, 1, 1 << 24,
                           "Samples of each pixel before the render rests");
        changed |= ui::row("Integrator", path.integrator, "What is computed along a path");
        changed |= ui::row("Max depth", path.max_depth, standard.path.max_depth, 1, 4096,
                           "Path segments: 1 is emission seen by the camera, 2 is direct light");
        changed |= ui::row("Roulette from", path.roulette_depth, standard.path.roulette_depth, 0,
                           4096, "Segments before Russian roulette starts; 0 is never");
        changed |= ui::row("Light sampling", path.light_sampling,
                           "Aim at the lights from every surface, weighed against scattering");
        changed |= ui::row("Sampler", path.sampler, "Where random numbers come from");
        changed |= ui::row("TEA rounds", path.tea_rounds, standard.path.tea_rounds, 6, 32,
                           "Quality of the random numbers against speed; 6 is enough for paths");
        if (path.integrator == IntegratorKind::Book)
            changed |= ui::row("Scatter rule", path.scatter,
                               "How Lambertian surfaces scatter in the book's integrator");
        int seed = static_cast<int>(path.seed & 0x7fffffff);
        if (ui::row("Seed", seed, 0, 0, 0x7fffffff, "One picture for each seed")) {
            path.seed = static_cast<uint64_t>(seed);
            changed = true;
        }
        changed |=
            ui::row("File width", render.width, standard.width, 1, 16384,
                    "Pixels of a picture that is rendered to a file; the window follows its panel");
        changed |=
            ui::row("File height", render.height, standard.height, 1, 16384,
                    "Pixels of a picture that is rendered to a file; the window follows its panel");
        ui::end_rows();
    }
    if (changed)
        c.document.edit("Change settings", "settings", [&](Scene& s) { s.render = render; });
}

void draw_display(PanelContext& c) {
    DisplaySettings display = c.document.scene().display;
    bool changed = false;
    if (ui::begin_rows("display")) {
        changed |= ui::row("Exposure", display.exposure, 0.0f, 0.02f, -16.0f, 16.0f, "%.2f EV",
                           "Stops; the render goes on");
        changed |= ui::row("Tone curve", display.curve, "From radiance to what the screen shows");
        ui::end_rows();
    }
    if (changed)
        c.document.edit("Change display", "display", [&](Scene& s) { s.display = display; });
}

void draw_background(PanelContext& c) {
    Background background = c.document.scene().background;
    bool changed = false;
    if (ui::begin_rows("background")) {
        changed |= ui::row("Kind", background.kind, "What lies beyond the scene, and lights it");
        if (background.kind == BackgroundKind::Gradient) {
            changed |= ui::row_color("Top", background.top, "Colour straight up");
            changed |= ui::row_color("Bottom", background.bottom, "Colour straight down");
        } else if (background.kind == BackgroundKind::Constant) {
            changed |= ui::row_color("Colour", background.color, "Radiance from everywhere");
        } else {
            ui::row_text("Image", background.file.path);
            changed |= ui::row("Rotation", background.rotation, 0.0, 0.5, -360, 360, "%.1f\xc2\xb0",
                               "About the vertical axis");
        }
        changed |= ui::row("Strength", background.strength, 1.0, 0.01, 0, 1e6, "%.2f",
                           "Multiplies the radiance");
        ui::end_rows();
    }
    if (changed)
        c.document.edit("Change background", "background",
                        [&](Scene& s) { s.background = background; });
}

}  // namespace

void draw_options(PanelContext& c) {
    if (begin_panel(c, "Options")) {
        if (ui::section("Camera")) draw_camera(c);
        if (ui::section("Sampling")) draw_sampling(c);
        if (ui::section("Display")) draw_display(c);
        if (ui::section("Background")) draw_background(c);
    }
    ImGui::End();
}

}  // namespace tp
