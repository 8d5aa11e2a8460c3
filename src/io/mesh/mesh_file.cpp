#include "../file_extension.h"
#include "../whole_file.h"
#include "mesh_readers.h"

#include <teapath/core/error.h>
#include <teapath/io/mesh_file.h>

namespace tp {
namespace fs = std::filesystem;

namespace {

constexpr uintmax_t kMaxFileBytes = uintmax_t{1} << 36;
constexpr const char* kKinds = "a mesh (.ply, .stl, .obj)";

}  // namespace

bool can_read_mesh(const fs::path& file) {
    const std::string extension = lower_extension(file);
    return extension == ".ply" || extension == ".stl" || extension == ".obj";
}

Mesh read_mesh(const fs::path& file) {
    if (!can_read_mesh(file))
        throw Error(ErrorKind::Input, "this is not a mesh that can be read", file.string(),
                    "known: .ply, .stl, .obj");
    const std::string bytes = read_whole_file(file, kKinds, kMaxFileBytes);
    const std::string extension = lower_extension(file);
    if (extension == ".ply") return read_ply(bytes, file.string());
    if (extension == ".stl") return read_stl(bytes, file.string());
    return read_obj(bytes, file.string());
}

}  // namespace tp
