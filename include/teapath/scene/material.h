// A material of the document. The fields of other kinds are kept, so that switching the kind in an
// editor and back loses nothing.
#pragma once

#include <teapath/scene/texture.h>

#include <string>

namespace tp {

struct Material {
    MaterialId id;
    std::string name;  // empty: written inline where it is used
    MaterialKind kind = MaterialKind::Lambertian;

    TexturedColor color;  // Lambertian: albedo; Metal: reflectance; Dielectric: tint of both lobes
    double fuzz = 0;      // Metal: radius of the ball that blurs the reflection, 0 to 1

    double ior = 1.5;         // Dielectric: index behind the normal
    double exterior_ior = 1;  // Dielectric: index before the normal
    FresnelRule fresnel = FresnelRule::Exact;

    bool emits = false;  // other kinds than DiffuseLight: emits beside scattering
    TexturedColor emission{{1, 1, 1}, {}};  // radiance per channel of what emits
    double strength = 1;                    // multiplies emission
    EmissionSide side = EmissionSide::Auto;

    double opacity = 1;  // of every kind: share of light that meets the material; the rest
                         // goes straight on. Multiplied by the colour image's alpha
    Double3 pass_through{1, 1, 1};  // colour of what goes straight on

    friend bool operator==(const Material&, const Material&) = default;
};

}  // namespace tp
