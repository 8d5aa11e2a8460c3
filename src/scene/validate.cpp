// Checks of a scene's values; each problem names its place in the JSON.
#include <teapath/scene/validate.h>

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <set>

namespace tp {
namespace {

class Checker {
public:
    explicit Checker(const Scene& scene) : scene_(scene) {
        for (const Texture& t : scene.textures)
            textures_[t.id] = &t;
        for (const Material& m : scene.materials)
            materials_.insert(m.id);
    }

    std::vector<Problem> run() {
        check_render();
        check_display();
        for (size_t i = 0; i < scene_.cameras.size(); ++i)
            check_camera(scene_.cameras[i],
                         scene_.cameras.size() == 1 ? "camera" : fmt::format("cameras[{}]", i));
        check_background();
        for (const Texture& t : scene_.textures)
            check_texture(t);
        for (const Material& m : scene_.materials)
            check_material(m);
        for (size_t i = 0; i < scene_.objects.size(); ++i)
            check_object(scene_.objects[i], fmt::format("objects[{}]", i));
        for (size_t i = 0; i < scene_.generators.size(); ++i)
            check_grid(scene_.generators[i].grid, fmt::format("generate[{}]", i));
        check_names();
        return std::move(problems_);
    }

private:
    void fatal(std::string where, std::string what, std::string remedy = {}) {
        problems_.push_back({true, std::move(where), std::move(what), std::move(remedy)});
    }
    void warn(std::string where, std::string what) {
        problems_.push_back({false, std::move(where), std::move(what), {}});
    }

    // Numbers of this size keep their squares inside float.
    static constexpr double kLargest = 1e15;

    bool finite(const std::string& where, double value) {
        if (std::isfinite(value) && std::abs(value) <= kLargest) return true;
        fatal(where,
              std::isfinite(value) ? fmt::format("{} is too large", value)
                                   : std::string("the number is not finite"),
              "numbers stay between -1e15 and 1e15");
        return false;
    }
    bool finite(const std::string& where, const Double3& v) {
        return finite(where, v.x) && finite(where, v.y) && finite(where, v.z);
    }
    bool finite(const std::string& where, const Double2& v) {
        return finite(where, v.x) && finite(where, v.y);
    }
    bool in_range(const std::string& where, double value, double low, double high) {
        if (value >= low && value <= high) return true;
        fatal(where, fmt::format("{} is out of range", value),
              fmt::format("from {} to {}", low, high));
        return false;
    }
    void no_less_than_zero(const std::string& where, const Double3& color) {
        if (finite(where, color) && (color.x < 0 || color.y < 0 || color.z < 0))
            fatal(where, "a colour has a negative part", "colours are 0 or more");
    }

    void check_render() {
        const RenderSettings& r = scene_.render;
        const bool width = in_range("render.width", r.width, 1, 65536),
                   height = in_range("render.height", r.height, 1, 65536);
        if (width && height && int64_t{r.width} * r.height > (int64_t{1} << 28))
            fatal("render", fmt::format("{} x {} pixels are too many", r.width, r.height),
                  "at most 268,435,456, for example 16384 x 16384");
        in_range("render.samples", r.samples, 1, 1 << 30);
        in_range("render.max_depth", r.path.max_depth, 1, 4096);
        in_range("render.roulette_depth", r.path.roulette_depth, 0, 4096);
        in_range("render.tea_rounds", r.path.tea_rounds, 6, 32);
        in_range("render.key_rounds", r.path.key_rounds, 6, 32);
    }

    void check_display() {
        in_range("display.exposure", static_cast<double>(scene_.display.exposure), -64, 64);
    }

    void check_camera(const Camera& c, const std::string& where) {
        if (!finite(where + ".look_from", c.look_from) || !finite(where + ".look_at", c.look_at) ||
            !finite(where + ".up", c.up))
            return;
        if (!(c.vertical_fov > 0 && c.vertical_fov < 180))
            fatal(where + ".vertical_fov",
                  fmt::format("{} degrees is no field of view", c.vertical_fov),
                  "above 0 and below 180");
        const Double3 view = c.look_at - c.look_from;
        if (!(glm::length(view) > 0))
            fatal(where + ".look_at", "the camera looks at where it is",
                  "move look_from or look_at");
        else if (!(glm::length(glm::cross(glm::normalize(view), c.up)) > 1e-9 * glm::length(c.up)))
            fatal(where + ".up", "up is parallel to the view",
                  "for a view straight down take [0, 0, -1]");
        if (!(c.aperture >= 0) || !finite(where + ".aperture", c.aperture))
            fatal(where + ".aperture", "the aperture is negative", "0 for a pinhole");
        if (!(c.focus_distance >= 0) || !finite(where + ".focus_distance", c.focus_distance))
            fatal(where + ".focus_distance", "the focus distance is negative",
                  "0 to focus on look_at");
        if (!(c.near_clip >= 0) || !finite(where + ".near_clip", c.near_clip))
            fatal(where + ".near_clip", "the near plane is behind the camera", "0 switches it off");
        if (!finite(where + ".far_clip", c.far_clip) || c.far_clip < 0 ||
            (c.far_clip > 0 && c.far_clip <= c.near_clip))
            fatal(where + ".far_clip", "the far plane is not beyond the near one",
                  "0 switches it off");
    }

