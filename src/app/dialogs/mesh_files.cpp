// Meshes from files, as objects of the scene.
#include "../place_in_view.h"
#include "dialogs.h"
#include "file_question.h"
#include "path_in_scene.h"

#include <teapath/editor/scene_edits.h>
#include <teapath/io/mesh_file.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tp {
namespace {

namespace fs = std::filesystem;

// Stands the mesh where the view looks, a quarter of its height large if its own size is out of
// all proportion to that, else as large as the file has it.
Transform placed_in_view(const Scene& scene, const Mesh& mesh) {
    const Place place = place_in_view(scene);
    const double half = active_camera(scene).vertical_fov / 2 * 3.14159265358979323846 / 180;
    const double seen = place.distance * std::tan(half);
    const Double3 low = mesh.low, high = mesh.high;
    const double size = std::max(glm::length(high - low), 1e-9);
    const bool fits = size > 0.05 * seen && size < 2 * seen;
    const double scale = fits ? 1 : std::pow(10, std::round(std::log10(0.5 * seen / size)));
    Transform t;
    t.scale = Double3(scale);
    // The middle of its underside comes to the place.
    const Double3 foot((low.x + high.x) / 2, low.y, (low.z + high.z) / 2);
    t.translation = place.point - foot * scale;
    return t;
}

void add_mesh(PanelContext& c, const fs::path& file, const std::shared_ptr<const Mesh>& mesh) {
    ObjectId made;
    const std::string name = file.stem().string();
    c.document.edit(fmt::format("Add {}", name), "", [&](Scene& s) {
        const Transform transform = placed_in_view(s, *mesh);
        ShapeKind kind = shape_kinds().back();
        kind.shape = MeshShape{{path_in_scene(s, file), mesh}, true, DoubleMat3(1)};
        made = add_object(s, kind, transform.translation, 1);
        Object* object = find_object(s, made);
        object->transform = transform;
        object->name.clear();
        rename_item(s, item_of(made), name);
    });
    c.document.select(made);
    c.toast(fmt::format("{}: {} triangles", file.filename().string(), mesh->triangles.size()));
}

}  // namespace

std::vector<FileFilter> mesh_filters() {
    return {{"Meshes", {".ply", ".obj", ".stl"}}, {"All files", {}}};
}

void open_mesh(PanelContext& c, const fs::path& file) {
    JobOptions options;
    options.title = fmt::format("Reading {}", file.filename().string());
    c.ui.jobs.start(std::move(options), [file](JobControl&) -> JobFinish {
        const std::shared_ptr<const Mesh> mesh = share(read_mesh(file));
        return [file, mesh](PanelContext& p) { add_mesh(p, file, mesh); };
    });
}

void ask_for_mesh(PanelContext& c) {
    FileQuestion question;
    question.title = "Add a mesh";
    question.accept = "Add";
    question.filters = mesh_filters();
    question.purpose = "mesh";
    question.suggestion = fs::path(c.document.scene().origin.folder);
    question.then = [](PanelContext& p, const fs::path& file) { open_mesh(p, file); };
    ask_for_file(c, std::move(question));
}

}  // namespace tp
