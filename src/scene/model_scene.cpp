// A scene around a model that came without one: camera, sky and lamp.
#include <teapath/scene/model.h>
#include <teapath/scene/scene.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace tp {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kMargin = 1.08;  // of the picture around the model

struct Box {
    Double3 low{1e300}, high{-1e300};

    bool is_empty() const { return low.x > high.x; }
    Double3 center() const { return (low + high) * 0.5; }
    double radius() const { return std::max(glm::distance(low, high) / 2, 1e-6); }
    std::array<Double3, 8> corners() const {
        std::array<Double3, 8> points;
        for (size_t i = 0; i < 8; ++i)
            points[i] = {(i & 1) != 0 ? high.x : low.x, (i & 2) != 0 ? high.y : low.y,
                         (i & 4) != 0 ? high.z : low.z};
        return points;
    }
};

Box box_around(const std::vector<Object>& objects) {
    Box box;
    for (const Object& object : objects) {
        const auto* shape = std::get_if<MeshShape>(&object.shape);
        if (!shape || !shape->file.mesh || !object.visible) continue;
        const DoubleMat4 world = world_from_object(object.transform) * DoubleMat4(shape->placement);
        const Box own{Double3(shape->file.mesh->low), Double3(shape->file.mesh->high)};
        for (const Double3& corner : own.corners()) {
            const Double3 p(world * Double4(corner, 1));
            box.low = glm::min(box.low, p);
            box.high = glm::max(box.high, p);
        }
    }
    return box.is_empty() ? Box{Double3(-1), Double3(1)} : box;
}

// Looks at the box from the front, a little from the right and from above, as near as shows it all.
Camera camera_around(const Box& box, double aspect) {
    Camera camera;
    camera.name = "view";
    camera.vertical_fov = 35;
    const Double3 back = glm::normalize(Double3(0.55, 0.35, 1));
    const Double3 right = glm::normalize(glm::cross(Double3(0, 1, 0), back));
    const Double3 up = glm::cross(back, right);
    const double tan_y = std::tan(camera.vertical_fov / 2 * kPi / 180), tan_x = tan_y * aspect;
    double distance = 0;
    for (const Double3& corner : box.corners()) {
        const Double3 p = corner - box.center();
        const double across =
            std::max(std::abs(glm::dot(p, right)) / tan_x, std::abs(glm::dot(p, up)) / tan_y);
        distance = std::max(distance, glm::dot(p, back) + kMargin * across);
    }
    camera.look_at = box.center();
    camera.look_from = box.center() + back * std::max(distance, 1e-3 * box.radius());
    return camera;
}

// A soft lamp from the upper left before the model, a third brighter than the sky.
void add_lamp(Scene& scene, const Box& box) {
    constexpr double kIrradiance = 2.2, kDistance = 3, kSide = 1.4;  // the last two in radii
    Material light;
    light.id = {1};
    for (const Material& m : scene.materials)
        light.id.value = std::max(light.id.value, m.id.value + 1);
    light.name = "lamp";
    light.kind = MaterialKind::DiffuseLight;
    light.emission.color = {1, 0.97, 0.92};
    light.strength = kIrradiance * kDistance * kDistance / (kSide * kSide);
    const double radius = box.radius();
    const Double3 towards = glm::normalize(Double3(-0.7, 0.9, 0.8));
    const Double3 u = glm::normalize(glm::cross(Double3(0, 1, 0), -towards)) * (kSide * radius);
    const Double3 v = glm::normalize(glm::cross(-towards, u)) * (kSide * radius);
    Object lamp;
    lamp.id = {1};
    for (const Object& o : scene.objects)
        lamp.id.value = std::max(lamp.id.value, o.id.value + 1);
    lamp.name = "lamp";
    lamp.material = light.id;
    lamp.shape = RectangleShape{-(u + v) * 0.5, u, v};  // its front looks at the model
    lamp.transform.translation = box.center() + towards * (kDistance * radius);
    scene.materials.edit().push_back(light);
    scene.objects.edit().push_back(lamp);
}

}  // namespace

std::pair<Double3, Double3> box_of(const std::vector<Object>& objects) {
    const Box box = box_around(objects);
    return {box.low, box.high};
}

Camera camera_in_front(const std::vector<Object>& objects, double aspect) {
    return camera_around(box_around(objects), aspect);
}

Scene scene_of_model(Model model) {
    Scene scene;
    scene.name = model.name;
    const std::shared_ptr<const ModelContent> content = model.content;
    add_model(scene, std::move(model));
    const Box box = box_around(scene.objects);
    if (content) scene.cameras = content->cameras;
    const double aspect = static_cast<double>(scene.render.width) / scene.render.height;
    if (scene.cameras.empty()) scene.cameras.push_back(camera_around(box, aspect));
    for (size_t i = 0; i < scene.cameras.size(); ++i)
        scene.cameras[i].id = {static_cast<uint32_t>(i) + 1};
    scene.background.bottom = Double3(0.22, 0.22, 0.24);
    scene.background.top = Double3(0.45, 0.48, 0.52);
    if (content && !content->lights.empty())
        scene.background.strength = 0.3;
    else
        add_lamp(scene, box);
    scene.display.curve = ToneCurve::Neutral;
    return scene;
}

}  // namespace tp
