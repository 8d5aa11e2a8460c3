// Inspector of models: their file, what came of it, and where the whole stands.
#include "inspector.h"

#include <teapath/editor/model_edits.h>
#include <teapath/scene/pose.h>

#include <icons_font_awesome_6.h>

#include <algorithm>
#include <set>

namespace tp {
namespace {

struct ModelFigures {
    size_t objects = 0, materials = 0, textures = 0, triangles = 0, stored_triangles = 0;
};

ModelFigures figures_of(const Scene& scene, ModelId id) {
    ModelFigures f;
    std::set<const Mesh*> meshes;
    for (const Object& object : scene.objects) {
        if (object.part.model != id) continue;
        ++f.objects;
        const auto* shape = std::get_if<MeshShape>(&object.shape);
        if (!shape || !shape->file.mesh) continue;
        f.triangles += shape->file.mesh->triangles.size();
        if (meshes.insert(shape->file.mesh.get()).second)
            f.stored_triangles += shape->file.mesh->triangles.size();
    }
    for (const Material& material : scene.materials)
        if (material.part.model == id) ++f.materials;
    for (const Texture& texture : scene.textures)
        if (texture.part.model == id) ++f.textures;
    return f;
}

// The figures of the model that was shown last; objects are walked where it is another one or the
// scene has changed.
struct KnownFigures {
    ScenePtr scene;
    ModelId model;
    ModelFigures figures;
    std::vector<ObjectId> objects;
};

const KnownFigures& known_figures(PanelContext& c, const ScenePtr& scene, ModelId id) {
    KnownFigures& known = c.ui.local.get<KnownFigures>();
    if (known.scene != scene || known.model != id)
        known = {scene, id, figures_of(*scene, id), objects_of(*scene, id)};
    return known;
}

void figure_rows(const Model& model, const ModelFigures& f) {
    ui::row_text("File", model.content ? model.path : model.path + " (missing)");
    ui::row_text("Objects", fmt::format("{}", f.objects));
    ui::row_text("Triangles",
                 f.triangles == f.stored_triangles
                     ? fmt::format("{}", f.triangles)
                     : fmt::format("{} of {} stored", f.triangles, f.stored_triangles));
    ui::row_text("Materials", fmt::format("{}", f.materials));
    ui::row_text("Textures", fmt::format("{}", f.textures));
    if (!model.content) return;
    for (const std::string& sentence : model.content->unsupported)
        ui::row_text("Left out", sentence);
}

void transform_rows(PanelContext& c, const Model& model) {
    Transform t = model.transform;
    const Transform standard;
    const bool moved = ui::row({.name = "Position",
                                .help = "Where the model's origin is, in scene units",
                                .speed = 0.01,
                                .is_axis = true},
                               t.translation, standard.translation);
    const bool turned = ui::row({.name = "Rotation",
                                 .help = "Degrees about the world's x, then y, then z axis",
                                 .speed = 0.5,
                                 .decimals = 1,
                                 .unit = "\xc2\xb0",
                                 .is_axis = true},
                                t.rotation, standard.rotation);
    const bool scaled = ui::row({.name = "Scale",
                                 .help = "Along the model's own axes; negative mirrors",
                                 .speed = 0.01,
                                 .is_axis = true},
                                t.scale, standard.scale);
    if (!moved && !turned && !scaled) return;
    if (const std::string why = refusal_of_place(c.document.scene(), model.id, t); !why.empty())
        return say_refusal(c, why);
    const char* what = moved ? "Position" : turned ? "Rotation" : "Scale";
    c.document.edit(fmt::format("{} of {}", what, model.name),
                    fmt::format("model {} {}", model.id.value, what),
                    [&](Scene& s) { place_model(s, model.id, t); });
}

void animation_row(PanelContext& c, const Model& model) {
    if (!model.content || !model.content->motion) return;
    std::vector<std::string> labels = {"All", "None"}, names = {kAllAnimations, kNoAnimation};
    for (const Animation& animation : model.content->motion->animations) {
        labels.push_back(fmt::format("{} ({:.2f} s)", animation.name, animation.length));
        names.push_back(animation.name);
    }
    const auto now = std::find(names.begin(), names.end(), model.animation);
    int index = now == names.end() ? -1 : static_cast<int>(now - names.begin());
    if (!ui::row_choice("Animation", index, labels, "What of the model file plays", 0)) return;
    c.document.edit(fmt::format("Animation of {}", model.name), "", [&](Scene& s) {
        for (Model& m : s.models.edit())
            if (m.id == model.id) m.animation = names[static_cast<size_t>(index)];
    });
}

}  // namespace

void model_inspector(PanelContext& c, const std::vector<SceneItem>& items) {
    const ScenePtr scene = c.document.snapshot();
    const Model* model = find(*scene, ModelId{items.back().id});
    if (!model) return;
    inspector_header(c, items, ICON_FA_CUBES, "Model");
    const KnownFigures& known = known_figures(c, scene, model->id);
    if (ui::begin_rows("model")) {
        transform_rows(c, *model);
        animation_row(c, *model);
        figure_rows(*model, known.figures);
        ui::end_rows();
    }
    const std::vector<ObjectId>& ids = known.objects;
    if (ui::button("Select its objects", !ids.empty(), "None of them is left")) {
        std::vector<SceneItem> objects;
        for (const ObjectId id : ids)
            objects.push_back(item_of(id));
        c.document.select_items(objects);
    }
}

}  // namespace tp
