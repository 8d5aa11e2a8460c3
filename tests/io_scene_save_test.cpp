// Saving: the same scene comes back, in the same words, with names and paths that still hold; the
// file is written whole or not at all.
#include "support/patterns.h"
#include "support/shipped_scenes.h"
#include "support/temporary_folder.h"

#include <teapath/core/error.h>
#include <teapath/io/scene_file.h>
#include <teapath/scene/enum_tables.h>
#include <teapath/scene/texture_uses.h>

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <random>

using namespace tp;
using tp::test::TemporaryFolder;
namespace fs = std::filesystem;

namespace {

Scene parse(const std::string& text) {
    return parse_scene(text, ".", "test.json");
}

// Scenes as an editor could leave them: every kind of thing, names that clash or are missing, ids
// with gaps.
class RandomScene {
public:
    explicit RandomScene(uint32_t seed) : random_(seed) {}

    Scene make() {
        Scene s;
        s.name = name();
        s.description = name();
        for (uint32_t i = 0; i < 1 + below(3); ++i)
            s.cameras.push_back(camera({i + 1 + below(3) * 10}));
        if (below(2)) s.active_camera = s.cameras[below(s.cameras.size())].id;
        for (uint32_t i = 0, n = below(5); i < n; ++i)
            s.textures.edit().push_back(texture({3 * i + 2}, i));
        for (uint32_t i = 0, n = below(5); i < n; ++i)
            s.materials.edit().push_back(material({5 * i + 1}, s));
        for (uint32_t i = 0, n = below(8); i < n; ++i)
            s.objects.edit().push_back(object({7 * i + 4}, s));
        for (uint32_t i = 0, n = below(2); i < n; ++i) {
            Generator g;
            g.id = {i + 1};
            g.name = name();
            g.grid.columns = static_cast<int>(below(5));
            g.grid.jitter = number();
            g.grid.thesis_colors = below(2);
            g.grid.seed = random_();
            if (below(2)) g.grid.keep_clear = {Double4(number(), 0.1, 1e-9, 3)};
            s.generators.edit().push_back(g);
        }
        s.background.kind = kind<BackgroundKind>();
        s.background.bottom = color();
        s.background.color = color();
        s.background.file.path = "sky.hdr";
        s.background.rotation = number();
        s.background.tint = color();
        s.background.backdrop = kind<BackdropKind>();
        s.background.backdrop_color = color();
        s.background.backdrop_file.path = "clouds.hdr";
        s.background.sky.sun_by = kind<SunRule>();
        s.background.sky.sun_elevation = 10.0 * below(9);
        s.background.sky.hour = below(24);
        s.background.sky.haze = below(20);
        s.background.sky.ground = color();
        s.render.path.light_rule = kind<LightRule>();
        s.render.path.clamp_direct = static_cast<float>(below(5));
        s.render.path.terminator_fix = below(2);
        s.display.rule = kind<ExposureRule>();
        s.display.iso = static_cast<float>(1 + below(800));
        s.render.width = 1 + static_cast<int>(below(65536));
        s.render.height = 1 + static_cast<int>(below(4096));
        s.render.denoise = below(2);
        s.render.denoise_strength = 0.25 * below(5);
        s.render.path.integrator = kind<IntegratorKind>();
        s.render.path.sampler = kind<SamplerKind>();
        s.render.path.seed = (uint64_t{random_()} << 32) | random_();
        s.render.path.light_sampling = below(2);
        s.display.exposure = static_cast<float>(number() / 100);
        s.display.curve = kind<ToneCurve>();
        return s;
    }

private:
    uint32_t below(size_t n) { return n ? random_() % static_cast<uint32_t>(n) : 0; }
    double number() {
        const double u = std::uniform_real_distribution<double>(-1, 1)(random_);
        switch (below(4)) {
            case 0: return std::floor(u * 100);
            case 1: return u;
            case 2: return u * 1e-7;
            default: return u * 1234.5;
        }
    }
    Double3 vec3() { return {number(), number(), number()}; }
    Double3 color() { return glm::abs(vec3()); }
    std::string name() {
        const char* names[] = {"",   "a", "a", "a 2", "b.c", "#fff", "d[0]", "\"quoted\" \\ \t",
                               "Ü ☕"};
        return names[below(std::size(names))];
    }
    template <class Enum>
    Enum kind() {
        const auto& rows = EnumTable<Enum>::rows;
        return rows[below(rows.size())].value;
    }
    template <class Things>
    auto any_id(const Things& things) -> decltype(things[0].id) {
        if (things.empty() || below(3) == 0) return {};
        return things[below(things.size())].id;
    }
    Camera camera(CameraId id) {
        Camera c;
        c.id = id;
        c.name = name();
        c.look_from = {number(), number(), 2000};
        c.aperture = std::abs(number());
        c.projection = kind<ProjectionKind>();
        c.film_height = 1 + below(9);
        c.shift = {number(), number()};
        c.blades = static_cast<int>(below(9));
        c.blade_rotation = number();
        return c;
    }
    Texture texture(TextureId id, uint32_t index) {
        Texture t;
        t.id = id;
        t.name = name();
        t.kind = kind<TextureKind>();
        t.color = color();
        // Only those before: no circles.
        t.even = {color(), {index > 0 && below(2) ? 3 * below(index) + 2 : 0}};
        t.odd.color = color();
        t.high = t.vein = t.late = t.even;
        t.mode = kind<CheckerMode>();
        t.cells = {number(), 3};
        t.file.path = below(2) ? "image.png" : "";
        t.wrap = kind<WrapMode>();
        t.wrap_v = kind<WrapModeV>();
        t.uv_set = static_cast<int>(below(2));
        t.uv_rotation = number();
        t.uv_offset = {number(), 0};
        t.tint = color();
        t.low = t.stone = t.early = t.brick = t.mortar = t.odd;
        test::randomize_pattern(t, vec3(), [&](size_t n) { return below(n); });
        return t;
    }
    TexturedNumber textured(const Scene& s, TexturedNumber standard) {
        if (below(2)) standard = {0.25 * below(5), any_id(s.textures), kind<TextureChannel>()};
        // A channel without a texture is not written.
        if (!standard.texture) standard.channel = TextureChannel::Red;
        return standard;
    }
    PrincipledSurface surface(const Scene& s) {
        PrincipledSurface p;
        for (TexturedNumber* n :
             {&p.metallic, &p.roughness, &p.specular, &p.anisotropy, &p.transmission,
              &p.diffuse_transmission, &p.coat, &p.coat_roughness, &p.sheen_roughness})
            *n = textured(s, *n);
        for (TexturedColor* c : {&p.specular_color, &p.diffuse_transmission_color, &p.sheen_color})
            *c = {color(), any_id(s.textures)};
        p.anisotropy_rotation = number();
        p.thin = below(2);
        p.attenuation_color = color();
        p.attenuation_distance = std::abs(number());
        p.normal = any_id(s.textures);
        p.normal_scale = number();
        p.bump = any_id(s.textures);
        p.bump_scale = number();
        p.dispersion = below(5);
        p.coat_normal = any_id(s.textures);
        p.coat_normal_scale = number();
        p.iridescence = textured(s, p.iridescence);
        p.iridescence_ior = 1 + 0.5 * below(3);
        p.iridescence_thickness_low = below(1000);
        p.iridescence_thickness = textured(s, p.iridescence_thickness);
        p.compensation = below(2);
        return p;
    }
    Material material(MaterialId id, const Scene& s) {
        Material m;
        m.id = id;
        m.name = name();
        m.kind = kind<MaterialKind>();
        m.color = {color(), any_id(s.textures)};
        m.fuzz = 0.25 * below(5);
        m.emits = below(2);
        m.emission = {color(), any_id(s.textures)};
        m.strength = std::abs(number());
        m.side = kind<EmissionSide>();
        m.spot_angle = 20 + below(160);
        m.spot_blend = 0.25 * below(5);
        m.fresnel = kind<FresnelRule>();
        m.alpha = kind<AlphaMode>();
        m.alpha_cutoff = 0.25 * below(5);
        m.opacity = 0.5 * below(3);
        m.ior = 1 + below(3);
        m.surface = surface(s);
        m.metal = kind<ConductorMetal>();
        m.eta = Double3(0.5, 1, 1 + below(5));
        m.k = Double3(0, below(5), 3.25);
        m.roughness = textured(s, m.roughness);
        m.masking = kind<MaskingRule>();
        return m;
    }
    Object object(ObjectId id, const Scene& s) {
        const std::vector<Shape> shapes = {SphereShape{vec3(), number()},
                                           XyRectShape{{-1, -2}, {3, 4}, number()},
                                           XzRectShape{},
                                           YzRectShape{},
                                           RectangleShape{vec3(), vec3(), vec3()},
                                           BoxShape{Double3(-1) - color(), color()},
                                           DiskShape{vec3(), {1, 2, 3}, 5},
                                           TriangleShape{vec3(), vec3(), vec3()}};
        Object o;
        o.id = id;
        o.name = name();
        o.shape = shapes[below(shapes.size())];
        o.transform = {vec3(), vec3(), Double3(1) + color()};
        o.material = any_id(s.materials);
        o.inside_out = below(2);
        o.visible = below(2);
        o.camera_visible = below(2);
        o.casts_shadows = below(2);
        o.reflection_visible = below(2);
        return o;
    }

