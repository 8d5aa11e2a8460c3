#include <teapath/device/pick.h>
#include <teapath/kernel/camera_ray.h>
#include <teapath/kernel/traverse.h>

namespace tp {

PickResult pick(const SceneArrays& arrays, double x, double y) {
    SceneView view;
    view.hittables = make_span(arrays.hittables);
    view.nodes = make_span(arrays.nodes);
    CameraRecord camera = arrays.camera;
    camera.lens_radius = 0;
    const CameraRay ray =
        camera_ray(camera, {static_cast<Real>(x), static_cast<Real>(y)}, 1, 1, {0, 0});
    const Hit hit = intersect_scene<kFeatureAll>(view, ray.origin, ray.direction, ray.t_max);
    if (hit.index == kNoHit) return {};
    return {{arrays.hittables[hit.index].object}, Double3(ray.origin + ray.direction * hit.t)};
}

}  // namespace tp
