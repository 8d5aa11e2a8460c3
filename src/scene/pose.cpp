#include <teapath/scene/pose.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace tp {
namespace {

using Animations = std::vector<const Animation*>;

void apply(const Animation& animation, const AnimationChannel& channel, double time,
           MotionNode& node) {
    const AnimationSampler& sampler = animation.samplers[channel.sampler];
    if (channel.property != AnimatedProperty::Weights) node.matrix.reset();
    switch (channel.property) {
        case AnimatedProperty::Translation: node.translation = sample_vector(sampler, time); break;
        case AnimatedProperty::Rotation: node.rotation = sample_rotation(sampler, time); break;
        case AnimatedProperty::Scale: node.scale = sample_vector(sampler, time); break;
        case AnimatedProperty::Weights: node.weights = sample_numbers(sampler, time); break;
    }
}

DoubleMat4 matrix_of(const MotionNode& node) {
    return node.matrix ? *node.matrix
                       : placement_matrix(node.translation, node.rotation, node.scale);
}

const Model* find_model(const Scene& scene, ModelId id) {
    for (const Model& model : scene.models)
        if (model.id == id) return &model;
    return nullptr;
}

const ModelMotion* motion_of(const Model& model) {
    return model.content ? model.content->motion.get() : nullptr;
}

template <class T>
bool same_list(const SharedList<T>& a, const SharedList<T>& b) {
    return &a.items() == &b.items();
}

bool is_finite(const DoubleMat4& m) {
    for (int c = 0; c < 4; ++c)
        if (!std::isfinite(glm::dot(m[c], Double4(1)))) return false;
    return true;
}

// Nothing of a matrix that is flat: it has no way back.
bool is_flat(const DoubleMat4& m) {
    const DoubleMat3 linear(m);
    const double size = glm::length(linear[0]) * glm::length(linear[1]) * glm::length(linear[2]);
    return !is_finite(m) || !(std::abs(glm::determinant(linear)) > 1e-12 * size) || !(size > 1e-45);
}

std::optional<DoubleMat4> change_between(const Model& model, const DoubleMat4& rest,
                                         const DoubleMat4& now) {
    if (rest == now || is_flat(rest)) return DoubleMat4(1);
    if (is_flat(now)) return std::nullopt;
    const DoubleMat4 under = world_from_object(model.transform);
    return under * now * glm::inverse(rest) * glm::inverse(under);
}

std::vector<DoubleMat4> joints_of(const ModelMotion& motion, size_t skin, const NodePoses& poses) {
    std::vector<DoubleMat4> joints;
    if (skin == kNoIndex) return joints;
    const MotionSkin& s = motion.skins[skin];
    joints.reserve(s.joints.size());
    for (size_t j = 0; j < s.joints.size(); ++j)
        joints.push_back(poses.worlds[s.joints[j]] * s.joint_from_mesh[j]);
    return joints;
}

}  // namespace

std::vector<const Animation*> playing_animations(const Model& model) {
    Animations playing;
    if (const ModelMotion* motion = motion_of(model))
        for (const Animation& animation : motion->animations)
            if (model.animation == kAllAnimations || model.animation == animation.name)
                playing.push_back(&animation);
    return playing;
}

NodePoses pose_nodes(const ModelMotion& motion, const Animations& animations, double time) {
    std::vector<MotionNode> nodes = motion.nodes;
    for (const Animation* animation : animations)
        for (const AnimationChannel& channel : animation->channels)
            apply(*animation, channel, time, nodes[channel.node]);
    NodePoses poses;
    for (MotionNode& node : nodes) {
        const DoubleMat4 own = matrix_of(node);
        poses.worlds.push_back(node.parent == kNoIndex ? own : poses.worlds[node.parent] * own);
        poses.weights.push_back(std::move(node.weights));
    }
    return poses;
}

double animation_length(const Scene& scene) {
    double length = 0;
    for (const Model& model : scene.models)
        for (const Animation* animation : playing_animations(model))
            length = std::max(length, animation->length);
    return length;
}

bool pose_differs(const Scene& a, const Scene& b) {
    if (a.render.time != b.render.time && animation_length(b) > 0) return true;
    if (&a.models.items() == &b.models.items()) return false;
    return !std::equal(
        a.models.begin(), a.models.end(), b.models.begin(), b.models.end(),
        [](const Model& x, const Model& y) { return x.id == y.id && x.animation == y.animation; });
}

