// Where textures may stand: every slot of a material or a texture, with its key in scene files.
#pragma once

#include <teapath/scene/material.h>

#include <type_traits>

namespace tp {

struct Scene;

/// The id in a slot: of a colour or a number that may come from a texture, or the slot itself.
template <class Slot>
auto& texture_in(Slot& slot) {
    if constexpr (std::is_same_v<std::remove_const_t<Slot>, TextureId>)
        return slot;
    else
        return slot.texture;
}

/// Calls f(key, slot) for each slot that a texture has; a slot is a TexturedColor.
template <class AnyTexture, class F>
requires std::is_same_v<std::remove_const_t<AnyTexture>, Texture>
void for_each_slot(AnyTexture& t, F&& f) {
    f("even", t.even);
    f("odd", t.odd);
    f("low", t.low);
    f("high", t.high);
    f("stone", t.stone);
    f("vein", t.vein);
    f("early", t.early);
    f("late", t.late);
    f("brick", t.brick);
    f("mortar", t.mortar);
}

/// True if `inner` stands in a slot of `outer`, or of what stands there, whatever their kinds: put
/// into `inner`, `outer` could come to hold itself.
bool holds(const Scene& scene, TextureId outer, TextureId inner);

/// The two colours, first and second, that a texture of its kind is made of; null where it is of a
/// kind without.
struct TexturePair {
    const TexturedColor* first = nullptr;
    const TexturedColor* second = nullptr;
};
inline TexturePair pair_of(const Texture& t) {
    switch (t.kind) {
        case TextureKind::Checker: return {&t.even, &t.odd};
        case TextureKind::Noise: return {&t.low, &t.high};
        case TextureKind::Marble: return {&t.stone, &t.vein};
        case TextureKind::Wood: return {&t.early, &t.late};
        case TextureKind::Brick: return {&t.brick, &t.mortar};
        case TextureKind::Constant:
        case TextureKind::Image: break;
    }
    return {};
}

/// True if the texture mixes its two colours, so that both are looked up.
inline bool is_blend(TextureKind kind) {
    return kind == TextureKind::Noise || kind == TextureKind::Marble || kind == TextureKind::Wood ||
           kind == TextureKind::Brick;
}

/// Calls f(key, slot) for each slot that a material has, of its kind or not; a slot is a
/// TexturedColor, a TexturedNumber or a TextureId.
template <class AnyMaterial, class F>
requires std::is_same_v<std::remove_const_t<AnyMaterial>, Material>
void for_each_slot(AnyMaterial& m, F&& f) {
    f("color", m.color);
    f("emission", m.emission);
    f("roughness", m.roughness);
    auto& s = m.surface;
    f("metallic", s.metallic);
    f("roughness", s.roughness);
    f("specular", s.specular);
    f("specular_color", s.specular_color);
    f("anisotropy", s.anisotropy);
    f("transmission", s.transmission);
    f("diffuse_transmission", s.diffuse_transmission);
    f("diffuse_transmission_color", s.diffuse_transmission_color);
    f("coat", s.coat);
    f("coat_roughness", s.coat_roughness);
    f("coat_normal", s.coat_normal);
    f("sheen_color", s.sheen_color);
    f("sheen_roughness", s.sheen_roughness);
    f("iridescence", s.iridescence);
    f("iridescence_thickness", s.iridescence_thickness);
    f("normal", s.normal);
    f("bump", s.bump);
}

}  // namespace tp
