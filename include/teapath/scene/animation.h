// Animations as glTF 2.0 has them: keyframes of nodes, and how to read a value between two of them.
// Knows no scene; pose.h applies them.
#pragma once

#include <teapath/core/math.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace tp {

/// How values follow from keyframes (glTF 2.0, appendix C).
enum class Interpolation : uint8_t { Linear, Step, CubicSpline };

/// Keyframes of one property. CubicSpline has three times `width` numbers a keyframe: the tangent
/// towards it, its value, the tangent from it.
struct AnimationSampler {
    Interpolation interpolation = Interpolation::Linear;
    size_t width = 3;           // numbers of a value
    std::vector<float> times;   // seconds, from 0 upwards, each above the one before
    std::vector<float> values;  // times.size() * width numbers, CubicSpline thrice as many
};

/// The value at `time` (seconds), `width` numbers long. Before the first keyframe and after the
/// last one it is theirs.
std::vector<double> sample_numbers(const AnimationSampler& sampler, double time);
Double3 sample_vector(const AnimationSampler& sampler, double time);
/// A unit quaternion x y z w: Linear is a spherical interpolation along the shorter way
/// (Shoemake, "Animating Rotation with Quaternion Curves", 1985), CubicSpline is made unit.
Double4 sample_rotation(const AnimationSampler& sampler, double time);

enum class AnimatedProperty : uint8_t { Translation, Rotation, Scale, Weights };

/// A sampler that drives a property of a node.
struct AnimationChannel {
    size_t node = 0;  // of the model's ModelMotion::nodes
    AnimatedProperty property = AnimatedProperty::Translation;
    size_t sampler = 0;  // of the animation
};

struct Animation {
    std::string name;   // different from those of the model's other animations
    double length = 0;  // seconds, up to the last keyframe
    std::vector<AnimationSampler> samplers;
    std::vector<AnimationChannel> channels;
};

/// Scale, then rotation (a quaternion x y z w of any length but 0, else none), then translation.
DoubleMat4 placement_matrix(Double3 translation, Double4 rotation, Double3 scale);

}  // namespace tp
