// The parts of the inspector, one file each: the rows of a kind of thing.
#pragma once

#include "property_rows.h"

namespace tp {

void object_inspector(PanelContext& c, const std::vector<SceneItem>& items);
void generator_inspector(PanelContext& c, const std::vector<SceneItem>& items);
void camera_inspector(PanelContext& c, const std::vector<SceneItem>& items);
void material_inspector(PanelContext& c, const std::vector<SceneItem>& items);
void texture_inspector(PanelContext& c, const std::vector<SceneItem>& items);
void model_inspector(PanelContext& c, const std::vector<SceneItem>& items);
void background_inspector(PanelContext& c);

/// The rows of the shape, where all have the same kind.
void shape_rows(PropertyRows<Object>& rows);

/// Rows of cameras; the options panel has them too.
PropertyRows<Camera> camera_property_rows(PanelContext& c, const std::vector<CameraId>& ids);
void camera_rows(PropertyRows<Camera>& rows);

/// Rows of the materials with those ids.
void material_rows(PanelContext& c, const std::vector<MaterialId>& ids);

/// The rows of noise, marble, wood or brick, where all have the same kind.
void pattern_rows(PropertyRows<Texture>& rows);

/// The rows of a principled surface but its colour.
void principled_rows(PropertyRows<Material>& rows);

/// What is selected: its picture or icon, its name to edit, and what it is.
void inspector_header(PanelContext& c, const std::vector<SceneItem>& items, const char* icon,
                      const std::string& kind);

/// A row with an image file: its name, and a button that opens another.
void row_image(PanelContext& c, const char* name, const char* help, const ImageFile& file,
               SceneItem owner);

}  // namespace tp
