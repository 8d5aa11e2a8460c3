#include <teapath/editor/refusal.h>
#include <teapath/scene/texture_uses.h>
#include <teapath/scene/validate.h>

namespace tp {
namespace {

std::string first_fatal(const Scene& probe) {
    for (const Problem& problem : validate(probe))
        if (problem.fatal)
            return problem.remedy.empty() ? problem.what : problem.what + "; " + problem.remedy;
    return {};
}

// The textures are not in the probe.
void forget_textures(auto& thing) {
    for_each_slot(thing, [](const char*, auto& slot) { texture_in(slot) = {}; });
}

}  // namespace

std::string refusal(const std::vector<Object>& objects) {
    Scene probe;
    probe.objects = objects;
    for (Object& o : probe.objects.edit())
        o.material = {};
    return first_fatal(probe);
}

std::string refusal(const std::vector<Material>& materials) {
    Scene probe;
    probe.materials = materials;
    for (Material& m : probe.materials.edit()) {
        m.name.clear();
        forget_textures(m);
    }
    return first_fatal(probe);
}

std::string refusal(const std::vector<Texture>& textures) {
    Scene probe;
    probe.textures = textures;
    for (Texture& t : probe.textures.edit()) {
        t.name.clear();
        forget_textures(t);
    }
    return first_fatal(probe);
}

std::string refusal(const std::vector<Camera>& cameras) {
    Scene probe;
    probe.cameras = cameras;
    for (Camera& c : probe.cameras)
        c.name.clear();
    return first_fatal(probe);
}

std::string refusal(const std::vector<Generator>& generators) {
    Scene probe;
    probe.generators = generators;
    return first_fatal(probe);
}

std::string refusal(const std::vector<Background>& backgrounds) {
    Scene probe;
    for (const Background& background : backgrounds) {
        probe.background = background;
        if (std::string why = first_fatal(probe); !why.empty()) return why;
    }
    return {};
}

std::string refusal(const std::vector<RenderSettings>& settings) {
    Scene probe;
    for (const RenderSettings& render : settings) {
        probe.render = render;
        if (std::string why = first_fatal(probe); !why.empty()) return why;
    }
    return {};
}

std::string refusal(const std::vector<DisplaySettings>& settings) {
    Scene probe;
    for (const DisplaySettings& display : settings) {
        probe.display = display;
        if (std::string why = first_fatal(probe); !why.empty()) return why;
    }
    return {};
}

}  // namespace tp
