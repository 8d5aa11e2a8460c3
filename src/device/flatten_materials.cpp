#include "flatten_materials.h"

#include "flatten_background.h"
#include "texture_packer.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>

namespace tp {
namespace {

// The edge of a light's cone fades from all at the inner angle to nothing at the outer.
void add_cone(const Material& m, MaterialRecord& record) {
    if (m.spot_angle >= 180) return;
    const double outer = std::cos(m.spot_angle / 2 * kRadiansPerDegree);
    const double inner = std::cos(m.spot_angle / 2 * (1 - m.spot_blend) * kRadiansPerDegree);
    record.cone_cosine = static_cast<Real>(outer);
    record.cone_gain = static_cast<Real>(1 / std::max(inner - outer, 1e-4));
}

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
        add_cone(m, record);
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
    // KHR_materials_dispersion: 20 over the Abbe number.
    const bool disperses = !s.thin && (s.transmission.value > 0);
    r.ior_spread = disperses ? static_cast<Real>((m.ior - 1) * 0.025 * s.dispersion) : Real(0);
    r.transmission = textures.number_ref(s.transmission);
    r.thin = s.thin;
    r.diffuse_transmission = textures.number_ref(s.diffuse_transmission);
    r.diffuse_transmission_color = textures.color_ref(s.diffuse_transmission_color);
    for (int c = 0; c < 3 && s.attenuation_distance > 0; ++c)
        r.absorption[c] = static_cast<Real>(-std::log(std::max(s.attenuation_color[c], 1e-6)) /
                                            s.attenuation_distance);
    r.coat = textures.number_ref(s.coat);
    r.coat_roughness = textures.number_ref(s.coat_roughness);
    r.coat_normal = textures.index_of(s.coat_normal);
    r.coat_normal_scale = static_cast<Real>(s.coat_normal_scale);
    r.iridescence = textures.number_ref(s.iridescence);
    r.film_ior = static_cast<Real>(s.iridescence_ior);
    r.film_thickness = {1, textures.index_of(s.iridescence_thickness.texture),
                        static_cast<int>(s.iridescence_thickness.channel)};
    r.film_low = static_cast<Real>(s.iridescence_thickness_low);
    r.film_high = static_cast<Real>(s.iridescence_thickness.value);
    r.sheen_color = textures.color_ref(s.sheen_color);
    r.sheen_roughness = textures.number_ref(s.sheen_roughness);
    r.normal = textures.index_of(s.normal);
    r.normal_scale = static_cast<Real>(s.normal_scale);
    r.bump = textures.index_of(s.bump);
    r.bump_scale = static_cast<Real>(s.bump_scale);
    r.compensation = s.compensation;
    return r;
}

// True if the material is made of GGX facets, or may be.
bool has_facets(const Material& m) {
    return m.kind == MaterialKind::Conductor ||
           (m.kind == MaterialKind::Dielectric && m.roughness.value > 0);
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
    arrays.materials.assign(1, record_of(Material{}, textures));
    arrays.material_ids.assign(1, 0);
    arrays.principled.clear();
    arrays.features &=
        ~(kFeatureTextures | kFeatureOpacity | kFeaturePrincipled | kFeatureProcedural);
    const bool vertex_alpha = has_vertex_alpha(scene);
    for (const Material& m : scene.materials) {
        arrays.materials.push_back(record_of(m, textures));
        if (m.kind == MaterialKind::Principled) {
            arrays.materials.back().principled = static_cast<uint32_t>(arrays.principled.size());
            arrays.principled.push_back(principled_record(m, textures));
            if (arrays.principled.back().bump >= 0) arrays.features |= kFeatureProcedural;
        }
        arrays.material_ids.push_back(m.id.value);
        const bool looks_at_alpha = m.alpha != AlphaMode::Opaque;
        if (has_facets(m)) arrays.features |= kFeaturePrincipled;
        if (m.opacity < 1 || (looks_at_alpha && (vertex_alpha || textures.has_alpha(m.color))))
            arrays.features |= kFeatureOpacity;
    }
    if (!arrays.principled.empty()) arrays.features |= kFeaturePrincipled;
    if (textures.has_procedural()) arrays.features |= kFeatureProcedural;
    flatten_background(scene.background, textures, arrays);
    if (!arrays.textures.empty() || scene.background.kind == BackgroundKind::Image)
        arrays.features |= kFeatureTextures;
}

}  // namespace tp
