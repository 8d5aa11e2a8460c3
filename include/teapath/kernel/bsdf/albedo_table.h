// How much light the microfacets give back when light meets them once, looked up: what the rest is
// scaled by so that no energy is lost (Kulla and Conty, "Revisiting Physically Based Shading at
// Imageworks", 2017). device/albedo_tables.h fills the tables.
#pragma once

#include <teapath/core/math.h>

namespace tp {

inline constexpr int kAlbedoCosines = 64;    // nodes over the cosine, from 0 to 1
inline constexpr int kAlbedoRoughness = 32;  // nodes over the square root of alpha, from 0 to 1
inline constexpr int kGlassNodes = 16;       // nodes over each of cosine, roughness and F0

/// Rows by roughness; pointers into arrays that outlive the view. Reflection by Schlick's
/// approximation is f0 * x + f90 * y.
struct AlbedoTables {
    const Vec2* ggx = nullptr;          // kAlbedoRoughness rows of kAlbedoCosines
    const Vec2* ggx_average = nullptr;  // by roughness: average over cosine-weighted directions
    const Real* sheen = nullptr;        // kAlbedoRoughness rows of kAlbedoCosines
    const Real* glass = nullptr;  // by side (from outside, from within), F0, roughness, cosine
};

/// The node below `x` in [0, 1] and the share of the next one.
struct TablePlace {
    int node;
    Real share;
};
TP_HD TablePlace table_place(Real x, int nodes) {
    const Real scaled = clamp(x, Real(0), Real(1)) * static_cast<Real>(nodes - 1);
    const int node = min(static_cast<int>(scaled), nodes - 2);
    return {node, scaled - static_cast<Real>(node)};
}

template <class T>
TP_HD T look_up(const T* table, TablePlace row, TablePlace column, int columns) {
    const T* low = table + row.node * columns + column.node;
    return lerp(lerp(low[0], low[1], column.share),
                lerp(low[columns], low[columns + 1], column.share), row.share);
}

TP_HD Vec2 ggx_albedo(const AlbedoTables& t, Real cosine, Real alpha) {
    return look_up(t.ggx, table_place(tp::sqrt(alpha), kAlbedoRoughness),
                   table_place(cosine, kAlbedoCosines), kAlbedoCosines);
}
TP_HD Vec2 ggx_average_albedo(const AlbedoTables& t, Real alpha) {
    const TablePlace at = table_place(tp::sqrt(alpha), kAlbedoRoughness);
    return lerp(t.ggx_average[at.node], t.ggx_average[at.node + 1], at.share);
}
TP_HD Real sheen_albedo(const AlbedoTables& t, Real cosine, Real alpha) {
    return look_up(t.sheen, table_place(tp::sqrt(alpha), kAlbedoRoughness),
                   table_place(cosine, kAlbedoCosines), kAlbedoCosines);
}

/// What a rough interface gives back, reflected and refracted together; `eta` is the index beyond
/// it over the index before it.
TP_HD Real glass_albedo(const AlbedoTables& t, Real cosine, Real alpha, Real eta) {
    constexpr int kPlane = kGlassNodes * kGlassNodes;
    const Real f0 = sqr((eta - 1) / (eta + 1));
    const TablePlace layer = table_place(tp::sqrt(tp::sqrt(f0)), kGlassNodes);
    const TablePlace row = table_place(tp::sqrt(alpha), kGlassNodes);
    const TablePlace column = table_place(cosine, kGlassNodes);
    const Real* side = t.glass + (eta < 1 ? kGlassNodes * kPlane : 0) + layer.node * kPlane;
    return lerp(look_up(side, row, column, kGlassNodes),
                look_up(side + kPlane, row, column, kGlassNodes), layer.share);
}

}  // namespace tp
