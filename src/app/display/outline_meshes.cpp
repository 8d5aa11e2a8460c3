#include "outline_meshes.h"

#include <glad/gl.h>

namespace tp {

void OutlineMeshes::upload(Entry& entry) {
    const auto& positions = entry.mesh->positions;
    const auto& triangles = entry.mesh->triangles;
    glCreateVertexArrays(1, &entry.vertices);
    glCreateBuffers(2, entry.buffers);
    glNamedBufferStorage(entry.buffers[0],
                         static_cast<GLsizeiptr>(positions.size() * sizeof positions[0]),
                         positions.data(), 0);
    glNamedBufferStorage(entry.buffers[1],
                         static_cast<GLsizeiptr>(triangles.size() * sizeof triangles[0]),
                         triangles.data(), 0);
    glVertexArrayVertexBuffer(entry.vertices, 0, entry.buffers[0], 0, sizeof positions[0]);
    glVertexArrayElementBuffer(entry.vertices, entry.buffers[1]);
    glVertexArrayAttribFormat(entry.vertices, 0, 3, GL_FLOAT, GL_FALSE, 0);
    glVertexArrayAttribBinding(entry.vertices, 0, 0);
    glEnableVertexArrayAttrib(entry.vertices, 0);
}

void OutlineMeshes::free(const Entry& entry) {
    glDeleteVertexArrays(1, &entry.vertices);
    glDeleteBuffers(2, entry.buffers);
}

void OutlineMeshes::draw(const std::shared_ptr<const Mesh>& mesh) {
    if (!mesh || mesh->triangles.empty()) return;
    Entry& entry = entries_[mesh.get()];
    if (!entry.mesh) {
        entry.mesh = mesh;
        upload(entry);
    }
    entry.last_used = frame_;
    glBindVertexArray(entry.vertices);
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * mesh->triangles.size()), GL_UNSIGNED_INT,
                   nullptr);
}

void OutlineMeshes::end_frame() {
    std::erase_if(entries_, [this](const auto& item) {
        const bool goes = item.second.last_used != frame_;
        if (goes) free(item.second);
        return goes;
    });
    ++frame_;
}

void OutlineMeshes::clear() {
    for (const auto& [mesh, entry] : entries_)
        free(entry);
    entries_.clear();
}

}  // namespace tp
