// The meshes of the selection in GL: a vertex array with positions and indices, uploaded when a
// mesh is first drawn and freed when it no longer is.
#pragma once

#include <teapath/scene/mesh.h>

#include <cstdint>
#include <map>
#include <memory>

namespace tp {

class OutlineMeshes {
public:
    OutlineMeshes() = default;
    ~OutlineMeshes() { clear(); }
    OutlineMeshes(const OutlineMeshes&) = delete;
    OutlineMeshes& operator=(const OutlineMeshes&) = delete;

    /// Draws the triangles with the program in use; attribute 0 is the position in the mesh's own
    /// space. Binds its vertex array.
    void draw(const std::shared_ptr<const Mesh>& mesh);
    /// Frees the meshes that were not drawn since the last call.
    void end_frame();
    void clear();

    size_t size() const { return entries_.size(); }

private:
    struct Entry {
        std::shared_ptr<const Mesh> mesh;  // its address is the key: kept
        unsigned vertices = 0, buffers[2] = {0, 0};
        uint64_t last_used = 0;  // frame
    };
    static void upload(Entry& entry);
    static void free(const Entry& entry);

    std::map<const Mesh*, Entry> entries_;
    uint64_t frame_ = 0;
};

}  // namespace tp
