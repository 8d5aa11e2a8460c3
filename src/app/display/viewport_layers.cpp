#include "viewport_layers.h"

#include "../fly_camera.h"
#include "../viewport/projection.h"
#include "gl_program.h"
#include "outline_meshes.h"

#include <glad/gl.h>
#include <glm/gtc/type_ptr.hpp>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

namespace tp {
namespace {

constexpr float kOutlineColor[3] = {232 / 255.0f, 163 / 255.0f, 61 / 255.0f};
constexpr GLsizei kQuadVertices = 6, kCubeVertices = 36;

// A rectangle of whole pixels of the framebuffer, from its top left.
struct PixelRect {
    int x = 0, y = 0, width = 0, height = 0;

    bool empty() const { return width < 1 || height < 1; }
};

// What is seen of the picture.
PixelRect visible(const LayerFrame& frame, const Double2& framebuffer) {
    const Double2 low = glm::max(glm::max(frame.panel.low, frame.picture.low), Double2(0));
    const Double2 high = glm::min(
        glm::min(frame.panel.low + frame.panel.size, frame.picture.low + frame.picture.size),
        framebuffer);
    const auto x = static_cast<int>(std::floor(low.x)), y = static_cast<int>(std::floor(low.y));
    return {x, y, static_cast<int>(std::ceil(high.x)) - x, static_cast<int>(std::ceil(high.y)) - y};
}

// As the shaders know it.
struct alignas(16) GpuPart {
    glm::mat4 clip_from_unit;
    glm::vec4 eye_in_unit;  // w 1: where rays start; w 0: where they all go
    glm::uvec4 form;
};

GpuPart gpu_part(const OutlinePart& part, const DoubleMat4& clip_from_world, const Double4& eye) {
    GpuPart result;
    result.clip_from_unit = glm::mat4(clip_from_world * part.world_from_unit);
    result.eye_in_unit = glm::vec4(0);
    if (part.form == OutlineForm::Ball)
        result.eye_in_unit = glm::vec4(glm::inverse(part.world_from_unit) * eye);
    result.form = glm::uvec4(static_cast<uint32_t>(part.form));
    return result;
}

// Clip space of the picture to that of the rectangle that is seen of it.
DoubleMat4 clip_from_picture(const PlaceRect& picture, const PixelRect& seen) {
    const Double2 low(seen.x, seen.y), size(seen.width, seen.height);
    const Double2 scale = picture.size / size;
    const Double2 shift = ((picture.low - low) * 2.0 + picture.size) / size - Double2(1);
    DoubleMat4 matrix(1);
    matrix[0][0] = scale.x;
    matrix[1][1] = scale.y;
    matrix[3][0] = shift.x;
    matrix[3][1] = -shift.y;
    return matrix;
}

// Balls and boxes are drawn with the cube as their bounds, flat forms with its square, meshes as
// they are: in this order.
int rank(OutlineForm form) {
    return form == OutlineForm::Mesh ? 2 : form > OutlineForm::Ball ? 1 : 0;
}

}  // namespace

// Objects of GL; the textures of the selection have the size of what is seen.
struct ViewportLayers::Gl {
    Gl() {
        glCreateVertexArrays(1, &vertices);
        glCreateBuffers(1, &parts);
        glCreateFramebuffers(1, &framebuffer);
    }
    ~Gl() {
        glDeleteTextures(2, textures);
        glDeleteFramebuffers(1, &framebuffer);
        glDeleteBuffers(1, &parts);
        glDeleteVertexArrays(1, &vertices);
    }
    Gl(const Gl&) = delete;
    Gl& operator=(const Gl&) = delete;

