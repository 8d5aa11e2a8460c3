// Textures that are made by formulae: how noise, marble, wood and brick mix their two colours at a
// point, and the space in which they lie. They are functions of a place alone.
#pragma once

#include <teapath/kernel/noise.h>
#include <teapath/kernel/scene_view.h>

namespace tp {

/// Where a texture is read: texture coordinates of set 0 and 1, and the place in the world. The
/// rest is for textures of space.
struct TexturePoint {
    Vec2 uv;
    Vec2 uv1;
    Vec3 position;
    Vec3 normal{0, 1, 0};        // unit, for shading, on the shape's own side
    uint32_t hittable = kNoHit;  // kNoHit: the world is the object's space too
};

/// A place and a normal, whose length is any, of a texture's space.
struct SpacePoint {
    Vec3 position;
    Vec3 normal;
};

/// The map into the space of the object of `hittable`; null where that is the world.
TP_HD const Affine* object_from_world(const SceneView& scene, uint32_t hittable) {
    if (hittable == kNoHit) return nullptr;
    const Hittable& h = scene.hittables[hittable];
    if (h.kind == HittableKind::Mesh) return &scene.instances[h.mesh.instance].object_from_world;
    uint32_t low = 0, high = scene.placements.size;
    while (low < high) {
        const uint32_t middle = (low + high) / 2;
        if (scene.placements[middle].hittable < hittable)
            low = middle + 1;
        else
            high = middle;
    }
    const bool found = low < scene.placements.size && scene.placements[low].hittable == hittable;
    return found ? &scene.placements[low].object_from_world : nullptr;
}

TP_HD SpacePoint point_in(const SceneView& scene, TextureSpace space, const TexturePoint& at) {
    if (space == TextureSpace::Uv) return {{at.uv.x, at.uv.y, 0}, {0, 0, 1}};
    const Affine* map =
        space == TextureSpace::Object ? object_from_world(scene, at.hittable) : nullptr;
    if (!map) return {at.position, at.normal};
    // Normals go by the transpose of the inverse, which the cofactors are up to a factor.
    const Mat3& m = map->linear;
    const Vec3 normal = cross(m[1], m[2]) * at.normal.x + cross(m[2], m[0]) * at.normal.y +
                        cross(m[0], m[1]) * at.normal.z;
    return {map->point(at.position), normal};
}

/// The plane coordinates of `p` as seen from the side of `axis` that `normal` is on: to the right
/// and down, so that an image stands upright there as on a box.
TP_HD Vec2 plane_coordinates(Vec3 p, Vec3 normal, int axis) {
    const Real side = normal[axis] < 0 ? Real(-1) : Real(1);
    const Real across = axis == 0 ? -side * p.z : axis == 1 ? p.x : side * p.x;
    return {across, axis == 1 ? side * p.z : -p.y};
}

/// How two colours are mixed: the share of the second, and what multiplies the first.
struct PatternMix {
    Real share;
    Real shade;
};

TP_HD Real unit_clamp(Real x) {
    return clamp(x, Real(0), Real(1));
}
TP_HD Real smooth_step(Real x) {
    const Real t = unit_clamp(x);
    return t * t * (3 - 2 * t);
}

TP_HD NoiseOctaves octaves_of(const PatternRecord& r) {
    return {r.octaves, r.lacunarity, r.gain};
}

/// Noise about the middle between the colours.
TP_HD PatternMix noise_mix(const PatternRecord& r, Vec3 p) {
    const NoiseHash hash = noise_hash(r.key, r.rounds);
    const NoiseOctaves octaves = octaves_of(r);
    const Real half = Real(0.5);
    Real value = 0;
    switch (r.pattern) {
        case NoisePattern::Gradient:
            value = half + r.contrast * gradient_noise(hash, p).value;
            break;
        case NoisePattern::Fbm: value = half + r.contrast * fbm(hash, p, octaves).value; break;
        case NoisePattern::Turbulence: value = 2 * r.contrast * turbulence(hash, p, octaves); break;
        case NoisePattern::Ridged:
            value = half + r.contrast * (ridged_noise(hash, p, octaves) - half);
            break;
    }
    return {unit_clamp(value), 1};
}

/// Veins between layers that noise has bent (after Perlin 1985): one a cell along the axis, each
/// stronger here and weaker there.
TP_HD PatternMix marble_mix(const PatternRecord& r, Vec3 p) {
    const NoiseHash hash = noise_hash(r.key, r.rounds);
    const Real bend = fbm(hash, p * Real(0.5), octaves_of(r)).value;
    const Real layer = p[static_cast<int>(r.axis)] + 3 * r.distortion * bend;
    const Real vein = std::pow(unit_clamp(1 - abs(std::sin(kPi * layer))), r.contrast);
    const Real strength = Real(0.55) + Real(1.5) * gradient_noise(hash, p * Real(0.6)).value;
    return {vein * unit_clamp(strength), 1};
}

/// Rings about the axis, one a cell: early wood that darkens slowly, late wood that ends at once.
/// The grain is fibres along the axis.
TP_HD PatternMix wood_mix(const PatternRecord& r, Vec3 p) {
    const NoiseHash hash = noise_hash(r.key, r.rounds);
    const int axis = static_cast<int>(r.axis);
    const Real along = p[axis];
    const Real x = p[(axis + 1) % 3], y = p[(axis + 2) % 3];
    // A trunk bends and swells slowly along itself.
    const Vec3 slow = Vec3(x, y, along * Real(0.25)) * Real(0.5);
    const Real radius =
        tp::sqrt(x * x + y * y) + Real(1.5) * r.distortion * fbm(hash, slow, octaves_of(r)).value;
    const Real ring = radius - std::floor(radius);
    const Real rise = sqr(min(ring / Real(0.85), Real(1)));
    const Real late = ring < Real(0.85) ? rise : 1 - smooth_step((ring - Real(0.85)) / Real(0.15));
    const Vec3 fibre{x * 14, y * 14, along * Real(0.7)};
    const Real streak = unit_clamp(Real(0.5) + gradient_noise(hash, fibre).value);
    return {late, 1 - r.contrast * streak};
}

/// Courses of bricks: a whole wall lies in the plane that the surface faces most.
TP_HD PatternMix brick_mix(const PatternRecord& r, Vec2 p) {
    const Real row = std::floor(p.y / r.scale.y);
    const Real along = p.x / r.scale.x + r.distortion * row;
    const Real column = std::floor(along);
    const Real x = (along - column) * r.scale.x, y = p.y - row * r.scale.y;
    const Real to_edge = min(min(x, r.scale.x - x), min(y, r.scale.y - y));
    const Real half = r.scale.z / 2, edge = max(r.edge * r.scale.z, Real(1e-12));
    const uint32_t bits =
        lattice_hash(noise_hash(r.key, r.rounds), lattice_bits(column), lattice_bits(row));
    return {1 - smooth_step((to_edge - half) / edge), 1 - r.contrast * unit_real(bits)};
}

/// The mix of a texture of that kind at `at`.
TP_HD PatternMix pattern_mix(const SceneView& scene, TextureKind kind, const PatternRecord& r,
                             const TexturePoint& at) {
    const SpacePoint point = point_in(scene, r.space, at);
    if (kind == TextureKind::Brick) {
        const Vec3 n = abs(point.normal);
        const int axis = n.x >= n.y && n.x >= n.z ? 0 : n.y >= n.z ? 1 : 2;
        const Vec2 wall = r.space == TextureSpace::Uv
                              ? Vec2(point.position.x, point.position.y)
                              : plane_coordinates(point.position, point.normal, axis);
        return brick_mix(r, wall);
    }
    const Vec3 p = point.position * r.scale;
    if (kind == TextureKind::Marble) return marble_mix(r, p);
    if (kind == TextureKind::Wood) return wood_mix(r, p);
    return noise_mix(r, p);
}

}  // namespace tp