    std::mt19937 random_;
};

// What a texture shows, whatever its name: its JSON with everything in place.
void check_same_color(const Scene& a, const TexturedColor& x, const Scene& b,
                      const TexturedColor& y) {
    const Texture *tx = find(a, x.texture), *ty = find(b, y.texture);
    REQUIRE((tx == nullptr) == (ty == nullptr));
    if (!tx) {
        CHECK(x.color == y.color);
        return;
    }
    REQUIRE(tx->kind == ty->kind);
    if (tx->kind == TextureKind::Constant) CHECK(tx->color == ty->color);
    if (tx->kind == TextureKind::Image)
        CHECK((tx->file == ty->file && tx->wrap == ty->wrap && tx->repeat == ty->repeat &&
               tx->wrap_v == ty->wrap_v && tx->uv_set == ty->uv_set &&
               tx->uv_rotation == ty->uv_rotation && tx->uv_offset == ty->uv_offset &&
               tx->tint == ty->tint && tx->projection == ty->projection && tx->space == ty->space &&
               tx->sharpness == ty->sharpness));
    if (tx->kind == TextureKind::Checker) CHECK((tx->mode == ty->mode && tx->cells == ty->cells));
    if (is_blend(tx->kind)) test::check_same_pattern(*tx, *ty);
    const TexturePair px = pair_of(*tx), py = pair_of(*ty);
    if (!px.first) return;
    check_same_color(a, *px.first, b, *py.first);
    check_same_color(a, *px.second, b, *py.second);
}

void check_same_texture(const Scene& a, TextureId x, const Scene& b, TextureId y) {
    check_same_color(a, {{0, 0, 0}, x}, b, {{0, 0, 0}, y});
}

void check_same_number(const Scene& a, const TexturedNumber& x, const Scene& b,
                       const TexturedNumber& y) {
    CHECK(x.value == y.value);
    if (x.texture) CHECK(x.channel == y.channel);
    check_same_texture(a, x.texture, b, y.texture);
}

void check_same_surface(const Scene& a, const PrincipledSurface& x, const Scene& b,
                        const PrincipledSurface& y) {
    check_same_number(a, x.metallic, b, y.metallic);
    check_same_number(a, x.roughness, b, y.roughness);
    check_same_number(a, x.specular, b, y.specular);
    check_same_color(a, x.specular_color, b, y.specular_color);
    check_same_number(a, x.anisotropy, b, y.anisotropy);
    check_same_number(a, x.transmission, b, y.transmission);
    check_same_number(a, x.diffuse_transmission, b, y.diffuse_transmission);
    check_same_color(a, x.diffuse_transmission_color, b, y.diffuse_transmission_color);
    check_same_number(a, x.coat, b, y.coat);
    check_same_number(a, x.coat_roughness, b, y.coat_roughness);
    check_same_color(a, x.sheen_color, b, y.sheen_color);
    check_same_number(a, x.sheen_roughness, b, y.sheen_roughness);
    check_same_texture(a, x.normal, b, y.normal);
    check_same_texture(a, x.bump, b, y.bump);
    CHECK(x.bump_scale == y.bump_scale);
    check_same_texture(a, x.coat_normal, b, y.coat_normal);
    check_same_number(a, x.iridescence, b, y.iridescence);
    check_same_number(a, x.iridescence_thickness, b, y.iridescence_thickness);
    CHECK((x.dispersion == y.dispersion && x.coat_normal_scale == y.coat_normal_scale));
    CHECK((x.iridescence_ior == y.iridescence_ior &&
           x.iridescence_thickness_low == y.iridescence_thickness_low));
    CHECK((x.anisotropy_rotation == y.anisotropy_rotation && x.thin == y.thin));
    CHECK((x.attenuation_color == y.attenuation_color && x.normal_scale == y.normal_scale));
    CHECK((x.attenuation_distance == y.attenuation_distance && x.compensation == y.compensation));
}

void check_same_material(const Scene& a, const Material& x, const Scene& b, const Material& y) {
    CHECK(x.kind == y.kind);
    const bool light = x.kind == MaterialKind::DiffuseLight;
    if (!light) check_same_color(a, x.color, b, y.color);
    if (x.kind == MaterialKind::Metal) CHECK(x.fuzz == y.fuzz);
    if (x.kind == MaterialKind::Principled) {
        CHECK(x.ior == y.ior);
        check_same_surface(a, x.surface, b, y.surface);
    }
    if (x.kind == MaterialKind::Conductor) {
        CHECK((x.metal == y.metal && x.eta == y.eta && x.k == y.k));
        check_same_number(a, x.roughness, b, y.roughness);
        CHECK((x.masking == y.masking && x.surface.compensation == y.surface.compensation));
    }
    if (!light) CHECK(x.emits == y.emits);
    CHECK((x.alpha == y.alpha && x.alpha_cutoff == y.alpha_cutoff));
    if (light || x.emits) check_same_color(a, x.emission, b, y.emission);
    CHECK((x.strength == y.strength && x.side == y.side && x.opacity == y.opacity));
}

}  // namespace

