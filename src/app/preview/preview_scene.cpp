#include "preview_scene.h"

#include <teapath/core/color.h>
#include <teapath/scene/texture_uses.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <functional>

namespace tp {
namespace {

// FNV-1a over the values that a picture depends on.
class Hash {
public:
    void add(uint64_t x) {
        for (int i = 0; i < 8; ++i)
            value_ = (value_ ^ (x >> (8 * i) & 0xff)) * 0x100000001b3;
    }
    void add(double x) { add(std::bit_cast<uint64_t>(x)); }
    void add(const Double2& v) { add(v.x), add(v.y); }
    void add(const Double3& v) { add(v.x), add(v.y), add(v.z); }
    template <class Enum>
    requires std::is_enum_v<Enum>
    void add(Enum e) { add(static_cast<uint64_t>(e)); }
    uint64_t value() const { return value_; }

private:
    uint64_t value_ = 0xcbf29ce484222325;
};

void add_texture(Hash& hash, const Scene& scene, TextureId id, int depth);

void add_color(Hash& hash, const Scene& scene, const TexturedColor& color, int depth) {
    if (depth < kMaxTextureNesting && find(scene, color.texture))
        add_texture(hash, scene, color.texture, depth);
    else
        hash.add(color.color);
}

void add_pattern(Hash& hash, const Texture& t) {
    hash.add(t.space);
    hash.add(t.scale);
    hash.add(t.axis);
    hash.add(t.pattern);
    for (const int number : {t.seed, t.tea_rounds, t.octaves})
        hash.add(static_cast<uint64_t>(number));
    for (const double number : {t.lacunarity, t.gain, t.contrast, t.distortion, t.vein_power,
                                t.grain, t.mortar_width, t.mortar_blend, t.row_offset, t.variation})
        hash.add(number);
    hash.add(t.brick_size);
}

void add_texture(Hash& hash, const Scene& scene, const Texture& t, int depth) {
    hash.add(t.kind);
    hash.add(t.color);
    if (const TexturePair pair = pair_of(t); pair.first) {
        add_color(hash, scene, *pair.first, depth + 1);
        add_color(hash, scene, *pair.second, depth + 1);
    }
    if (is_blend(t.kind)) {
        add_pattern(hash, t);
    } else if (t.kind == TextureKind::Checker) {
        hash.add(t.mode);
        hash.add(t.cells);
        hash.add(t.frequency);
    } else if (t.kind == TextureKind::Image) {
        hash.add(reinterpret_cast<uint64_t>(t.file.image.get()));
        hash.add(t.wrap);
        hash.add(t.filter);
        hash.add(t.color_space);
        hash.add(t.repeat);
        hash.add(t.projection);
        hash.add(t.space);
        hash.add(t.sharpness);
    }
}

void add_texture(Hash& hash, const Scene& scene, TextureId id, int depth) {
    if (const Texture* t = find(scene, id)) add_texture(hash, scene, *t, depth);
}

// Everything that a slot of a surface says.
void add_slot(Hash& hash, const Scene& scene, const TexturedColor& color) {
    add_color(hash, scene, color, 0);
}
void add_slot(Hash& hash, const Scene& scene, const TexturedNumber& number) {
    hash.add(number.value);
    hash.add(number.channel);
    add_texture(hash, scene, number.texture, 0);
}
void add_slot(Hash& hash, const Scene& scene, TextureId texture) {
    add_texture(hash, scene, texture, 0);
}

void take_texture(const Scene& from, TextureId id, Scene& to) {
    const Texture* t = find(from, id);
    if (!t || find(to, t->id)) return;
    to.textures.edit().push_back(*t);
    for_each_slot(*t,
                  [&](const char*, const auto& slot) { take_texture(from, texture_in(slot), to); });
}

float sample_of(const Image& image, size_t index) {
    const std::byte* bytes = image.bytes.data();
    switch (image.format) {
        case PixelFormat::U8: return static_cast<float>(std::to_integer<int>(bytes[index])) / 255;
        case PixelFormat::U16: {
            uint16_t x = 0;
            std::memcpy(&x, bytes + 2 * index, 2);
            return static_cast<float>(x) / 65535;
        }
        case PixelFormat::F32: break;
    }
    float x = 0;
    std::memcpy(&x, bytes + 4 * index, 4);
    return srgb_from_linear(x);
}

}  // namespace

Scene preview_scene(const Scene& scene, const Material& material, int size) {
    Scene made;
    made.render.width = made.render.height = size;
    made.render.path.max_depth = 12;
    made.background.top = {0.75, 0.8, 0.9};
    made.background.bottom = {0.5, 0.48, 0.46};

    Camera camera;
    camera.id = {1};
    camera.look_from = {0, 2.1, 5.4};
    camera.look_at = {0, 0.92, 0};
    camera.vertical_fov = 24;
    made.cameras = {camera};

    Material shown = material;
    shown.id = {1};
    for_each_slot(
        shown, [&](const char*, const auto& slot) { take_texture(scene, texture_in(slot), made); });
    Texture squares;
    for (const Texture& t : made.textures)
        squares.id.value = std::max(squares.id.value, t.id.value);
    ++squares.id.value;
    squares.kind = TextureKind::Checker;
    squares.even.color = Double3(0.5);
    squares.odd.color = Double3(0.22);
    squares.cells = {20, 20};
    made.textures.edit().push_back(squares);
    Material floor, lamp;
    floor.id = {2};
    floor.color.texture = squares.id;
    lamp.id = {3};
    lamp.kind = MaterialKind::DiffuseLight;
    lamp.strength = 9;
    made.materials = {shown, floor, lamp};

    Object ball, ground, light;
    ball.id = {1};
    ball.shape = SphereShape{{0, 1, 0}, 1};
    ball.material = shown.id;
    ground.id = {2};
    ground.shape = XzRectShape{{-8, -8}, {8, 8}, 0};
    ground.material = floor.id;
    light.id = {3};
    light.shape = DiskShape{{-2.5, 4, 2.5}, {2.5, -3, -2.5}, 1.0};
    light.material = lamp.id;
    made.objects = {ball, ground, light};
    return made;
}

Scene preview_scene(const Scene& scene, const Texture& texture, int size) {
    Scene made;
    made.render.width = made.render.height = size;
    made.render.path.integrator = IntegratorKind::Flat;
    Camera camera;
    camera.id = {1};
    camera.projection = ProjectionKind::Orthographic;
    camera.look_from = {0.5, 0.5, 1};
    camera.look_at = {0.5, 0.5, 0};
    camera.film_height = 1;
    made.cameras = {camera};
    take_texture(scene, texture.id, made);
    Material shown;
    shown.id = {1};
    shown.alpha = AlphaMode::Opaque;
    shown.color.texture = texture.id;
    made.materials = {shown};
    Object square;
    square.id = {1};
    square.shape = XyRectShape{{0, 0}, {1, 1}, 0};
    square.material = shown.id;
    made.objects = {square};
    return made;
}

uint64_t preview_key(const Scene& scene, const Texture& texture) {
    Hash hash;
    hash.add(uint64_t{1});  // no material's
    add_texture(hash, scene, texture, 0);
    return hash.value();
}

uint64_t preview_key(const Scene& scene, const Material& m) {
    Hash hash;
    hash.add(m.kind);
    add_color(hash, scene, m.color, 0);
    hash.add(m.fuzz);
    hash.add(m.ior);
    hash.add(m.exterior_ior);
    hash.add(m.fresnel);
    hash.add(static_cast<uint64_t>(m.emits));
    if (m.emits || m.kind == MaterialKind::DiffuseLight) {
        add_color(hash, scene, m.emission, 0);
        hash.add(m.strength);
        hash.add(m.side);
    }
    hash.add(m.opacity);
    hash.add(m.pass_through);
    if (m.kind == MaterialKind::Principled) {
        for_each_slot(m, [&](const char*, const auto& slot) { add_slot(hash, scene, slot); });
        hash.add(m.surface.normal_scale);
        hash.add(m.surface.bump_scale);
    }
    return hash.value();
}

std::vector<uint8_t> image_thumbnail(const Image& image, int size) {
    std::vector<uint8_t> rgb(static_cast<size_t>(size) * static_cast<size_t>(size) * 3, 128);
    if (image.width < 1 || image.height < 1 || image.channels < 1) return rgb;
    const double side = std::min(image.width, image.height);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const auto place = [&](int i, int length) {
                const double at = (length - side) / 2 + (i + 0.5) / size * side;
                return std::clamp(static_cast<int>(at), 0, length - 1);
            };
            const size_t pixel =
                static_cast<size_t>(place(y, image.height)) * static_cast<size_t>(image.width) +
                static_cast<size_t>(place(x, image.width));
            for (int c = 0; c < 3; ++c) {
                const int channel = image.channels < 3 ? 0 : c;
                const float value = sample_of(image, pixel * static_cast<size_t>(image.channels) +
                                                         static_cast<size_t>(channel));
                rgb[(static_cast<size_t>(y) * static_cast<size_t>(size) + static_cast<size_t>(x)) *
                        3 +
                    static_cast<size_t>(c)] =
                    static_cast<uint8_t>(std::clamp(value, 0.0f, 1.0f) * 255 + 0.5f);
            }
        }
    return rgb;
}

}  // namespace tp
