#include "flatten_materials.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <unordered_set>

namespace tp {
namespace {

bool is_srgb(const Image& image, ColorSpace space) {
    return space == ColorSpace::Srgb ||
           (space == ColorSpace::Auto && image.format != PixelFormat::F32);
}

constexpr double kRadiansPerDegree = 3.14159265358979323846 / 180;

// Builds the texture records, with each image's pixels packed once.
class TexturePacker {
public:
    TexturePacker(const Scene& scene, SceneArrays& arrays) : scene_(scene), arrays_(arrays) {
        for (size_t i = 0; i < scene.textures.size(); ++i)
            index_[scene.textures[i].id.value] = static_cast<int32_t>(i);
        arrays.textures.assign(scene.textures.size(), {});
        arrays.texels.clear();
    }

    void pack_textures() {
        for (size_t i = 0; i < scene_.textures.size(); ++i)
            arrays_.textures[i] = record_of(scene_.textures[i]);
    }

    ColorRef color_ref(const TexturedColor& c, double scale = 1) const {
        return {Vec3(c.color * scale), index_of(c.texture)};
    }

    int32_t index_of(TextureId id) const {
        const auto found = index_.find(id.value);
        return id && found != index_.end() ? found->second : -1;
    }

    NumberRef number_ref(const TexturedNumber& n) const {
        return {static_cast<Real>(n.value), index_of(n.texture), static_cast<int>(n.channel)};
    }

    // A record for the background's image, or -1 if it is missing.
    int32_t pack_background(const Background& background) {
        if (background.kind != BackgroundKind::Image || !background.file.image) return -1;
        Texture texture;
        texture.kind = TextureKind::Image;
        texture.file = background.file;
        texture.color_space = background.color_space;
        arrays_.textures.push_back(record_of(texture));
        return static_cast<int32_t>(arrays_.textures.size()) - 1;
    }

    bool has_alpha(const TexturedColor& c) {
        const auto found = index_.find(c.texture.value);
        if (!c.texture || found == index_.end()) return false;
        // Each texture is looked into once, however many checkers share it.
        const auto [known, is_new] = alpha_.try_emplace(c.texture.value, false);
        if (!is_new) return known->second;
        const Texture& texture = scene_.textures[static_cast<size_t>(found->second)];
        const bool alpha = texture.kind == TextureKind::Checker
                               ? has_alpha(texture.even) || has_alpha(texture.odd)
                               : texture.kind == TextureKind::Image && texture.file.image &&
                                     texture.file.image->channels % 2 == 0;
        return alpha_[c.texture.value] = alpha;
    }

private:
    TextureRecord record_of(const Texture& texture) {
        TextureRecord record;
        record.kind = texture.kind;
        if (texture.kind == TextureKind::Constant) {
            record.constant = Vec3(texture.color);
        } else if (texture.kind == TextureKind::Checker) {
            record.checker = {color_ref(texture.even), color_ref(texture.odd), texture.mode,
                              Vec2(texture.cells), static_cast<Real>(texture.frequency)};
        } else if (!texture.file.image) {
            record.kind = TextureKind::Constant;
            record.constant = {0, 1, 1};  // missing: cyan
        } else {
            record.image = image_record(texture);
        }
        return record;
    }

    ImageRecord image_record(const Texture& texture) {
        const Image& image = *texture.file.image;
        const int bytes = image.format == PixelFormat::U8    ? 1
                          : image.format == PixelFormat::U16 ? 2
                                                             : 4;
        const bool srgb = is_srgb(image, texture.color_space);
        const double angle = texture.uv_rotation * kRadiansPerDegree;
        const double cosine = std::cos(angle), sine = std::sin(angle);
        return {offset_of(image),
                image.width,
                image.height,
                static_cast<int16_t>(image.channels),
                static_cast<uint8_t>(bytes),
                srgb,
                static_cast<uint8_t>(texture.uv_set),
                texture.wrap,
                wrap_v_of(texture),
                texture.filter,
                Vec3(cosine * texture.repeat.x, sine * texture.repeat.y, texture.uv_offset.x),
                Vec3(-sine * texture.repeat.x, cosine * texture.repeat.y, texture.uv_offset.y),
                Vec3(texture.tint)};
    }