std::optional<DoubleMat4> PoseChanges::of(const Object& object) {
    if (!object.part.model) return DoubleMat4(1);
    const auto [entry, is_new] = known_.try_emplace(object.part.model);
    Poses& poses = entry->second;
    if (is_new) {
        poses.model = find_model(scene_, object.part.model);
        const Animations playing = poses.model ? playing_animations(*poses.model) : Animations();
        if (!playing.empty()) {
            const ModelMotion& motion = *poses.model->content->motion;
            poses.rest = pose_nodes(motion, {}, 0);
            poses.now = pose_nodes(motion, playing, scene_.render.time);
        }
    }
    if (poses.now.worlds.empty()) return DoubleMat4(1);
    const auto& parts = poses.model->content->motion->parts;
    const auto part = parts.find(object.part.path);
    if (part == parts.end() || part->second.skin != kNoIndex) return DoubleMat4(1);
    const size_t node = part->second.node;
    return change_between(*poses.model, poses.rest.worlds[node], poses.now.worlds[node]);
}

std::shared_ptr<const Scene> ScenePoser::pose(std::shared_ptr<const Scene> scene) {
    if (scene == scene_) return posed_;
    // A camera or a setting alone: what moved stands as before.
    if (scene_ && posed_ != scene_ && scene->render.time == scene_->render.time &&
        same_list(scene->models, scene_->models) && same_list(scene->objects, scene_->objects)) {
        auto posed = std::make_shared<Scene>(*scene);
        posed->objects = posed_->objects;
        scene_ = std::move(scene);
        return posed_ = std::move(posed);
    }
    Forms forms;
    std::shared_ptr<Scene> posed;
    for (const Model& model : scene->models) {
        if (playing_animations(model).empty()) continue;
        if (!posed) posed = std::make_shared<Scene>(*scene);
        pose_model(model, scene->render.time, *posed, forms);
    }
    forms_ = std::move(forms);
    scene_ = std::move(scene);
    posed_ = posed ? std::move(posed) : scene_;
    return posed_;
}

void ScenePoser::pose_model(const Model& model, double time, Scene& posed, Forms& forms) const {
    const ModelMotion& motion = *model.content->motion;
    const NodePoses rest = pose_nodes(motion, {}, 0);
    const NodePoses now = pose_nodes(motion, playing_animations(model), time);
    std::vector<Object>& objects = posed.objects.edit();
    for (Object& object : objects) {
        if (object.part.model != model.id) continue;
        const auto found = motion.parts.find(object.part.path);
        if (found == motion.parts.end()) continue;
        const MotionPart& part = found->second;
        if (part.skin == kNoIndex && now.worlds[part.node] != rest.worlds[part.node]) {
            const auto change =
                change_between(model, rest.worlds[part.node], now.worlds[part.node]);
            if (change)
                move_object(object, *change);
            else
                object.visible = false;
        }
        // A mesh that the user has put in its place keeps its form.
        auto* shape = std::get_if<MeshShape>(&object.shape);
        if (part.deformable && shape && shape->file.mesh == part.rest && object.visible)
            shape->file.mesh = form_of(model, part, now, forms);
    }
}

std::shared_ptr<const Mesh> ScenePoser::form_of(const Model& model, const MotionPart& part,
                                                const NodePoses& poses, Forms& forms) const {
    const FormKey key{model.id, part.deformable.get(), part.skin, poses.weights[part.node]};
    const auto [entry, is_new] = forms.try_emplace(key);
    Form& form = entry->second;
    if (!is_new) return form.mesh;
    form.joints = joints_of(*model.content->motion, part.skin, poses);
    const auto before = forms_.find(key);
    if (before != forms_.end() && before->second.joints == form.joints)
        return form.mesh = before->second.mesh;
    Mesh mesh = deformed(*part.deformable, std::get<3>(key), form.joints, true);
    // Numbers beyond all bounds: it stays as it was.
    form.mesh = problem_of(mesh).empty() ? share(std::move(mesh)) : part.rest;
    return form.mesh;
}

}  // namespace tp
