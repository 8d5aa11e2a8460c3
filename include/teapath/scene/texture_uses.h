// Where textures may stand: every slot of a material or a texture, with its key in scene files.
#pragma once

#include <teapath/scene/material.h>

#include <type_traits>

namespace tp {

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
}

}  // namespace tp
