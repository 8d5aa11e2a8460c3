// What is done to a model of the scene as a whole.
#pragma once

#include <teapath/scene/scene.h>

#include <string>
#include <vector>

namespace tp {

/// The model with that id, or null.
const Model* find(const Scene& scene, ModelId id);

/// The objects of the model that the scene has, in its order.
std::vector<ObjectId> objects_of(const Scene& scene, ModelId id);

/// Places the model; its objects go along with what was changed of each.
void place_model(Scene& scene, ModelId id, const Transform& transform);

/// What of its objects could not stand there, in words for the user; empty: nothing.
std::string refusal_of_place(const Scene& scene, ModelId id, const Transform& transform);

/// Removes the model with its objects, and with its materials and textures but those that other
/// things use: these become the scene's own.
void delete_model(Scene& scene, ModelId id);

/// Adds the model once more, as its file has it, in the same place; returns the new one.
ModelId duplicate_model(Scene& scene, ModelId id);

}  // namespace tp
