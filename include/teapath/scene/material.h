// A material of the document. The fields of other kinds are kept, so that switching the kind in an
// editor and back loses nothing.
#pragma once

#include <teapath/scene/texture.h>

#include <string>

namespace tp {

/// The surface of glTF 2.0 (appendix B) with its extensions; Material::color is the base colour,
/// Material::ior the index of refraction. Numbers without a unit are from 0 to 1.
struct PrincipledSurface {
    TexturedNumber metallic{0, {}, TextureChannel::Blue};
    TexturedNumber roughness{0.5, {}, TextureChannel::Green};  // alpha of GGX is its square
    TexturedNumber specular{1, {}, TextureChannel::Alpha};  // weight of the dielectric's reflection
    TexturedColor specular_color{{1, 1, 1}, {}};
    TexturedNumber anisotropy{0, {}, TextureChannel::Blue};
    double anisotropy_rotation = 0;  // degrees from the tangent, counter-clockwise

    TexturedNumber transmission{0, {}, TextureChannel::Red};
    bool thin = true;  // no inside: light goes straight on; else it is refracted and absorbed
    Double3 attenuation_color{1, 1, 1};
    double attenuation_distance = 0;  // scene units until white light has that colour; 0 = never
    double dispersion = 0;            // 20 / Abbe number

    TexturedNumber diffuse_transmission{0, {}, TextureChannel::Alpha};
    TexturedColor diffuse_transmission_color{{1, 1, 1}, {}};

    TexturedNumber coat{0, {}, TextureChannel::Red};
    TexturedNumber coat_roughness{0, {}, TextureChannel::Green};
    TextureId coat_normal;
    double coat_normal_scale = 1;
    TexturedColor sheen_color{{0, 0, 0}, {}};
    TexturedNumber sheen_roughness{0, {}, TextureChannel::Alpha};
    TexturedNumber iridescence{0, {}, TextureChannel::Red};
    double iridescence_ior = 1.3;
    double iridescence_thickness_low = 100;  // nanometres where the texture's channel is 0
    TexturedNumber iridescence_thickness{
        400, {}, TextureChannel::Green};  // nanometres where it is 1 or absent

    TextureId normal;  // tangent-space normal map
    double normal_scale = 1;
    TextureId bump;            // height by its luminance
    double bump_scale = 0.01;  // scene units of height where the luminance is 1
    bool compensation = true;  // of the energy that single scattering loses at high roughness;
                               // of rough conductors and dielectrics too

    friend bool operator==(const PrincipledSurface&, const PrincipledSurface&) = default;
};

struct Material {
    MaterialId id;
    std::string name;  // empty: written inline where it is used
    MaterialKind kind = MaterialKind::Lambertian;

    TexturedColor color;  // Lambertian: albedo; Metal: reflectance; Dielectric: tint of both lobes;
                          // Conductor: tint of the reflection
    double fuzz = 0;      // Metal: radius of the ball that blurs the reflection, 0 to 1

    double ior = 1.5;         // Dielectric: index behind the normal
    double exterior_ior = 1;  // Dielectric: index before the normal
    FresnelRule fresnel = FresnelRule::Exact;

    ConductorMetal metal = ConductorMetal::Gold;             // Conductor
    Double3 eta{0.143, 0.375, 1.442};                        // Conductor, Custom: index, real part
    Double3 k{3.983, 2.386, 1.603};                          // and imaginary part, per channel
    TexturedNumber roughness{0, {}, TextureChannel::Green};  // Conductor, Dielectric: alpha of GGX
                                                             // is its square; 0 is smooth
    MaskingRule masking = MaskingRule::Correlated;           // of rough ones

    bool emits = false;  // other kinds than DiffuseLight: emits beside scattering
    TexturedColor emission{{1, 1, 1}, {}};  // radiance per channel of what emits
    double strength = 1;                    // multiplies emission
    EmissionSide side = EmissionSide::Auto;
    double spot_angle = 180;  // of what emits: degrees across the cone about the normal, 0 to 180
    double spot_blend = 0;    // share of that angle over which its edge fades, 0 to 1

    PrincipledSurface surface;

    AlphaMode alpha = AlphaMode::Blend;
    double alpha_cutoff = 0.5;  // Mask: what is below lets all light through
    double opacity = 1;         // of every kind: share of light that meets the material; the rest
                                // goes straight on. Multiplied by the colour image's alpha
    Double3 pass_through{1, 1, 1};  // colour of what goes straight on
    ModelPart part;

    friend bool operator==(const Material&, const Material&) = default;
};

/// The complex index of refraction eta + i k of a metal, per channel.
struct ConductorIndex {
    Double3 eta, k;
};
ConductorIndex index_of(const Material& material);

}  // namespace tp