    void check_background() {
        no_less_than_zero("background.bottom", scene_.background.bottom);
        no_less_than_zero("background.top", scene_.background.top);
        no_less_than_zero("background.color", scene_.background.color);
        finite("background.rotation", scene_.background.rotation);
        if (finite("background.strength", scene_.background.strength) &&
            scene_.background.strength < 0)
            fatal("background.strength", "the strength is negative", "0 or more");
    }

    void check_color(const TexturedColor& c, const std::string& where) {
        no_less_than_zero(where, c.color);
        if (c.texture && !textures_.count(c.texture))
            fatal(where, "the texture does not exist", "choose another");
    }

    std::string where_of(const Texture& t) const {
        return t.name.empty() ? "a texture without a name" : "textures." + t.name;
    }
    std::string where_of(const Material& m) const {
        if (!m.name.empty()) return "materials." + m.name;
        for (size_t i = 0; i < scene_.objects.size(); ++i)
            if (scene_.objects[i].material == m.id) return fmt::format("objects[{}].material", i);
        return "a material without a name";
    }

    void check_texture(const Texture& t) {
        const std::string where = where_of(t);
        if (t.kind == TextureKind::Constant) no_less_than_zero(where + ".color", t.color);
        if (t.kind == TextureKind::Image) finite(where + ".repeat", t.repeat);
        if (t.kind != TextureKind::Checker) return;
        check_color(t.even, where + ".even");
        check_color(t.odd, where + ".odd");
        finite(where + ".cells", t.cells);
        finite(where + ".frequency", t.frequency);
        std::set<TextureId> path;
        if (reaches_itself(t, path))
            fatal(where, "the texture contains itself", "break the circle of checkers");
    }

    // Walks down the checkers; `path` holds those above.
    bool reaches_itself(const Texture& t, std::set<TextureId>& path) {
        if (t.kind != TextureKind::Checker || done_.count(t.id)) return false;
        if (!path.insert(t.id).second) return true;
        for (const TextureId id : {t.even.texture, t.odd.texture}) {
            const auto found = textures_.find(id);
            if (found != textures_.end() && reaches_itself(*found->second, path)) return true;
        }
        path.erase(t.id);
        done_.insert(t.id);
        return false;
    }

    void check_material(const Material& m) {
        const std::string where = where_of(m);
        check_color(m.color, where + ".color");
        check_color(m.emission, where + ".emission");
        in_range(where + ".opacity", m.opacity, 0, 1);
        no_less_than_zero(where + ".pass_through", m.pass_through);
        if (finite(where + ".strength", m.strength) && m.strength < 0)
            fatal(where + ".strength", "the strength is negative", "0 or more");
        if (m.kind == MaterialKind::Metal) in_range(where + ".fuzz", m.fuzz, 0, 1);
        if (m.kind == MaterialKind::Dielectric) {
            in_range(where + ".ior", m.ior, 0.01, 100);
            in_range(where + ".exterior_ior", m.exterior_ior, 0.01, 100);
        }
        const bool reflects = m.kind != MaterialKind::DiffuseLight && !m.color.texture;
        if (reflects && (m.color.color.x > 1 || m.color.color.y > 1 || m.color.color.z > 1))
            warn(where + ".color",
                 "the colour is above 1: the surface gives back more light than it gets");
    }

    void check_object(const Object& o, const std::string& where) {
        if (o.material && !materials_.count(o.material))
            fatal(where + ".material", "the material does not exist", "choose another");
        const bool placed = finite(where + ".transform.translate", o.transform.translation) &&
                            finite(where + ".transform.rotate", o.transform.rotation) &&
                            finite(where + ".transform.scale", o.transform.scale);
        if (placed &&
            (o.transform.scale.x == 0 || o.transform.scale.y == 0 || o.transform.scale.z == 0))
            fatal(where + ".transform.scale", "a scale of 0 leaves nothing",
                  "use \"visible\": false to hide an object");
        std::visit([&](const auto& s) { check_shape(s, where + ".shape"); }, o.shape);
    }

