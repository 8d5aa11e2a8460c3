// Rows of what may come from a texture: a colour, a number, a normal. The field or the texture's
// name, and a menu of textures.
#pragma once

#include "property_rows.h"

namespace tp {

/// The texture's name for people.
std::string texture_name(const Scene& scene, TextureId id);

/// The icon of textures of a kind.
const char* texture_icon(TextureKind kind);

/// A small picture of the texture: cells and colours are drawn, an image is its thumbnail, other
/// patterns are rendered.
void draw_thumbnail(PanelContext& c, const Texture& t, float size);

/// What a row changed; a new texture is one edit of its own.
struct SlotChange {
    bool value = false;                      // the colour or the number was edited
    bool texture = false;                    // another texture or channel, or none
    std::optional<TextureKind> new_texture;  // to be made and put in the slot
    bool is_data = false;                    // the slot reads numbers: a new image is linear
};

SlotChange row_slot(PanelContext& c, const ui::NumberRow& r, TexturedColor& value,
                    const TexturedColor& standard, bool mixed, TextureId not_this);
SlotChange row_slot(PanelContext& c, const ui::NumberRow& r, TexturedNumber& value,
                    const TexturedNumber& standard, bool mixed, TextureId not_this);
SlotChange row_slot(PanelContext& c, const ui::NumberRow& r, TextureId& value,
                    const TextureId& standard, bool mixed, TextureId not_this);

/// The row of a slot of any kind of thing that has one. Of `r`, colours and normals use the name
/// and the help. `not_this` is left out of the menu, and what holds it: no texture holds itself.
template <class Thing, class Get>
void slot(PropertyRows<Thing>& rows, const ui::NumberRow& r, const Get& get,
          TextureId not_this = {}) {
    auto value = get(rows.active());
    PanelContext& c = rows.context();
    const SlotChange change =
        row_slot(c, r, value, get(rows.standard()), !rows.is_same(get), not_this);
    if (change.value || change.texture)
        rows.apply(r.name, change.value && !change.texture,
                   [&](Thing& thing) { get(thing) = value; });
    if (!change.new_texture) return;
    TextureId made;
    c.document.edit(fmt::format("New texture for {}", r.name), "", [&](Scene& s) {
        made = add_texture(s, *change.new_texture);
        if (change.is_data) find_texture(s, made)->color_space = ColorSpace::Linear;
        rows.each(s, [&](Thing& thing) { texture_in(get(thing)) = made; });
    });
    c.document.select(item_of(made));
}

}  // namespace tp
