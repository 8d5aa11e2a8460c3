#include "gltf_lights.h"

#include "../model/unique_names.h"
#include "gltf_value.h"

#include <teapath/core/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace tp {
namespace {

constexpr double kDegrees = 180 / 3.14159265358979323846;

// The middle of the box around all objects.
Double3 middle_of(const ModelContent& content) {
    constexpr double kFar = std::numeric_limits<double>::infinity();
    Double3 low(kFar), high(-kFar);
    for (const Object& object : content.objects) {
        const auto& shape = std::get<MeshShape>(object.shape);
        const DoubleMat4 world = world_from_object(object.transform) * DoubleMat4(shape.placement);
        const Mesh& mesh = *shape.file.mesh;
        for (int corner = 0; corner < 8; ++corner) {
            const Double4 p((corner & 1) ? mesh.high.x : mesh.low.x,
                            (corner & 2) ? mesh.high.y : mesh.low.y,
                            (corner & 4) ? mesh.high.z : mesh.low.z, 1);
            low = glm::min(low, Double3(world * p));
            high = glm::max(high, Double3(world * p));
        }
    }
    return content.objects.empty() ? Double3(0) : (low + high) * 0.5;
}

Double3 direction(const DoubleMat4& world, int axis) {
    const Double3 column(world[axis]);
    const double length = glm::length(column);
    if (length > 0) return column / length;
    Double3 unit(0);
    unit[axis] = 1;
    return unit;
}

// False if the camera has no film.
bool set_projection(const tinygltf::Camera& source, Camera& camera) {
    if (source.type == "orthographic") {
        camera.projection = ProjectionKind::Orthographic;
        camera.film_height = 2 * std::abs(source.orthographic.ymag);
        return camera.film_height > 1e-9 && camera.film_height < 1e12;
    }
    camera.vertical_fov = source.perspective.yfov * kDegrees;
    return camera.vertical_fov > 0 && camera.vertical_fov < 180;
}

}  // namespace

void add_cameras(const GltfDocument& document, const std::vector<GltfNode>& nodes,
                 ModelContent& content) {
    const auto& cameras = document.model.cameras;
    const Double3 middle = middle_of(content);
    UniqueNames names;
    for (const GltfNode& node : nodes) {
        const int index = document.model.nodes[node.index].camera;
        if (index < 0) continue;
        if (static_cast<size_t>(index) >= cameras.size())
            throw Error(ErrorKind::Input, fmt::format("there is no camera {}", index),
                        document.place("nodes", node.index), "export the model again");
        const tinygltf::Camera& source = cameras[static_cast<size_t>(index)];
        const std::string name = names.add(
            !node.name.starts_with("node ") || source.name.empty() ? node.name : source.name);
        Camera camera;
        if (!set_projection(source, camera)) {
            content.unsupported.push_back(
                fmt::format("Camera \"{}\" shows nothing and is left out.", name));
            continue;
        }
        camera.id = CameraId{static_cast<uint32_t>(content.cameras.size() + 1)};
        camera.name = name;
        camera.look_from = Double3(node.world[3]);
        const Double3 forward = -direction(node.world, 2);
        const double distance = glm::dot(middle - camera.look_from, forward);
        camera.look_at =
            camera.look_from + forward * (distance > 1e-3 && distance < 1e9 ? distance : 1.0);
        camera.up = direction(node.world, 1);
        content.cameras.push_back(std::move(camera));
    }
}

void add_lights(const GltfDocument& document, const std::vector<GltfNode>& nodes,
                ModelContent& content) {
    UniqueNames paths;
    for (const GltfNode& node : nodes) {
        const auto* use =
            find_extension(document.model.nodes[node.index].extensions, "KHR_lights_punctual");
        if (!use) continue;
        const int index = index_in(*use, "light", -1);
        if (index < 0 || static_cast<size_t>(index) >= document.model.lights.size())
            throw Error(ErrorKind::Input, fmt::format("there is no light {}", index),
                        document.place("nodes", node.index), "export the model again");
        const tinygltf::Light& source = document.model.lights[static_cast<size_t>(index)];
        ModelLight light;
        light.kind = source.type == "directional" ? ModelLight::Kind::Directional
                     : source.type == "spot"      ? ModelLight::Kind::Spot
                                                  : ModelLight::Kind::Point;
        light.name = node.name;
        light.part.path = paths.add(node.path);
        light.color = glm::max(vector_of(source.color, Double3(1)), Double3(0));
        light.intensity = std::max(source.intensity, 0.0);
        light.range = std::max(source.range, 0.0);
        light.outer_cone = std::clamp(source.spot.outerConeAngle * kDegrees, 0.0, 90.0);
        light.inner_cone = std::clamp(source.spot.innerConeAngle * kDegrees, 0.0, light.outer_cone);
        light.world_from_light = node.world;
        content.lights.push_back(std::move(light));
    }
}

}  // namespace tp