    void never_hit(const std::string& where, const char* why) {
        warn(where, fmt::format("{}: it is never hit", why));
    }

    void check_shape(const SphereShape& s, const std::string& where) {
        if (finite(where + ".center", s.center) && finite(where + ".radius", s.radius) &&
            s.radius == 0)
            never_hit(where + ".radius", "the sphere has radius 0");
    }
    template <class Rect>
    void check_axis_rect(const Rect& r, const std::string& where) {
        if (!finite(where + ".low", r.low) || !finite(where + ".high", r.high) ||
            !finite(where + ".k", r.k))
            return;
        if (r.low.x > r.high.x || r.low.y > r.high.y)
            fatal(where + ".low", "the low corner is above the high one",
                  "swap them; \"inside_out\": true turns the front round");
        else if (r.low.x == r.high.x || r.low.y == r.high.y)
            never_hit(where, "the rectangle has no area");
    }
    void check_shape(const XyRectShape& r, const std::string& where) { check_axis_rect(r, where); }
    void check_shape(const XzRectShape& r, const std::string& where) { check_axis_rect(r, where); }
    void check_shape(const YzRectShape& r, const std::string& where) { check_axis_rect(r, where); }
    void check_shape(const RectangleShape& r, const std::string& where) {
        if (!finite(where + ".corner", r.corner) || !finite(where + ".edge_u", r.edge_u) ||
            !finite(where + ".edge_v", r.edge_v))
            return;
        if (!(glm::length(glm::cross(r.edge_u, r.edge_v)) > 0))
            never_hit(where, "the rectangle has no area");
    }
    void check_shape(const BoxShape& b, const std::string& where) {
        if (!finite(where + ".low", b.low) || !finite(where + ".high", b.high)) return;
        if (b.low.x > b.high.x || b.low.y > b.high.y || b.low.z > b.high.z)
            fatal(where + ".low", "the low corner is above the high one", "swap them");
        else if (b.low.x == b.high.x || b.low.y == b.high.y || b.low.z == b.high.z)
            never_hit(where, "the box has no volume");
    }
    void check_shape(const DiskShape& d, const std::string& where) {
        if (!finite(where + ".center", d.center) || !finite(where + ".normal", d.normal) ||
            !finite(where + ".radius", d.radius))
            return;
        if (!(glm::length(d.normal) > 0))
            fatal(where + ".normal", "the normal is zero",
                  "for a disk on the floor take [0, 1, 0]");
        if (d.radius == 0) never_hit(where + ".radius", "the disk has radius 0");
    }
    void check_shape(const TriangleShape& t, const std::string& where) {
        if (!finite(where + ".a", t.a) || !finite(where + ".b", t.b) || !finite(where + ".c", t.c))
            return;
        if (!(glm::length(glm::cross(t.b - t.a, t.c - t.a)) > 0))
            never_hit(where, "the triangle has no area");
    }

    void check_grid(const SphereGrid& g, const std::string& where) {
        const bool columns = in_range(where + ".columns", g.columns, 0, 65535),
                   rows = in_range(where + ".rows", g.rows, 0, 65535);
        if (columns && rows && int64_t{g.columns} * g.rows > 20'000'000)
            fatal(where, "more than 20 million spheres", "fewer columns or rows");
        finite(where + ".spacing", g.spacing);
        finite(where + ".center", g.center);
        finite(where + ".ground", g.ground);
        finite(where + ".radius", g.radius);
        finite(where + ".jitter", g.jitter);
        in_range(where + ".lambertian", g.lambertian, 0, 1);
        in_range(where + ".metal", g.metal, 0, 1);
        in_range(where + ".ior", g.ior, 0.01, 100);
    }

    void check_names() {
        const auto check = [&](const auto& things, const char* where) {
            std::set<std::string> names;
            for (const auto& thing : things)
                if (!thing.name.empty() && !names.insert(thing.name).second)
                    fatal(where, fmt::format("the name \"{}\" is used twice", thing.name),
                          "rename one");
        };
        check(scene_.cameras, "cameras");
        check(scene_.materials, "materials");
        check(scene_.textures, "textures");
    }

    const Scene& scene_;
    std::map<TextureId, const Texture*> textures_;
    std::set<MaterialId> materials_;
    std::set<TextureId> done_;
    std::vector<Problem> problems_;
};

}  // namespace

std::vector<Problem> validate(const Scene& scene) {
    return Checker(scene).run();
}

}  // namespace tp
