#include "gltf_animations.h"

#include "../model/unique_names.h"
#include "gltf_accessor.h"
#include "gltf_value.h"

#include <teapath/core/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>

namespace tp {
namespace {

std::string text_in(const Json& object, const char* key) {
    const auto found = object.find(key);
    return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

// A number from 0 upwards; none where it is missing or another thing.
std::optional<size_t> index_of(const Json& object, const char* key) {
    const auto found = object.find(key);
    if (found == object.end() || !found->is_number_unsigned()) return std::nullopt;
    const auto index = found->get<uint64_t>();
    return index < (uint64_t{1} << 31) ? std::optional<size_t>(index) : std::nullopt;
}

const Json& list_in(const Json& object, const char* key) {
    static const Json none = Json::array();
    const auto found = object.find(key);
    return found != object.end() && found->is_array() ? *found : none;
}

const Json& object_in(const Json& object, const char* key) {
    static const Json none = Json::object();
    const auto found = object.find(key);
    return found != object.end() && found->is_object() ? *found : none;
}

// What is wrong, without the place and the remedy around it.
std::string words_of(const Error& error) {
    std::string words = error.what();
    if (words.starts_with(error.where() + ": ")) words.erase(0, error.where().size() + 2);
    const std::string remedy = " (" + error.remedy() + ")";
    if (words.ends_with(remedy)) words.erase(words.size() - remedy.size());
    return words;
}

class AnimationReader {
public:
    AnimationReader(const GltfDocument& document, const std::vector<GltfNode>& nodes,
                    std::vector<std::string>& unsupported)
        : document_(document), unsupported_(unsupported) {
        for (size_t i = 0; i < nodes.size(); ++i)
            places_[nodes[i].index] = i;
    }

    std::vector<Animation> read() {
        std::vector<Animation> animations;
        UniqueNames names;
        for (size_t i = 0; i < document_.animations.size(); ++i) {
            const Json& json = document_.animations[i];
            const std::string given = text_in(json, "name");
            Animation animation;
            animation.name = names.add(given.empty() ? fmt::format("animation {}", i) : given);
            read_channels(json, document_.place("animations", i), animation);
            if (!animation.channels.empty()) animations.push_back(std::move(animation));
        }
        return animations;
    }

private:
    [[noreturn]] static void fail(const std::string& what, const std::string& where) {
        throw Error(ErrorKind::Input, what, where, "export the model again");
    }

    void read_channels(const Json& json, const std::string& where, Animation& animation) {
        const Json& channels = list_in(json, "channels");
        std::map<std::pair<size_t, size_t>, size_t> known;  // by sampler and width
        for (size_t i = 0; i < channels.size(); ++i) {
            try {
                read_channel(json, channels[i], fmt::format("{}.channels[{}]", where, i), known,
                             animation);
            } catch (const Error& error) {
                unsupported_.push_back(fmt::format("Animation \"{}\": channel {} is left out: {}.",
                                                   animation.name, i, words_of(error)));
            }
        }
    }

    void read_channel(const Json& json, const Json& channel, const std::string& where,
                      std::map<std::pair<size_t, size_t>, size_t>& known, Animation& animation) {
        if (!channel.is_object()) fail("this is not an object", where);
        const Json& target = object_in(channel, "target");
        const std::string path = text_in(target, "path");
        if (path == "pointer") fail("KHR_animation_pointer is not supported", where);
        const auto node = index_of(target, "node");
        if (!node) return;  // glTF 2.0: such a channel is to be passed over
        AnimationChannel added;
        size_t width = 3;
        if (path == "translation")
            added.property = AnimatedProperty::Translation;
        else if (path == "scale")
            added.property = AnimatedProperty::Scale;
        else if (path == "rotation")
            added.property = AnimatedProperty::Rotation, width = 4;
        else if (path == "weights")
            added.property = AnimatedProperty::Weights, width = targets_of(*node, where);
        else
            fail(fmt::format("there is no property \"{}\"", path), where);
        const auto place = places_.find(*node);
        if (place == places_.end()) return;  // of another scene of the file
        added.node = place->second;

        const auto sampler = index_of(channel, "sampler");
        const Json& samplers = list_in(json, "samplers");
        if (!sampler || *sampler >= samplers.size() || !samplers[*sampler].is_object())
            fail("it has no sampler", where);
        const auto [entry, is_new] = known.try_emplace({*sampler, width}, kNoIndex);
        if (is_new) {
            AnimationSampler read = read_sampler(samplers[*sampler], width, where);
            animation.length = std::max(animation.length, static_cast<double>(read.times.back()));
            animation.samplers.push_back(std::move(read));
            entry->second = animation.samplers.size() - 1;
        }
        if (entry->second == kNoIndex) fail("its sampler is broken", where);
        added.sampler = entry->second;
        animation.channels.push_back(added);
    }

    // Numbers that a keyframe of a node's weights has.
    size_t targets_of(size_t node, const std::string& where) const {
        const auto& nodes = document_.model.nodes;
        const auto& meshes = document_.model.meshes;
        if (node < nodes.size())
            if (const int mesh = nodes[node].mesh;
                mesh >= 0 && static_cast<size_t>(mesh) < meshes.size()) {
                size_t most = 0;
                for (const auto& primitive : meshes[static_cast<size_t>(mesh)].primitives)
                    most = std::max(most, primitive.targets.size());
                if (most > 0) return most;
            }
        fail("the node has no morph targets", where);
    }

    AnimationSampler read_sampler(const Json& json, size_t width, const std::string& where) {
        AnimationSampler sampler;
        sampler.width = width;
        const std::string rule = text_in(json, "interpolation");
        if (rule == "STEP")
            sampler.interpolation = Interpolation::Step;
        else if (rule == "CUBICSPLINE")
            sampler.interpolation = Interpolation::CubicSpline;
        else if (!rule.empty() && rule != "LINEAR")
            fail(fmt::format("there is no interpolation \"{}\"", rule), where);
        sampler.times = numbers_of(json, "input", where);
        sampler.values = numbers_of(json, "output", where);

        const auto& times = sampler.times;
        if (times.empty() || times.front() < 0) fail("its keyframes have no times", where);
        const bool is_falling =
            std::adjacent_find(times.begin(), times.end(),
                               [](float a, float b) { return !(a < b); }) != times.end();
        if (is_falling) fail("the times of its keyframes do not rise", where);
        const size_t rows =
            times.size() * (sampler.interpolation == Interpolation::CubicSpline ? 3 : 1);
        if (sampler.values.size() != rows * width)
            fail(fmt::format("it has {} numbers for {} keyframes", sampler.values.size(),
                             times.size()),
                 where);
        return sampler;
    }

    std::vector<float> numbers_of(const Json& json, const char* key, const std::string& where) {
        const auto index = index_of(json, key);
        if (!index) fail(fmt::format("its sampler has no {}", key), where);
        const auto& accessor = checked_accessor(document_, static_cast<int>(*index), where);
        bytes_ += 4.0 * static_cast<double>(accessor.count) * components_of(accessor);
        check_memory(*document_.source, bytes_);
        std::vector<float> numbers = read_floats(document_, static_cast<int>(*index), where);
        if (!std::all_of(numbers.begin(), numbers.end(), [](float x) { return std::isfinite(x); }))
            fail("its numbers are not finite", where);
        return numbers;
    }

    const GltfDocument& document_;
    std::vector<std::string>& unsupported_;
    std::unordered_map<size_t, size_t> places_;  // in the list, by the file's numbers
    double bytes_ = 0;
};

}  // namespace

std::vector<Animation> read_animations(const GltfDocument& document,
                                       const std::vector<GltfNode>& nodes,
                                       std::vector<std::string>& unsupported) {
    return AnimationReader(document, nodes, unsupported).read();
}

std::vector<MotionNode> motion_nodes(const GltfDocument& document,
                                     const std::vector<GltfNode>& nodes) {
    std::vector<MotionNode> motion;
    for (const GltfNode& node : nodes) {
        const tinygltf::Node& source = document.model.nodes[node.index];
        MotionNode added;
        added.parent = node.parent;
        added.translation = vector_of(source.translation, added.translation);
        added.rotation = vector_of(source.rotation, added.rotation);
        added.scale = vector_of(source.scale, added.scale);
        if (source.matrix.size() == 16) added.matrix = node.own;
        added.weights = source.weights;
        const auto mesh = static_cast<size_t>(source.mesh);
        if (added.weights.empty() && source.mesh >= 0 && mesh < document.model.meshes.size())
            added.weights = document.model.meshes[mesh].weights;
        motion.push_back(std::move(added));
    }
    return motion;
}

std::vector<bool> moving_nodes(const std::vector<Animation>& animations,
                               const std::vector<GltfNode>& nodes) {
    std::vector<bool> moving(nodes.size());
    for (const Animation& animation : animations)
        for (const AnimationChannel& channel : animation.channels)
            if (channel.property != AnimatedProperty::Weights) moving[channel.node] = true;
    for (size_t i = 0; i < nodes.size(); ++i)
        if (nodes[i].parent != kNoIndex && moving[nodes[i].parent]) moving[i] = true;
    return moving;
}

std::vector<bool> morphing_nodes(const std::vector<Animation>& animations, size_t nodes) {
    std::vector<bool> morphing(nodes);
    for (const Animation& animation : animations)
        for (const AnimationChannel& channel : animation.channels)
            if (channel.property == AnimatedProperty::Weights) morphing[channel.node] = true;
    return morphing;
}

}  // namespace tp
