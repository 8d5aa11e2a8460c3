// Whether a scene may hold things as an edit would leave them: the checks of a whole scene
// (scene/validate.h), asked about a few things at a time.
#pragma once

#include <teapath/scene/scene.h>

#include <string>
#include <vector>

namespace tp {

/// Why these cannot be in a scene, in a few words; empty if they can. References to materials and
/// textures are not looked at.
std::string refusal(const std::vector<Object>& objects);
std::string refusal(const std::vector<Material>& materials);
std::string refusal(const std::vector<Texture>& textures);
std::string refusal(const std::vector<Camera>& cameras);
std::string refusal(const std::vector<Generator>& generators);
std::string refusal(const std::vector<Background>& backgrounds);
std::string refusal(const std::vector<RenderSettings>& settings);
std::string refusal(const std::vector<DisplaySettings>& settings);

}  // namespace tp
