// A scene around a model that came without one: camera, sky and lamp.
#include <teapath/scene/model.h>
#include <teapath/scene/scene.h>

#include <algorithm>
#include <cmath>

namespace tp {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kMargin = 1.08;        // of the picture around the model
constexpr size_t kMostPoints = 200000;  // that are looked at
constexpr int kCenterings = 4;

struct Box {
    Double3 low{1e300}, high{-1e300};

    bool is_empty() const { return low.x > high.x; }
    Double3 center() const { return (low + high) * 0.5; }
    double radius() const { return std::max(glm::distance(low, high) / 2, 1e-6); }
    void add(const Double3& p) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
};

// Vertices of the visible meshes in the world, no more of them than it takes to see their outline.
std::vector<Double3> points_of(const std::vector<Object>& objects) {
    size_t total = 0;
    const auto mesh_of = [](const Object& object) -> const Mesh* {
        const auto* shape = std::get_if<MeshShape>(&object.shape);
        return shape && object.visible ? shape->file.mesh.get() : nullptr;
    };
    for (const Object& object : objects)
        if (const Mesh* mesh = mesh_of(object)) total += mesh->positions.size();
    const size_t step = total / kMostPoints + 1;
    std::vector<Double3> points;
    for (const Object& object : objects) {
        const Mesh* mesh = mesh_of(object);
        if (!mesh) continue;
        const DoubleMat4 world = world_from_object(object.transform) *
                                 DoubleMat4(std::get<MeshShape>(object.shape).placement);
        for (size_t i = 0; i < mesh->positions.size(); i += step)
            points.emplace_back(world * Double4(Double3(mesh->positions[i]), 1));
    }
    if (points.empty()) points = {Double3(-1), Double3(1)};
    return points;
}

Box box_around(const std::vector<Double3>& points) {
    Box box;
    for (const Double3& p : points)
        box.add(p);
    return box;
}

// Looks at the points from the front, a little from the right and from above, as near as shows all
// of them, in the middle of the picture.
Camera camera_around(const std::vector<Double3>& points, double aspect) {
    Camera camera;
    camera.name = "view";
    camera.vertical_fov = 35;
    const Double3 back = glm::normalize(Double3(0.55, 0.35, 1));
    const Double3 right = glm::normalize(glm::cross(Double3(0, 1, 0), back));
    const Double3 up = glm::cross(back, right);
    const double tan_y = std::tan(camera.vertical_fov / 2 * kPi / 180), tan_x = tan_y * aspect;
    const Box box = box_around(points);
    camera.look_at = box.center();
    double distance = 0;
    for (int round = 0; round < kCenterings; ++round) {
        distance = 1e-3 * box.radius();
        for (const Double3& point : points) {
            const Double3 p = point - camera.look_at;
            const double across =
                std::max(std::abs(glm::dot(p, right)) / tan_x, std::abs(glm::dot(p, up)) / tan_y);
            distance = std::max(distance, glm::dot(p, back) + kMargin * across);
        }
        if (round + 1 == kCenterings) break;
        // Where the points are in the picture, at distance 1.
        Double2 low(1e300), high(-1e300);
        for (const Double3& point : points) {
            const Double3 p = point - camera.look_at;
            const double depth = std::max(distance - glm::dot(p, back), 1e-9);
            const Double2 seen = Double2(glm::dot(p, right), glm::dot(p, up)) / depth;
            low = glm::min(low, seen);
            high = glm::max(high, seen);
        }
        const Double2 middle = (low + high) * 0.5 * distance;
        camera.look_at += right * middle.x + up * middle.y;
    }
    camera.look_from = camera.look_at + back * distance;
    return camera;
}

// A soft lamp from the upper left before the model, a third brighter than the sky.
void add_lamp(Scene& scene, const Box& box) {
    constexpr double kIrradiance = 3, kDistance = 3, kSide = 1.4;  // the last two in radii
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
    const Box box = box_around(points_of(objects));
    return {box.low, box.high};
}

Camera camera_in_front(const std::vector<Object>& objects, double aspect) {
    return camera_around(points_of(objects), aspect);
}

Scene scene_of_model(Model model) {
    Scene scene;
    scene.name = model.name;
    const std::shared_ptr<const ModelContent> content = model.content;
    add_model(scene, std::move(model));
    const std::vector<Double3> points = points_of(scene.objects);
    const Box box = box_around(points);
    if (content) scene.cameras = content->cameras;
    const double aspect = static_cast<double>(scene.render.width) / scene.render.height;
    if (scene.cameras.empty()) scene.cameras.push_back(camera_around(points, aspect));
    for (size_t i = 0; i < scene.cameras.size(); ++i)
        scene.cameras[i].id = {static_cast<uint32_t>(i) + 1};
    scene.background.bottom = Double3(0.3, 0.3, 0.32);
    scene.background.top = Double3(0.6, 0.63, 0.68);
    if (content && !content->lights.empty())
        scene.background.strength = 0.3;
    else
        add_lamp(scene, box);
    scene.display.curve = ToneCurve::Neutral;
    return scene;
}

}  // namespace tp