TEST_CASE("scene save: every shipped scene comes back equal, in the same words") {
    CHECK(test::shipped_scenes().size() >= 20);
    for (const fs::path& file : test::shipped_scenes()) {
        CAPTURE(file.string());
        const Scene scene = load_scene(file);
        const std::string text = scene_text(scene);
        const Scene again = parse_scene(text, file.parent_path(), "again");
        CHECK(again == scene);
        CHECK(again.origin.schema == scene.origin.schema);
        CHECK(scene_text(again) == text);
    }
}

TEST_CASE("scene save: whatever an editor left comes back as it was") {
    for (uint32_t seed = 0; seed < 300; ++seed) {
        CAPTURE(seed);
        const Scene scene = RandomScene(seed).make();
        const std::string text = scene_text(scene);
        CAPTURE(text);
        const Scene again = parse(text);
        CHECK(scene_text(again) == text);
        CHECK(parse(scene_text(again)) == again);

        CHECK(again.name == scene.name);
        CHECK(again.render == scene.render);
        CHECK(again.display == scene.display);
        CHECK(again.background.kind == scene.background.kind);
        CHECK(again.background.strength == scene.background.strength);
        CHECK(active_camera(again).look_from == active_camera(scene).look_from);
        REQUIRE(again.cameras.size() == scene.cameras.size());
        REQUIRE(again.generators.size() == scene.generators.size());
        for (size_t i = 0; i < scene.generators.size(); ++i)
            CHECK(again.generators[i].grid == scene.generators[i].grid);
        REQUIRE(again.objects.size() == scene.objects.size());
        for (size_t i = 0; i < scene.objects.size(); ++i) {
            const Object &x = scene.objects[i], &y = again.objects[i];
            CHECK((x.name == y.name && x.shape == y.shape && x.transform == y.transform &&
                   x.inside_out == y.inside_out && x.visible == y.visible));
            const Material *mx = find(scene, x.material), *my = find(again, y.material);
            REQUIRE((mx == nullptr) == (my == nullptr));
            if (mx) check_same_material(scene, *mx, again, *my);
        }
    }
}

