// How large a scene or a selection is, for framing, for the speed of flying and for the gizmo's
// place. Pure functions of the document's values.
#pragma once

#include <teapath/editor/scene_edits.h>

#include <optional>
#include <vector>

namespace tp {

/// A sphere around the objects; none for none of them.
std::optional<Extent> extent_of(const std::vector<const Object*>& objects);

/// The objects of the selection that the scene has, in its order.
std::vector<const Object*> selected_objects(const Scene& scene,
                                            const std::vector<ObjectId>& selection);

/// A sphere around what is visible of the scene but the ground: objects five times as large as all
/// the smaller ones together are left out where they are not the most.
std::optional<Extent> extent_of_all(const Scene& scene);

/// A speed of flying that crosses what there is to see in some seconds, in scene units a second.
double natural_speed(const Scene& scene);

}  // namespace tp
