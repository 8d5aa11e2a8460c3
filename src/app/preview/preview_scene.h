// The small scene in which a material is shown, and small pictures of textures: values only, no
// window.
#pragma once

#include <teapath/scene/scene.h>

#include <cstdint>
#include <vector>

namespace tp {

/// A ball of the material on a checkered floor under a soft light, `size` pixels square. The scene
/// holds the material and the textures that it uses.
Scene preview_scene(const Scene& scene, const Material& material, int size);

/// The unit square of a texture and of its space, `size` pixels square, as its colours are.
Scene preview_scene(const Scene& scene, const Texture& texture, int size);

/// A number that differs for materials that look different in their preview; names do not count.
uint64_t preview_key(const Scene& scene, const Material& material);
uint64_t preview_key(const Scene& scene, const Texture& texture);

/// RGB bytes of an image, `size` pixels square, the middle of it in its own proportions.
std::vector<uint8_t> image_thumbnail(const Image& image, int size);

}  // namespace tp
