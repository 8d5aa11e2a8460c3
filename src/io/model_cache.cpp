#include "model_cache.h"

#include <teapath/core/error.h>
#include <teapath/core/log.h>

#include <filesystem>

namespace tp {
namespace {

namespace fs = std::filesystem;

// The thing of the list whose path in its model is that of `path`; null if there is none.
template <class Things, class PathOf>
const auto* part_in(const Things& things, const std::string& path, const PathOf& path_of) {
    const fs::path folder = fs::path(path.substr(0, path.find('#'))).parent_path();
    for (const auto& thing : things) {
        const std::string* own = path_of(thing);
        if (own && (folder / *own).generic_string() == path) return &thing;
    }
    return decltype(&*things.begin()){};
}

}  // namespace

std::shared_ptr<const ModelContent> read_content(const fs::path& file,
                                                 const ModelReadOptions& options) {
    auto content = std::make_shared<ModelContent>(read_model(file, options));
    add_lamps(*content);
    for (const std::string& sentence : content->unsupported)
        log_warning("{}: {}", file.string(), sentence);
    return content;
}

bool names_part(const std::string& path) {
    const size_t mark = path.rfind('#');
    return mark != std::string::npos && can_read_model(path.substr(0, mark));
}

ModelCache::ModelCache(std::string folder, std::string name, const Scene* known,
                       ModelReadOptions options)
    : folder_(std::move(folder)), name_(std::move(name)), options_(std::move(options)) {
    if (!known) return;
    for (const Model& model : known->models)
        if (model.content) contents_[model.path] = model.content;
}

std::shared_ptr<const ModelContent> ModelCache::content(const std::string& path) {
    const auto [entry, is_new] = contents_.try_emplace(path);
    if (!is_new) return entry->second;
    try {
        entry->second = read_content(fs::path(folder_) / path, options_);
    } catch (const Error& error) {
        log_warning("{}: {}; not shown", name_, error.what());
    }
    return entry->second;
}

std::shared_ptr<const Mesh> ModelCache::mesh(const std::string& path) {
    const std::shared_ptr<const ModelContent> model = content(path.substr(0, path.rfind('#')));
    if (!model) return nullptr;
    const Object* object = part_in(model->objects, path, [](const Object& o) {
        const auto* shape = std::get_if<MeshShape>(&o.shape);
        return shape ? &shape->file.path : nullptr;
    });
    if (object) return std::get<MeshShape>(object->shape).file.mesh;
    log_warning("{}: the model has no mesh \"{}\"; not shown", name_, path);
    return nullptr;
}

std::shared_ptr<const Image> ModelCache::image(const std::string& path) {
    const std::shared_ptr<const ModelContent> model = content(path.substr(0, path.rfind('#')));
    if (!model) return nullptr;
    const Texture* texture = part_in(model->textures, path, [](const Texture& t) {
        return t.kind == TextureKind::Image ? &t.file.path : nullptr;
    });
    if (texture) return texture->file.image;
    log_warning("{}: the model has no image \"{}\"; shown as cyan", name_, path);
    return nullptr;
}

}  // namespace tp
