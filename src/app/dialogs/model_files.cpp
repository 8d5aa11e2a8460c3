// Meshes and models from files, as parts of the scene.
#include "../fly_camera.h"
#include "../place_in_view.h"
#include "dialogs.h"
#include "file_question.h"
#include "path_in_scene.h"

#include <teapath/editor/scene_edits.h>
#include <teapath/io/mesh_file.h>
#include <teapath/io/scene_file.h>
#include <teapath/scene/procedural_mesh.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace tp {
namespace {

namespace fs = std::filesystem;

// Stands a box where the view looks, a power of ten smaller or larger if its own size is out of all
// proportion to that, else as large as the file has it.
Transform placed_in_view(const Scene& scene, const Double3& low, const Double3& high) {
    const Place place = place_in_view(scene);
    const double seen = seen_height(active_camera(scene), place.distance) / 2;
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

// `path` is the mesh's in the scene.
void add_mesh(PanelContext& c, const std::string& path, const std::string& name,
              const std::shared_ptr<const Mesh>& mesh) {
    ObjectId made;
    c.document.edit(fmt::format("Add {}", name), "", [&](Scene& s) {
        const Transform transform = placed_in_view(s, Double3(mesh->low), Double3(mesh->high));
        ShapeKind kind = shape_kinds().back();
        kind.shape = MeshShape{{path, mesh}, true, DoubleMat3(1)};
        made = add_object(s, kind, transform.translation, 1);
        Object* object = find_object(s, made);
        object->transform = transform;
        object->name.clear();
        rename_item(s, item_of(made), name);
    });
    c.document.select(made);
    c.toast(fmt::format("{}: {} triangles", name, mesh->triangles.size()));
}

// The models' objects are part of the scene from here on; its cameras follow those that are there.
void add_model_in_view(PanelContext& c, const fs::path& file, Model model) {
    const std::shared_ptr<const ModelContent> content = model.content;
    ModelId made;
    c.document.edit(fmt::format("Add {}", model.name), "", [&](Scene& s) {
        const auto [low, high] = box_of(content->objects);
        model.path = path_in_scene(s, file);
        model.transform = placed_in_view(s, low, high);
        made = add_model(s, model);
        rename_item(s, item_of(made), model.name);
        for (const Camera& camera : content->cameras)
            add_camera(s, camera);
    });
    c.document.select(item_of(made));
    c.toast(fmt::format("{}: {} objects", file.filename().string(), content->objects.size()));
}

bool holds_one_mesh(const fs::path& file) {
    return FileFilter{"", {".ply", ".stl"}}.passes(file);
}

// A scene that nobody has touched gives way to the model.
bool is_fresh(const Document& document) {
    return document.file().empty() && !document.is_modified() && document.scene().objects.empty();
}

void read_mesh_then_add(PanelContext& c, const fs::path& file) {
    JobOptions options;
    options.title = fmt::format("Reading {}", file.filename().string());
    c.ui.jobs.start(std::move(options), [file](JobControl&) -> JobFinish {
        const std::shared_ptr<const Mesh> mesh = share(read_mesh(file));
        return [file, mesh](PanelContext& p) {
            add_mesh(p, path_in_scene(p.document.scene(), file), file.stem().string(), mesh);
        };
    });
}

// Makes the mesh of a recipe in a job, then does `then` with it.
void make_mesh_then(PanelContext& c, const std::string& recipe,
                    std::function<void(PanelContext&, const std::shared_ptr<const Mesh>&)> then) {
    JobOptions options;
    options.title = "Making a mesh";
    c.ui.jobs.start(std::move(options), [recipe, then](JobControl&) -> JobFinish {
        const std::shared_ptr<const Mesh> mesh = share(procedural_mesh(recipe));
        return [then, mesh](PanelContext& p) { then(p, mesh); };
    });
}

}  // namespace

ModelReadOptions reading_in(JobControl& control) {
    ModelReadOptions options;
    options.progress = [&control](double share) {
        control.set_progress(share, "");
        return !control.is_cancelled();
    };
    return options;
}

std::vector<FileFilter> model_filters() {
    return {{"Models", {".glb", ".gltf", ".obj", ".ply", ".stl"}}, {"All files", {}}};
}

void open_model(PanelContext& c, const fs::path& file) {
    if (is_fresh(c.document)) return open_scene(c, file);
    if (holds_one_mesh(file)) return read_mesh_then_add(c, file);
    JobOptions options;
    options.title = fmt::format("Reading {}", file.filename().string());
    c.ui.jobs.start(std::move(options), [file](JobControl& control) -> JobFinish {
        const Model model = load_model(file, reading_in(control));
        if (control.is_cancelled()) return nullptr;
        return [file, model](PanelContext& p) { add_model_in_view(p, file, model); };
    });
}

void make_mesh(PanelContext& c, const std::string& recipe, const std::string& label) {
    make_mesh_then(c, recipe, [recipe, label](PanelContext& p, const auto& mesh) {
        add_mesh(p, recipe, label, mesh);
    });
}

void change_mesh(PanelContext& c, const std::vector<ObjectId>& objects, const std::string& recipe) {
    make_mesh_then(c, recipe, [recipe, objects](PanelContext& p, const auto& mesh) {
        p.document.edit("Change mesh", "", [&](Scene& s) {
            for (const ObjectId id : objects)
                if (Object* object = find_object(s, id))
                    if (auto* shape = std::get_if<MeshShape>(&object->shape))
                        shape->file = {recipe, mesh};
        });
    });
}

void ask_for_model(PanelContext& c) {
    FileQuestion question;
    question.title = "Add a model";
    question.accept = "Add";
    question.filters = model_filters();
    question.purpose = "model";
    question.suggestion = fs::path(c.document.scene().origin.folder);
    question.then = [](PanelContext& p, const fs::path& file) { open_model(p, file); };
    ask_for_file(c, std::move(question));
}

}  // namespace tp