TEST_CASE("scene save: defaults are left out, numbers are short, names and places stay") {
    CHECK(scene_text(parse(R"({"teapath": 1})")) ==
          "{\n  \"teapath\": 1,\n  \"background\": {\"type\": \"gradient\"}\n}\n");
    const Scene scene = parse(R"({"teapath": 1, "$schema": "x.json",
        "camera": {"look_from": [0.1, 1e-7, 123456.789], "vertical_fov": 40},
        "textures": {"b": {"type": "checker", "even": {"type": "constant", "color": 0.5}, "odd": "a"},
                     "a": {"type": "constant", "color": "#ff8000"}},
        "materials": {"plain": {"type": "lambertian", "color": 0.5}},
        "objects": [{"shape": {"type": "disk"}, "material": {"type": "metal", "color": "b", "fuzz": 0.3}},
                    {"shape": {"type": "sphere", "radius": -0.3}, "material": "plain", "visible": true}]})");
    CHECK(find(scene, TextureId{2})->color.x == 1);
    CHECK(find(scene, TextureId{2})->color.y == doctest::Approx(0.21586).epsilon(1e-4));
    CHECK(find(scene, TextureId{2})->color.z == 0);
    const std::string text = scene_text(scene);
    CAPTURE(text);
    const auto contains = [&](const char* part) {
        CAPTURE(part);
        CHECK(text.find(part) != std::string::npos);
    };
    contains(R"("$schema": "x.json",)");
    contains(R"("look_from": [0.1, 1e-07, 123456.789])");
    contains(R"("even": {"type": "constant"})");
    contains(R"("odd": "a")");
    contains(R"("plain": {"type": "lambertian"})");
    contains(R"("material": {"type": "metal", "color": "b", "fuzz": 0.3})");
    contains(R"("radius": -0.3)");
    CHECK(text.find("vertical_fov") == std::string::npos);
    CHECK(text.find("visible") == std::string::npos);
    // Files keep their order.
    CHECK(text.find("\"b\": {") < text.find("\"a\": {"));
}