    void resize(int new_width, int new_height) {
        if (width == new_width && height == new_height) return;
        width = new_width;
        height = new_height;
        glDeleteTextures(2, textures);
        glCreateTextures(GL_TEXTURE_2D, 2, textures);
        glTextureStorage2D(textures[0], 1, GL_R32UI, width, height);
        glTextureStorage2D(textures[1], 1, GL_DEPTH_COMPONENT32F, width, height);
        glTextureParameteri(textures[0], GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTextureParameteri(textures[0], GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        glNamedFramebufferTexture(framebuffer, GL_COLOR_ATTACHMENT0, textures[0], 0);
        glNamedFramebufferTexture(framebuffer, GL_DEPTH_ATTACHMENT, textures[1], 0);
    }

    GlProgram picture{"quad.vert", "picture.frag"};
    GlProgram ground_grid{"quad.vert", "ground_grid.frag"};
    GlProgram selection{"selection.vert", "selection.frag"};
    GlProgram selection_mesh{"selection_mesh.vert", "selection.frag"};
    GlProgram outline{"quad.vert", "outline.frag"};
    OutlineMeshes meshes;
    unsigned vertices = 0;  // none: the shaders know them
    unsigned parts = 0, framebuffer = 0;
    unsigned textures[2] = {0, 0};  // object of each pixel, depth
    int width = 0, height = 0;      // of the textures
    // Of the frame that is being drawn.
    Double2 window{0, 0};
    PixelRect seen;

    // Draws over a rectangle of the window; a program is in use.
    void draw_quad(const PlaceRect& place) const {
        const Double2 low = place.low / window * 2.0 - Double2(1);
        const Double2 high = (place.low + place.size) / window * 2.0 - Double2(1);
        glUniform4f(0, static_cast<float>(low.x), static_cast<float>(-low.y),
                    static_cast<float>(high.x), static_cast<float>(-high.y));
        glDrawArrays(GL_TRIANGLES, 0, kQuadVertices);
    }
};

ViewportLayers::ViewportLayers() : gl_(std::make_unique<Gl>()) {
    const std::string_view renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    const bool is_software =
        renderer.find("llvmpipe") != renderer.npos || renderer.find("softpipe") != renderer.npos;
    most_triangles_ = is_software ? 250'000 : 1'000'000;
}
ViewportLayers::~ViewportLayers() = default;

void ViewportLayers::add_to(ImDrawList& list, LayerFrame frame) {
    frame_ = std::move(frame);
    std::stable_sort(frame_.selection.begin(), frame_.selection.end(),
                     [](const auto& a, const auto& b) { return rank(a.form) < rank(b.form); });
    list.AddCallback(
        [](const ImDrawList*, const ImDrawCmd* command) {
            static_cast<ViewportLayers*>(command->UserCallbackData)->draw();
        },
        this);
    list.AddCallback(ImGui::GetPlatformIO().DrawCallback_ResetRenderState, nullptr);
}

void ViewportLayers::draw() {
    GLint viewport[4];
    glGetIntegerv(GL_VIEWPORT, viewport);
    gl_->window = Double2(viewport[2], viewport[3]);
    gl_->seen = visible(frame_, gl_->window);
    const PixelRect& seen = gl_->seen;
    if (seen.empty()) return;
    glBindVertexArray(gl_->vertices);
    const bool is_straight = keeps_lines_straight(frame_.camera);
    const bool has_outline = is_straight && !frame_.selection.empty();
    if (has_outline) trace_selection();
    gl_->meshes.end_frame();
    glScissor(seen.x, viewport[3] - seen.y - seen.height, seen.width, seen.height);
    if (frame_.texture) draw_picture();
    if (frame_.has_ground_grid && is_straight) draw_ground_grid();
    if (has_outline) draw_outline();
}

void ViewportLayers::draw_picture() {
    glUseProgram(gl_->picture.id());
    glBindSampler(0, 0);
    glBindTextureUnit(0, static_cast<unsigned>(frame_.texture));
    glUniform1i(1, frame_.is_nearest);
    glUniform1i(2, frame_.has_pixel_grid);
    gl_->draw_quad(frame_.picture);
}

void ViewportLayers::draw_ground_grid() {
    const Camera& camera = frame_.camera;
    const FilmPlane film = film_plane(camera, frame_.picture.size.x / frame_.picture.size.y);
    const glm::mat3 over_film(glm::vec3(film.right), glm::vec3(film.down), glm::vec3(film.corner));
    const bool is_parallel = camera.projection == ProjectionKind::Orthographic;
    const glm::mat3 along(glm::vec3(0), glm::vec3(0), glm::vec3(axes_of(camera).forward));

    // Between fine lines: a power of ten, so that some ten of them are near the camera's foot.
    const Double3 eye = camera.look_from;
    const double range = is_parallel ? camera.film_height / 2 : std::abs(eye.y);
    const double level = std::log10(std::max(range, 1e-6));
    const double step = std::pow(10.0, std::floor(level));
    const Double2 foot(eye.x, eye.z);
    const Double2 rest = foot - glm::floor(foot / (100 * step)) * (100 * step);

    glUseProgram(gl_->ground_grid.id());
    const glm::vec3 place(eye);
    glUniform3fv(1, 1, glm::value_ptr(place));
    glUniformMatrix3fv(2, 1, GL_FALSE, glm::value_ptr(is_parallel ? along : over_film));
    glUniformMatrix3fv(8, 1, GL_FALSE, glm::value_ptr(is_parallel ? over_film : glm::mat3(0)));
    glUniform1f(5, static_cast<float>(step));
    glUniform1f(6, static_cast<float>(level - std::floor(level)));
    glUniform2f(7, static_cast<float>(rest.x), static_cast<float>(rest.y));
    gl_->draw_quad(frame_.picture);
}

void ViewportLayers::trace_selection() {
    const PixelRect& seen = gl_->seen;
    const Double4 eye = frame_.camera.projection == ProjectionKind::Perspective
                            ? Double4(frame_.camera.look_from, 1)
                            : Double4(axes_of(frame_.camera).forward, 0);
    const double aspect = frame_.picture.size.x / frame_.picture.size.y;
    const DoubleMat4 clip =
        clip_from_picture(frame_.picture, seen) * clip_from_world(frame_.camera, aspect);
    std::vector<GpuPart> parts;
    parts.reserve(frame_.selection.size());
    for (const OutlinePart& part : frame_.selection)
        parts.push_back(gpu_part(part, clip, eye));
    glNamedBufferData(gl_->parts, static_cast<GLsizeiptr>(parts.size() * sizeof(GpuPart)),
                      parts.data(), GL_STREAM_DRAW);
    const auto count_of = [&](int wanted) {
        return static_cast<GLsizei>(
            std::count_if(frame_.selection.begin(), frame_.selection.end(),
                          [wanted](const OutlinePart& part) { return rank(part.form) == wanted; }));
    };
    const GLsizei solids = count_of(0), flats = count_of(1);

    GLint before = 0, viewport[4];
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &before);
    glGetIntegerv(GL_VIEWPORT, viewport);
    gl_->resize(seen.width, seen.height);
    glBindFramebuffer(GL_FRAMEBUFFER, gl_->framebuffer);
    glViewport(0, 0, seen.width, seen.height);
    glScissor(0, 0, seen.width, seen.height);
    glDisable(GL_BLEND);
    glEnable(GL_DEPTH_TEST);
    const GLuint none[4] = {0, 0, 0, 0};
    const GLfloat far[1] = {1};
    glClearBufferuiv(GL_COLOR, 0, none);
    glClearBufferfv(GL_DEPTH, 0, far);
    glUseProgram(gl_->selection.id());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, gl_->parts);
    glUniform1i(0, 0);
    glDrawArraysInstanced(GL_TRIANGLES, 0, kCubeVertices, solids);
    glUniform1i(0, solids);
    glDrawArraysInstanced(GL_TRIANGLES, 0, kQuadVertices, flats);
    glUseProgram(gl_->selection_mesh.id());
    for (size_t i = static_cast<size_t>(solids + flats); i < parts.size(); ++i) {
        glUniform1i(0, static_cast<GLint>(i));
        gl_->meshes.draw(frame_.selection[i].mesh);
    }
    glBindVertexArray(gl_->vertices);
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_BLEND);
    glBindFramebuffer(GL_FRAMEBUFFER, static_cast<unsigned>(before));
    glViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
}

void ViewportLayers::draw_outline() {
    const PixelRect& seen = gl_->seen;
    glUseProgram(gl_->outline.id());
    glBindSampler(0, 0);
    glBindTextureUnit(0, gl_->textures[0]);
    glUniform2i(1, seen.x, static_cast<int>(gl_->window.y) - seen.y - seen.height);
    glUniform1i(2, std::max(1, static_cast<int>(std::lround(frame_.scale))));
    glUniform3fv(3, 1, kOutlineColor);
    gl_->draw_quad({Double2(seen.x, seen.y), Double2(seen.width, seen.height)});
}

}  // namespace tp
