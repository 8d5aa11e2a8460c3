#include <teapath/device/pick.h>
#include <teapath/kernel/path_steps.h>

#include <utility>

namespace tp {

PickResult pick(const SceneArrays& arrays, const Double3& origin, const Double3& direction,
                double t_max) {
    SceneView view;
    view.hittables = make_span(arrays.hittables);
    view.nodes = make_span(arrays.nodes);
    view.bounds = arrays.bounds;
    std::vector<MeshView> meshes;
    for (const MeshOfScene& mesh : arrays.meshes)
        meshes.push_back(mesh.arrays->view());
    view.meshes = make_span(std::as_const(meshes));
    view.instances = make_span(arrays.instances);
    PathState path;
    path.origin = Vec3(origin);
    path.direction = Vec3(direction);
    path.t_max = static_cast<Real>(t_max);
    skip_to_scene(view, path);
    const Hit hit = intersect_scene<kFeatureAll>(view, path.origin, path.direction, path.t_max);
    if (hit.index == kNoHit) return {};
    return {{arrays.hittables[hit.index].object}, Double3(path.origin + path.direction * hit.t)};
}

}  // namespace tp