TEST_CASE("scene save: equal names get numbers, nothing is lost") {
    Scene scene;
    for (uint32_t i = 1; i <= 3; ++i) {
        Material m;
        m.id = {i};
        m.name = "red";
        m.color.color = {0.1 * i, 0, 0};
        scene.materials.edit().push_back(m);
        Object o;
        o.id = {i};
        o.material = {i};
        scene.objects.edit().push_back(o);
    }
    const Scene again = parse(scene_text(scene));
    REQUIRE(again.materials.size() == 3);
    CHECK(again.materials[0].name == "red");
    CHECK(again.materials[1].name == "red 2");
    CHECK(again.materials[2].name == "red 3");
    for (size_t i = 0; i < 3; ++i)
        CHECK(find(again, again.objects[i].material)->color == scene.materials[i].color);
    scene.materials.edit()[1].name = "red 2";
    CHECK(parse(scene_text(scene)).materials[2].name == "red 3");
}

TEST_CASE("scene save: in another folder, images are still found") {
    const TemporaryFolder folder;
    const fs::path box = test::scene_folder() / "thesis" / "logo.json";
    const Scene scene = load_scene(box);
    fs::create_directories(folder.path / "deep" / "er");
    for (const char* name : {"a.json", "deep/er/b.json"}) {
        save_scene(scene, folder.path / name);
        const Scene moved = load_scene(folder.path / name);
        REQUIRE(moved.textures.size() == scene.textures.size());
        for (size_t i = 0; i < moved.textures.size(); ++i) {
            CHECK(moved.textures[i].file.path != scene.textures[i].file.path);
            REQUIRE(moved.textures[i].file.image);
            CHECK(*moved.textures[i].file.image == *scene.textures[i].file.image);
        }
        CHECK(fs::exists((folder.path / name).parent_path() / moved.origin.schema));
        CHECK(moved.objects == scene.objects);
    }
    // Beside the old one, paths are as they were.
    CHECK(scene_text(scene) == scene_text(load_scene(box)));
}

TEST_CASE("scene save: each image is loaded once") {
    const fs::path texture = fs::path(TEAPATH_SOURCE_DIR) / "assets" / "textures" / "logo.png";
    const std::string file = R"("file": ")" + texture.string() + R"(")";
    const Scene scene = parse(R"({"teapath": 1, "background": {"type": "image", )" + file +
                              R"(}, "textures": {"a": {"type": "image", )" + file +
                              R"(}, "b": {"type": "image", "wrap": "clamp", )" + file + "}}}");
    REQUIRE(scene.textures[0].file.image);
    CHECK(scene.textures[0].file.image == scene.textures[1].file.image);
    CHECK(scene.textures[0].file.image == scene.background.file.image);
}

TEST_CASE("scene save: whole or not at all, through links, with the permissions of before") {
    const TemporaryFolder folder;
    const Scene scene = load_scene(test::scene_folder() / "cornell_box.json");
    const fs::path file = folder.path / "box.json";
    save_scene(scene, file);
    CHECK(load_scene(file) == scene);
    CHECK(folder.count() == 1);

    fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
    fs::create_symlink("box.json", folder.path / "link.json");
    Scene changed = scene;
    changed.name = "changed";
    save_scene(changed, folder.path / "link.json");
    CHECK(fs::is_symlink(folder.path / "link.json"));
    CHECK(load_scene(file).name == "changed");
    CHECK(fs::status(file).permissions() == (fs::perms::owner_read | fs::perms::owner_write));
    CHECK(folder.count() == 2);

    const auto fails = [&](const fs::path& target, const char* part) {
        CAPTURE(target.string());
        try {
            save_scene(scene, target);
            FAIL_CHECK("no error");
        } catch (const Error& error) {
            const std::string message = error.what();
            CAPTURE(message);
            CHECK(error.exit_code() == 5);
            CHECK(!error.remedy().empty());
            CHECK(message.find(part) != std::string::npos);
            CHECK(message.find(target.string()) != std::string::npos);
        }
    };
    fails(folder.path, "this is a folder");
    fails(folder.path / "no" / "folder.json", "No such file");
    fails(file / "inside.json", "Not a directory");
    fails("/dev/full", "No space left");
    if (::geteuid() != 0) {
        fs::permissions(file, fs::perms::owner_read);
        fails(file, "Permission denied");
    }
    CHECK(load_scene(file).name == "changed");
    CHECK(folder.count() == 2);
}
