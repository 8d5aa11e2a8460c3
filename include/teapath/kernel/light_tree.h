// Choosing one of many lights: down a tree of lights, at each node by how much light each child may
// send to the point (Conty Estevez and Kulla, "Importance Sampling of Many Lights with Adaptive
// Tree Splitting", 2018), or each alike.
#pragma once

#include <teapath/kernel/scene_view.h>

namespace tp {

/// A light and the probability that it was picked; 0: none can send light there.
struct LightChoice {
    uint32_t light = 0;
    Real probability = 0;
};

/// How much the most favourable side of a cluster counts beside its middle.
inline constexpr Real kFavourableShare = Real(0.1);

/// cos(max(a - b, 0)) of two angles from 0 to pi by their sines and cosines.
TP_HD Real cosine_of_rest(Real sin_a, Real cos_a, Real sin_b, Real cos_b) {
    return cos_a >= cos_b ? 1 : cos_a * cos_b + sin_a * sin_b;
}

/// A bound, up to a common factor, of what the lights below `node` send to a surface at `position`
/// with unit `normal`, by which either side may be lit.
TP_HD Real light_importance(const LightNode& node, Vec3 position, Vec3 normal) {
    const Vec3 offset = position - (node.low + node.high) * Real(0.5);
    const Real radius2 = length_squared(node.high - node.low) * Real(0.25);
    const Real distance2 = length_squared(offset);
    if (!(distance2 > radius2)) return radius2 > 0 ? node.power / radius2 : 0;

    // The cone under which the lights' ball is seen, and angles beyond it.
    const Vec3 towards = offset * tp::rsqrt(distance2);
    const Real sin2_ball = radius2 / distance2;
    const Real sin_ball = tp::sqrt(sin2_ball), cos_ball = safe_sqrt(1 - sin2_ball);
    Real cosine = dot(node.axis, towards);
    if (node.two_sided) cosine = abs(cosine);
    const Real sine = safe_sqrt(1 - cosine * cosine);
    const Real cos_spread = node.cos_spread, sin_spread = safe_sqrt(1 - cos_spread * cos_spread);
    const Real cos_out = cosine_of_rest(sine, cosine, sin_spread, cos_spread);
    const Real leaving =
        cosine_of_rest(safe_sqrt(1 - cos_out * cos_out), cos_out, sin_ball, cos_ball);
    if (!(leaving > node.cos_reach)) return 0;
    const Real cos_in = min(abs(dot(normal, towards)), Real(1));
    const Real arriving =
        cosine_of_rest(safe_sqrt(1 - cos_in * cos_in), cos_in, sin_ball, cos_ball);
    // The middle of the ball tells more than its most favourable side, which keeps what is lit by
    // no more than that side from being forgotten.
    const Real typical = lerp(cos_in, arriving, kFavourableShare);
    return node.power * leaving * typical / distance2;
}

/// The share of the choice that a node's first child has; negative if neither child matters.
TP_HD Real share_of_first(const SceneView& scene, uint32_t node, Vec3 position, Vec3 normal) {
    const Real first = light_importance(scene.light_nodes[node + 1], position, normal);
    const Real second =
        light_importance(scene.light_nodes[scene.light_nodes[node].next], position, normal);
    return first + second > 0 ? first / (first + second) : -1;
}

/// The light of the tree that `u` in [0, 1) picks for a surface.
TP_HD LightChoice pick_in_tree(const SceneView& scene, Vec3 position, Vec3 normal, Real u) {
    uint32_t node = 0;
    Real probability = 1;
    while (!scene.light_nodes[node].is_leaf) {
        const Real share = share_of_first(scene, node, position, normal);
        if (share < 0) return {};
        if (u < share) {
            u = min(u / share, kOneMinusEpsilon);
            probability *= share;
            node = node + 1;
        } else {
            u = min((u - share) / (1 - share), kOneMinusEpsilon);
            probability *= 1 - share;
            node = scene.light_nodes[node].next;
        }
    }
    return {scene.light_nodes[node].next, probability};
}

/// The probability that pick_in_tree gives that light.
TP_HD Real probability_in_tree(const SceneView& scene, const LightRecord& light, Vec3 position,
                               Vec3 normal) {
    uint32_t node = 0;
    Real probability = 1;
    for (uint32_t trail = light.trail; !scene.light_nodes[node].is_leaf; trail >>= 1) {
        const Real share = share_of_first(scene, node, position, normal);
        if (share < 0) return 0;
        const bool first = (trail & 1) == 0;
        probability *= first ? share : 1 - share;
        node = first ? node + 1 : scene.light_nodes[node].next;
    }
    return probability;
}

/// A light for the surface at `position` with unit `normal`, picked by `u` in [0, 1).
TP_HD LightChoice pick_light(const SceneView& scene, LightRule rule, Vec3 position, Vec3 normal,
                             Real u) {
    if (rule == LightRule::Tree) return pick_in_tree(scene, position, normal, u);
    const auto count = static_cast<Real>(scene.lights.size);
    return {min(static_cast<uint32_t>(u * count), scene.lights.size - 1), 1 / count};
}

/// The probability that pick_light gives light number `light`.
TP_HD Real light_probability(const SceneView& scene, LightRule rule, uint32_t light, Vec3 position,
                             Vec3 normal) {
    if (rule == LightRule::Tree)
        return probability_in_tree(scene, scene.lights[light], position, normal);
    return 1 / static_cast<Real>(scene.lights.size);
}

}  // namespace tp
