#include <teapath/device/albedo_arrays.h>
#include <teapath/device/host_view.h>
#include <teapath/device/srgb_table.h>

namespace tp {

SceneView host_view(const SceneArrays& arrays, std::vector<MeshView>& meshes) {
    meshes.clear();
    for (const MeshOfScene& mesh : arrays.meshes)
        meshes.push_back(mesh.arrays->view());
    SceneView view;
    view.hittables = make_span(arrays.hittables);
    view.nodes = make_span(arrays.nodes);
    view.meshes = {meshes.data(), static_cast<uint32_t>(meshes.size())};
    view.instances = make_span(arrays.instances);
    view.placements = make_span(arrays.placements);
    view.lights = make_span(arrays.lights);
    view.light_nodes = make_span(arrays.light_nodes);
    view.materials = make_span(arrays.materials);
    view.material_ids = make_span(arrays.material_ids);
    view.principled = make_span(arrays.principled);
    if (needs_albedo_tables(arrays)) view.albedo_tables = albedo_arrays().view();
    view.textures = make_span(arrays.textures);
    view.texels = reinterpret_cast<const unsigned char*>(arrays.texels.data());
    view.srgb_table = srgb_table().data();
    view.background = arrays.background;
    if (arrays.environment) view.environment = arrays.environment->view();
    view.bounds = arrays.bounds;
    view.brute_force = arrays.brute_force;
    return view;
}

}  // namespace tp
