#include <teapath/scene/camera_path.h>

#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace tp {
namespace {

// Catmull-Rom spline between b and c, with a before and d after them.
template <class T>
T spline(const T& a, const T& b, const T& c, const T& d, double u) {
    return b + (c - a) * (0.5 * u) + (a - b * 2.5 + c * 2.0 - d * 0.5) * (u * u) +
           ((b - c) * 1.5 + (d - a) * 0.5) * (u * u * u);
}

}  // namespace

std::vector<Camera> bookmark_cameras(const Scene& scene) {
    std::vector<Camera> found;
    for (int n = 1; n <= 9; ++n) {
        const std::string name = fmt::format("bookmark {}", n);
        const auto camera = std::find_if(scene.cameras.begin(), scene.cameras.end(),
                                         [&](const Camera& c) { return c.name == name; });
        if (camera != scene.cameras.end()) found.push_back(*camera);
    }
    return found;
}

Camera camera_on_path(const std::vector<Camera>& keys, double t) {
    const auto last = static_cast<double>(keys.size() - 1);
    const double at = std::clamp(t, 0.0, 1.0) * last;
    const auto i = static_cast<size_t>(std::min(std::floor(at), std::max(0.0, last - 1)));
    const double u = at - static_cast<double>(i);
    const auto key = [&](size_t n) -> const Camera& { return keys[std::min(n, keys.size() - 1)]; };
    const Camera &a = key(i == 0 ? 0 : i - 1), &b = key(i), &c = key(i + 1), &d = key(i + 2);

    Camera camera = keys.front();
    camera.look_from = spline(a.look_from, b.look_from, c.look_from, d.look_from, u);
    camera.look_at = spline(a.look_at, b.look_at, c.look_at, d.look_at, u);
    const Double3 up = spline(a.up, b.up, c.up, d.up, u);
    camera.up = glm::length(up) > 1e-9 ? glm::normalize(up) : b.up;
    // Sizes that must stay positive do not overshoot.
    const auto between = [&](double from, double to) { return from + (to - from) * u; };
    camera.vertical_fov = between(b.vertical_fov, c.vertical_fov);
    camera.aperture = between(b.aperture, c.aperture);
    camera.focus_distance = b.focus_distance == 0 && c.focus_distance == 0
                                ? 0
                                : between(effective_focus_distance(b), effective_focus_distance(c));
    return camera;
}

Camera camera_on_turntable(const Camera& camera, double turns) {
    constexpr double kFullTurn = 2 * 3.14159265358979323846;
    const DoubleMat4 turn =
        glm::rotate(DoubleMat4(1), turns * kFullTurn, glm::normalize(camera.up));
    Camera turned = camera;
    turned.look_from =
        camera.look_at + Double3(turn * Double4(camera.look_from - camera.look_at, 0));
    return turned;
}

}  // namespace tp
