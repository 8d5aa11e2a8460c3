// The lights of a model as objects that shine: small balls, disks, and a far sun.
#include <teapath/scene/model.h>

#include <algorithm>
#include <cmath>

namespace tp {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kLampShare = 0.01;   // radius of a lamp, of the model's
constexpr double kSunDistance = 50;   // of a directional light, in radii of the model
constexpr double kSunDegrees = 0.27;  // radius of the sun in the sky

struct Surroundings {
    Double3 center{0, 0, 0};
    double radius = 1;
};

// The shape that shines and its radiance for an intensity or an illuminance of 1.
struct Lamp {
    Shape shape;
    double radiance = 1;
};

Lamp lamp_of(const ModelLight& light, const Surroundings& around) {
    const Double3 position(light.world_from_light[3]);
    const Double3 forward = -glm::normalize(Double3(light.world_from_light[2]));
    const double radius = kLampShare * around.radius;
    // A surface of radiance L and area A has the intensity L A along its normal; a ball L pi r^2.
    const double area = kPi * radius * radius;
    switch (light.kind) {
        case ModelLight::Kind::Point: return {SphereShape{position, radius}, 1 / area};
        case ModelLight::Kind::Spot: return {DiskShape{position, forward, radius}, 1 / area};
        case ModelLight::Kind::Directional: break;
    }
    // A disk of the half angle a, seen head-on, gives the illuminance L pi sin^2 a.
    const double distance = kSunDistance * around.radius, angle = kSunDegrees * kPi / 180;
    return {DiskShape{around.center - forward * distance, forward, distance * std::tan(angle)},
            1 / (kPi * std::sin(angle) * std::sin(angle))};
}

}  // namespace

void add_lamps(ModelContent& content) {
    if (content.lights.empty()) return;
    Surroundings around;
    const auto [low, high] = box_of(content.objects);
    around.center = (low + high) * 0.5;
    around.radius = std::max(glm::distance(low, high) / 2, 1e-6);
    for (const ModelLight& light : content.lights) {
        if (!(light.intensity > 0) || !(glm::determinant(light.world_from_light) != 0)) continue;
        const Lamp lamp = lamp_of(light, around);
        Material material;
        material.id = {static_cast<uint32_t>(content.materials.size()) + 1};
        material.name = light.name.empty() ? "light" : light.name;
        material.kind = MaterialKind::DiffuseLight;
        material.emission.color = light.color;
        material.strength = light.intensity * lamp.radiance;
        if (light.kind == ModelLight::Kind::Spot) {
            material.spot_angle = std::clamp(2 * light.outer_cone, 0.1, 180.0);
            material.spot_blend =
                light.outer_cone > 0 ? std::clamp(1 - light.inner_cone / light.outer_cone, 0.0, 1.0)
                                     : 0;
        }
        material.part.path = "light:" + light.part.path;
        Object object;
        object.id = {static_cast<uint32_t>(content.objects.size()) + 1};
        object.name = material.name;
        object.shape = lamp.shape;
        object.material = material.id;
        object.part.path = "light:" + light.part.path;
        content.materials.push_back(std::move(material));
        content.objects.push_back(std::move(object));
    }
}

}  // namespace tp
