// What a file dropped on the window becomes: the scene, a background, the colour of a material.
#include "dialogs.h"
#include "file_question.h"

#include <teapath/editor/scene_edits.h>

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>

namespace tp {
namespace {

namespace fs = std::filesystem;

bool is_over_viewport(const PanelContext& c) {
    const ImGuiWindow* window = ImGui::FindWindowByName("Viewport");
    return c.ui.preferences.is_panel_open("Viewport") && window && window->WasActive &&
           window->Rect().Contains(ImGui::GetMousePos());
}

// The selected objects' materials, or the selected materials.
std::vector<MaterialId> target_materials(const Document& document) {
    std::vector<MaterialId> found;
    for (const SceneItem item : document.selected_items()) {
        if (item.kind == ItemKind::Material) found.push_back({item.id});
        if (item.kind != ItemKind::Object) continue;
        if (const Object* object = find(document.scene(), ObjectId{item.id}))
            found.push_back(object->material);
    }
    return found;
}

void set_background(PanelContext& c, const ImageFile& image) {
    c.document.edit("Background image", "", [&](Scene& s) {
        s.background.kind = BackgroundKind::Image;
        s.background.file = image;
    });
}

void set_textures(PanelContext& c, const std::vector<MaterialId>& materials,
                  const ImageFile& image) {
    c.document.edit("Colour image", "", [&](Scene& s) {
        const TextureId texture = add_texture(s, TextureKind::Image);
        Texture* made = find_texture(s, texture);
        made->file = image;
        for (const MaterialId id : materials)
            if (Material* material = find_material(s, id)) {
                // A light's picture is what it sends out.
                TexturedColor& slot = material->kind == MaterialKind::DiffuseLight
                                          ? material->emission
                                          : material->color;
                slot.texture = texture;
            }
    });
}

void drop_image(PanelContext& c, const fs::path& file) {
    const std::vector<MaterialId> materials = target_materials(c.document);
    if (materials.empty() && !is_over_viewport(c)) {
        c.toast(fmt::format("Drop {} on the picture for a background, or select an object first",
                            file.filename().string()),
                true);
        return;
    }
    read_image_then(c, file, [file, materials](PanelContext& p, const ImageFile& image) {
        if (materials.empty())
            set_background(p, image);
        else
            set_textures(p, materials, image);
        p.toast(fmt::format("{} is now {}", file.filename().string(),
                            materials.empty() ? "the background" : "the colour"));
    });
}

}  // namespace

void drop_file(PanelContext& c, const fs::path& file) {
    const std::string name = file.filename().string();
    std::error_code ignored;
    if (fs::is_directory(file, ignored)) {
        c.toast(fmt::format("{} is a folder; drop a scene (.json), a model or an image", name),
                true);
    } else if (scene_filters().front().passes(file)) {
        ask_first(c, "opening " + name, [file](PanelContext& p) { open_scene(p, file); });
    } else if (model_filters().front().passes(file)) {
        open_model(c, file);
    } else if (texture_filters().front().passes(file)) {
        drop_image(c, file);
    } else {
        c.toast(
            fmt::format(
                "{} is no scene (.json), model (.glb, .gltf, .obj, .ply, .stl) or image that can "
                "be read",
                name),
            true);
    }
}

}  // namespace tp
