// Checks of a scene's settings, cameras, background, generators and names.
#include "problem_list.h"

#include <teapath/scene/pose.h>

#include <set>

namespace tp {
namespace {

constexpr int64_t kMaxGenerated = 20'000'000;

void check_render(const RenderSettings& r, ProblemList& problems) {
    const bool width = problems.in_range("render.width", r.width, 1, kMaxImageSide),
               height = problems.in_range("render.height", r.height, 1, kMaxImageSide);
    if (width && height && int64_t{r.width} * r.height > kMaxImagePixels)
        problems.fatal("render", fmt::format("{} x {} pixels are too many", r.width, r.height),
                       "at most 268,435,456, for example 16384 x 16384");
    problems.in_range("render.samples", r.samples, 1, kMaxSamples);
    problems.in_range("render.seconds", r.seconds, 0.0, 1e9);
    problems.in_range("render.time", r.time, 0.0, 1e9);
    problems.in_range("render.denoise_strength", r.denoise_strength, 0.0, 1.0);
    problems.in_range("render.max_depth", r.path.max_depth, 1, kMaxPathDepth);
    problems.in_range("render.roulette_depth", r.path.roulette_depth, 0, kMaxPathDepth);
    problems.in_range("render.tea_rounds", r.path.tea_rounds, 6, 32);
    problems.in_range("render.key_rounds", r.path.key_rounds, 6, 32);
    problems.not_negative("render.clamp_direct", static_cast<double>(r.path.clamp_direct), "limit",
                          "0 switches it off");
    problems.not_negative("render.clamp_indirect", static_cast<double>(r.path.clamp_indirect),
                          "limit", "0 switches it off");
}

void check_view(const Camera& c, const Place& where, ProblemList& problems) {
    const bool finite = problems.finite(where / "look_from", c.look_from) &&
                        problems.finite(where / "look_at", c.look_at) &&
                        problems.finite(where / "up", c.up);
    if (!finite) return;
    const Double3 view = c.look_at - c.look_from;
    const double distance = glm::length(view), up = glm::length(c.up);
    if (!(distance >= ProblemList::kSmallest))
        problems.fatal(where / "look_at", "the camera looks at where it is",
                       "move look_from or look_at");
    else if (!(up >= ProblemList::kSmallest))
        problems.fatal(where / "up", "up has no direction", "take [0, 1, 0]");
    else if (!(glm::length(glm::cross(view / distance, c.up / up)) > 1e-9))
        problems.fatal(where / "up", "up is parallel to the view",
                       "for a view straight down take [0, 0, -1]");
}

void check_film(const Camera& c, const Place& where, ProblemList& problems) {
    const bool is_fisheye = c.projection == ProjectionKind::Fisheye;
    const bool fits = is_fisheye ? c.vertical_fov <= 360 : c.vertical_fov < 180;
    if (!(c.vertical_fov > 0 && fits))
        problems.fatal(where / "vertical_fov",
                       fmt::format("{} degrees is no field of view", c.vertical_fov),
                       is_fisheye ? "above 0, up to 360" : "above 0 and below 180");
    if (!(c.film_height >= ProblemList::kSmallest))
        problems.fatal(where / "film_height",
                       fmt::format("a film {} high shows nothing", c.film_height), "above 0");
    else
        problems.finite(where / "film_height", c.film_height);
    problems.finite(where / "shift", c.shift);
    problems.finite(where / "blade_rotation", c.blade_rotation);
    problems.in_range(where / "blades", c.blades, 0, 32);
}

void check_camera(const Camera& c, const Place& where, ProblemList& problems) {
    check_view(c, where, problems);
    check_film(c, where, problems);
    problems.not_negative(where / "aperture", c.aperture, "aperture", "0 for a pinhole");
    problems.not_negative(where / "focus_distance", c.focus_distance, "focus distance",
                          "0 to focus on look_at");
    problems.not_negative(where / "near_clip", c.near_clip, "distance of the near plane",
                          "0 switches it off");
    if (problems.not_negative(where / "far_clip", c.far_clip, "distance of the far plane",
                              "0 switches it off") &&
        c.far_clip > 0 && c.far_clip <= c.near_clip)
        problems.fatal(where / "far_clip", "the far plane is not beyond the near one",
                       "0 switches it off");
}

void check_display(const DisplaySettings& d, ProblemList& problems) {
    const auto within = [&](const char* where, float value, double low, double high) {
        problems.in_range(where, static_cast<double>(value), low, high);
    };
    within("display.exposure", d.exposure, -64, 64);
    within("display.ev", d.ev, -64, 64);
    within("display.f_number", d.f_number, 0.1, 1000);
    within("display.shutter", d.shutter, 1e-6, 1e6);
    within("display.iso", d.iso, 1, 1e7);
}

void check_sky(const Sky& s, ProblemList& problems) {
    problems.in_range("background.sun_elevation", s.sun_elevation, -90.0, 90.0);
    problems.finite("background.sun_azimuth", s.sun_azimuth);
    problems.in_range("background.latitude", s.latitude, -90.0, 90.0);
    problems.in_range("background.longitude", s.longitude, -180.0, 180.0);
    problems.in_range("background.day", s.day, 1.0, 366.0);
    problems.in_range("background.hour", s.hour, 0.0, 24.0);
    problems.in_range("background.sun_size", s.sun_size, 0.01, 90.0);
    problems.in_range("background.sun_strength", s.sun_strength, 0.0, 1e6);
    problems.in_range("background.haze", s.haze, 0.0, 20.0);
    problems.color("background.ground", s.ground);
}

void check_background(const Background& b, ProblemList& problems) {
    problems.color("background.bottom", b.bottom);
    problems.color("background.top", b.top);
    problems.color("background.color", b.color);
    problems.finite("background.rotation", b.rotation);
    problems.color("background.tint", b.tint);
    problems.color("background.backdrop_color", b.backdrop_color);
    check_sky(b.sky, problems);
    problems.not_negative("background.strength", b.strength, "strength");
    if (b.kind == BackgroundKind::Constant)
        problems.radiance("background", b.color, b.strength);
    else if (b.kind == BackgroundKind::Gradient)
        problems.radiance("background", glm::max(b.bottom, b.top), b.strength);
}

// The number of spheres at most, 0 where the size is a problem.
int64_t check_grid(const SphereGrid& g, const Place& where, ProblemList& problems) {
    const bool sized = problems.in_range(where / "columns", g.columns, 0, 65535) &&
                       problems.in_range(where / "rows", g.rows, 0, 65535);
    problems.finite(where / "spacing", g.spacing);
    problems.finite(where / "center", g.center);
    problems.finite(where / "ground", g.ground);
    problems.finite(where / "jitter", g.jitter);
    if (problems.not_negative(where / "radius", g.radius, "radius") && g.radius == 0)
        problems.warn(where / "radius", "the spheres have radius 0: they are never hit");
    const bool probable = problems.in_range(where / "lambertian", g.lambertian, 0.0, 1.0) &&
                          problems.in_range(where / "metal", g.metal, 0.0, 1.0);
    if (probable && g.lambertian + g.metal > 1 + 1e-9)
        problems.fatal(where / "metal", "the probabilities of the materials add up to more than 1",
                       "lambertian + metal is 1 at most; the rest is glass");
    problems.in_range(where / "ior", g.ior, 0.01, 100.0);
    for (size_t i = 0; i < g.keep_clear.size(); ++i)
        problems.finite((where / "keep_clear")[i], g.keep_clear[i]);
    return sized ? int64_t{g.columns} * g.rows : 0;
}

void check_generators(const Scene& scene, ProblemList& problems) {
    int64_t total = 0;
    for (size_t i = 0; i < scene.generators.size(); ++i) {
        const Place list = "generate", where = list[i];
        const int64_t before = total;
        total += check_grid(scene.generators[i].grid, where, problems);
        if (total > kMaxGenerated && before <= kMaxGenerated)
            problems.fatal(where, "the generators make more than 20 million spheres",
                           "fewer columns or rows");
    }
}

void check_models(const Scene& scene, ProblemList& problems) {
    const Place list = "models";
    for (size_t i = 0; i < scene.models.size(); ++i) {
        const Model& model = scene.models[i];
        const bool is_name = model.animation != kAllAnimations && model.animation != kNoAnimation;
        if (model.content && is_name && playing_animations(model).empty())
            problems.warn(
                list[i] / "animation",
                fmt::format("the model has no animation \"{}\"; it stands still", model.animation));
    }
}

template <class Things>
void check_names(const Things& things, const char* where, ProblemList& problems) {
    std::set<std::string> names;
    for (const auto& thing : things)
        if (!thing.name.empty() && !names.insert(thing.name).second)
            problems.fatal(where, fmt::format("the name \"{}\" is used twice", thing.name),
                           "rename one");
}

}  // namespace

std::vector<Problem> validate(const Scene& scene) {
    ProblemList problems;
    check_render(scene.render, problems);
    check_display(scene.display, problems);
    const Place one = "camera", many = "cameras";
    for (size_t i = 0; i < scene.cameras.size(); ++i)
        check_camera(scene.cameras[i], scene.cameras.size() == 1 ? one : many[i], problems);
    if (scene.active_camera && !find(scene, scene.active_camera))
        problems.fatal("active_camera", "the camera does not exist", "choose another");
    check_background(scene.background, problems);
    check_textures_and_materials(scene, problems);
    check_models(scene, problems);
    check_objects(scene, problems);
    check_generators(scene, problems);
    check_names(scene.cameras, "cameras", problems);
    check_names(scene.materials, "materials", problems);
    check_names(scene.textures, "textures", problems);
    return problems.take();
}

}  // namespace tp