    static WrapMode wrap_v_of(const Texture& texture) {
        switch (texture.wrap_v) {
            case WrapModeV::Repeat: return WrapMode::Repeat;
            case WrapModeV::Clamp: return WrapMode::Clamp;
            case WrapModeV::Mirror: return WrapMode::Mirror;
            case WrapModeV::AsU: break;
        }
        return texture.wrap;
    }

    uint64_t offset_of(const Image& image) {
        const auto [entry, is_new] = offsets_.try_emplace(&image, 0);
        if (is_new) {
            entry->second = (arrays_.texels.size() + 15) / 16 * 16;
            arrays_.texels.resize(entry->second + image.bytes.size());
            std::memcpy(arrays_.texels.data() + entry->second, image.bytes.data(),
                        image.bytes.size());
        }
        return entry->second;
    }

    const Scene& scene_;
    SceneArrays& arrays_;
    std::unordered_map<uint32_t, int32_t> index_;
    std::unordered_map<const Image*, uint64_t> offsets_;
    std::unordered_map<uint32_t, bool> alpha_;
};

MaterialRecord record_of(const Material& m, const TexturePacker& textures) {
    MaterialRecord record;
    record.kind = m.kind;
    record.fresnel = m.fresnel;
    record.side = m.side == EmissionSide::Auto ? EmissionSide::Outside : m.side;
    record.emits = m.emits || m.kind == MaterialKind::DiffuseLight;
    record.color = textures.color_ref(m.color);
    if (record.emits) {
        record.emission = textures.color_ref(m.emission, m.strength);
        record.strength = static_cast<Real>(m.strength);
    }
    if (m.kind == MaterialKind::Dielectric || m.kind == MaterialKind::Conductor) {
        record.roughness = textures.number_ref(m.roughness);
        record.correlated = m.masking == MaskingRule::Correlated;
        record.compensation = m.surface.compensation;
    }
    if (m.kind == MaterialKind::Conductor) {
        const ConductorIndex index = index_of(m);
        record.eta_rgb = Vec3(index.eta);
        record.k = Vec3(index.k);
    }
    if (m.kind == MaterialKind::Metal) record.fuzz = static_cast<Real>(m.fuzz);
    if (m.kind == MaterialKind::Dielectric) record.eta = static_cast<Real>(m.ior / m.exterior_ior);
    record.alpha = m.alpha;
    record.alpha_cutoff = static_cast<Real>(m.alpha_cutoff);
    record.opacity = static_cast<Real>(m.opacity);
    record.pass_through = Vec3(m.pass_through);
    return record;
}

PrincipledRecord principled_record(const Material& m, const TexturePacker& textures) {
    const PrincipledSurface& s = m.surface;
    PrincipledRecord r;
    r.metallic = textures.number_ref(s.metallic);
    r.roughness = textures.number_ref(s.roughness);
    r.specular = textures.number_ref(s.specular);
    r.specular_color = textures.color_ref(s.specular_color);
    r.anisotropy = textures.number_ref(s.anisotropy);
    const double turn = s.anisotropy_rotation * kRadiansPerDegree;
    r.anisotropy_cosine = static_cast<Real>(std::cos(turn));
    r.anisotropy_sine = static_cast<Real>(std::sin(turn));
    r.ior = static_cast<Real>(std::max(m.ior, 1.001));  // 1 would have no interface to refract at
    r.transmission = textures.number_ref(s.transmission);
    r.thin = s.thin;
    r.diffuse_transmission = textures.number_ref(s.diffuse_transmission);
    r.diffuse_transmission_color = textures.color_ref(s.diffuse_transmission_color);
    for (int c = 0; c < 3 && s.attenuation_distance > 0; ++c)
        r.absorption[c] = static_cast<Real>(-std::log(std::max(s.attenuation_color[c], 1e-6)) /
                                            s.attenuation_distance);
    r.coat = textures.number_ref(s.coat);
    r.coat_roughness = textures.number_ref(s.coat_roughness);
    r.sheen_color = textures.color_ref(s.sheen_color);
    r.sheen_roughness = textures.number_ref(s.sheen_roughness);
    r.normal = textures.index_of(s.normal);
    r.normal_scale = static_cast<Real>(s.normal_scale);
    r.compensation = s.compensation;
    return r;
}

BackgroundRecord record_of(const Background& b, int32_t texture) {
    BackgroundRecord record;
    record.kind = b.kind;
    record.bottom = Vec3(b.kind == BackgroundKind::Constant ? b.color : b.bottom);
    record.top = Vec3(b.top);
    record.texture = texture;
    record.cos_rotation = static_cast<Real>(std::cos(b.rotation * kRadiansPerDegree));
    record.sin_rotation = static_cast<Real>(std::sin(b.rotation * kRadiansPerDegree));
    record.strength = static_cast<Real>(b.strength);
    return record;
}

// True if the material is made of GGX facets, or may be.
bool has_facets(const Material& m) {
    return m.kind == MaterialKind::Conductor ||
           (m.kind == MaterialKind::Dielectric && m.roughness.value > 0);
}

// The tables to aim at the background's light with, where it is an image.
std::shared_ptr<const EnvironmentArrays> environment_of(const Background& b) {
    if (b.kind != BackgroundKind::Image || !b.file.image) return nullptr;
    return environment_of(b.file.image, is_srgb(*b.file.image, b.color_space));
}

// True if some mesh has vertices that let light through.
bool has_vertex_alpha(const Scene& scene) {
    std::unordered_set<const Mesh*> seen;
    return std::any_of(scene.objects.begin(), scene.objects.end(), [&](const Object& object) {
        const auto* shape = std::get_if<MeshShape>(&object.shape);
        const Mesh* mesh = shape ? shape->file.mesh.get() : nullptr;
        if (!mesh || !seen.insert(mesh).second) return false;
        return std::any_of(mesh->colors.begin(), mesh->colors.end(),
                           [](const Float4& c) { return c.w < 1; });
    });
}

}  // namespace

MaterialIndex index_materials(const Scene& scene) {
    MaterialIndex index;
    for (size_t i = 0; i < scene.materials.size(); ++i)
        index[scene.materials[i].id.value] = static_cast<uint32_t>(i) + 1;
    return index;
}

void flatten_materials(const Scene& scene, SceneArrays& arrays) {
    TexturePacker textures(scene, arrays);
    textures.pack_textures();
    arrays.materials.assign(1, record_of(Material{}, textures));
    arrays.material_ids.assign(1, 0);
    arrays.principled.clear();
    arrays.features &= ~(kFeatureTextures | kFeatureOpacity | kFeaturePrincipled);
    const bool vertex_alpha = has_vertex_alpha(scene);
    for (const Material& m : scene.materials) {
        arrays.materials.push_back(record_of(m, textures));
        if (m.kind == MaterialKind::Principled) {
            arrays.materials.back().principled = static_cast<uint32_t>(arrays.principled.size());
            arrays.principled.push_back(principled_record(m, textures));
        }
        arrays.material_ids.push_back(m.id.value);
        const bool looks_at_alpha = m.alpha != AlphaMode::Opaque;
        if (has_facets(m)) arrays.features |= kFeaturePrincipled;
        if (m.opacity < 1 || (looks_at_alpha && (vertex_alpha || textures.has_alpha(m.color))))
            arrays.features |= kFeatureOpacity;
    }
    if (!arrays.principled.empty()) arrays.features |= kFeaturePrincipled;
    arrays.background = record_of(scene.background, textures.pack_background(scene.background));
    arrays.environment = environment_of(scene.background);
    if (!scene.textures.empty() || scene.background.kind == BackgroundKind::Image)
        arrays.features |= kFeatureTextures;
}

}  // namespace tp
