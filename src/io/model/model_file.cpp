#include "../file_extension.h"
#include "../gltf/gltf_read.h"
#include "../mesh/mesh_readers.h"
#include "../obj/obj_model.h"
#include "../whole_file.h"
#include "model_progress.h"
#include "unique_names.h"

#include <teapath/core/error.h>
#include <teapath/io/mesh_file.h>
#include <teapath/io/model_file.h>

#include <utility>

namespace tp {
namespace fs = std::filesystem;

namespace {

constexpr uintmax_t kMaxFileBytes = uintmax_t{1} << 36;
constexpr const char* kKinds = "a model (.gltf, .glb, .obj, .ply, .stl)";

// A file that holds one mesh and no materials: one object of light grey.
ModelContent content_of(Mesh mesh, const fs::path& file) {
    ModelContent content;
    Material material;
    material.id = MaterialId{1};
    material.kind = MaterialKind::Principled;
    material.name = material.part.path = "default";
    material.color.color = Double3(0.8);
    content.materials.push_back(std::move(material));

    Object object;
    object.id = ObjectId{1};
    object.name = object.part.path = path_piece(file.stem().string());
    MeshShape shape;
    shape.file = {file.filename().string() + "#mesh", share(std::move(mesh))};
    object.shape = std::move(shape);
    object.material = MaterialId{1};
    content.objects.push_back(std::move(object));
    return content;
}

}  // namespace

bool can_read_model(const fs::path& file) {
    const std::string extension = lower_extension(file);
    return extension == ".gltf" || extension == ".glb" || can_read_mesh(file);
}

ModelContent read_model(const fs::path& file, const ModelReadOptions& options) {
    if (!can_read_model(file))
        throw Error(ErrorKind::Input, "this is not a model that can be read", file.string(),
                    "known: .gltf, .glb, .obj, .ply, .stl");
    ModelSource source;
    source.name = file.string();
    source.folder = file.parent_path();
    source.allow_outside = options.allow_outside;
    source.progress = options.progress;
    const std::string extension = lower_extension(file);
    std::string bytes = read_whole_file(file, kKinds, kMaxFileBytes);
    if (extension == ".gltf" || extension == ".glb") return read_gltf(std::move(bytes), source);
    if (extension == ".obj") return read_obj_model(bytes, source);
    ModelProgress progress(source);
    progress.begin(1, 1);
    return content_of(
        extension == ".ply" ? read_ply(bytes, source.name) : read_stl(bytes, source.name), file);
}

}  // namespace tp
