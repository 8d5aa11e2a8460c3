// The parts of the inspector, one file each: the rows of a kind of thing.
#pragma once

#include "property_rows.h"

namespace tp {

void object_inspector(PanelContext& c, const std::vector<SceneItem>& items);
void generator_inspector(PanelContext& c, const std::vector<SceneItem>& items);
void camera_inspector(PanelContext& c, const std::vector<SceneItem>& items);
void material_inspector(PanelContext& c, const std::vector<SceneItem>& items);
void texture_inspector(PanelContext& c, const std::vector<SceneItem>& items);
void background_inspector(PanelContext& c);

/// The rows of the shape, where all have the same kind.
void shape_rows(PropertyRows<Object>& rows);

/// Rows of cameras; the options panel has them too.
PropertyRows<Camera> camera_property_rows(PanelContext& c, const std::vector<CameraId>& ids);
void camera_rows(PropertyRows<Camera>& rows);

/// Rows of the materials with those ids.
void material_rows(PanelContext& c, const std::vector<MaterialId>& ids);

/// What is selected: its picture or icon, its name to edit, and what it is.
void inspector_header(PanelContext& c, const std::vector<SceneItem>& items, const char* icon,
                      const std::string& kind);

/// A colour that may come from a texture: colour field, or the texture's name, and the menu of
/// textures. Returns true if `value` was changed; a new texture is one edit of its own.
struct TexturedColorChange {
    bool color = false;                      // the colour was edited
    bool texture = false;                    // another texture, or none
    std::optional<TextureKind> new_texture;  // to be made and put in the slot
};
TexturedColorChange row_textured_color(PanelContext& c, const char* name, const char* help,
                                       TexturedColor& value, const TexturedColor& standard,
                                       bool mixed, TextureId not_this = {});

/// The row of a colour with a texture slot, for any kind of thing that has one.
template <class Thing, class Get>
void textured_color(PropertyRows<Thing>& rows, const char* name, const char* help,
                    const TexturedColor& standard, const Get& get, TextureId not_this = {}) {
    TexturedColor value = get(rows.active());
    const TexturedColorChange change = row_textured_color(rows.context(), name, help, value,
                                                          standard, !rows.is_same(get), not_this);
    if (change.color || change.texture)
        rows.apply(name, change.color && !change.texture,
                   [&](Thing& thing) { get(thing) = value; });
    if (!change.new_texture) return;
    PanelContext& c = rows.context();
    c.document.edit(fmt::format("New texture for {}", name), "", [&](Scene& s) {
        value.texture = add_texture(s, *change.new_texture);
        rows.each(s, [&](Thing& thing) { get(thing).texture = value.texture; });
    });
    c.document.select(item_of(value.texture));
}

/// A row with an image file: its name, and a button that opens another.
void row_image(PanelContext& c, const char* name, const char* help, const ImageFile& file,
               SceneItem owner);

}  // namespace tp
