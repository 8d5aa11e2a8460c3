// How models stand at a time: their nodes, skins and morph targets, and the scene with all of it
// in place. The document keeps its things as the model files have them at rest; what moves is
// derived from it here.
#pragma once

#include <teapath/scene/animation.h>
#include <teapath/scene/deform.h>
#include <teapath/scene/scene.h>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

namespace tp {

inline constexpr size_t kNoIndex = static_cast<size_t>(-1);

/// A node of a model at rest.
struct MotionNode {
    size_t parent = kNoIndex;  // before this one in the list
    Double3 translation{0, 0, 0};
    Double4 rotation{0, 0, 0, 1};  // a quaternion x y z w
    Double3 scale{1, 1, 1};
    std::optional<DoubleMat4> matrix;  // in place of the three
    std::vector<double> weights;       // of the morph targets
};

struct MotionSkin {
    std::vector<size_t> joints;               // nodes
    std::vector<DoubleMat4> joint_from_mesh;  // of each joint: the inverse bind matrix
};

/// What moves an object of the model.
struct MotionPart {
    size_t node = 0;
    size_t skin = kNoIndex;                            // its joints place it, the node does not
    std::shared_ptr<const DeformableMesh> deformable;  // null: the mesh keeps its form
    std::shared_ptr<const Mesh> rest;                  // of the object at rest
};

/// All that moves in a model file.
struct ModelMotion {
    std::vector<MotionNode> nodes;  // parents first
    std::vector<MotionSkin> skins;
    std::map<std::string, MotionPart> parts;  // by ModelPart::path of objects
    std::vector<Animation> animations;
};

/// Nodes at a time.
struct NodePoses {
    std::vector<DoubleMat4> worlds;            // world of the model from node
    std::vector<std::vector<double>> weights;  // of each node's morph targets
};

/// Model::animation that plays all, and none of them.
inline constexpr const char* kAllAnimations = "all";
inline constexpr const char* kNoAnimation = "none";

/// The animations that play. Null entries there are not.
std::vector<const Animation*> playing_animations(const Model& model);

/// The nodes at `time` (seconds) with these animations; where two drive one property, the later in
/// the list does. None: at rest.
NodePoses pose_nodes(const ModelMotion& motion, const std::vector<const Animation*>& animations,
                     double time);

/// Seconds that the longest animation of those that play takes; 0 if nothing moves.
double animation_length(const Scene& scene);

/// True if the two may stand otherwise, by their time or by the animations that play.
bool pose_differs(const Scene& a, const Scene& b);

/// Where the scene's time takes objects from where the document has them. The scene must outlive
/// it.
class PoseChanges {
public:
    explicit PoseChanges(const Scene& scene) : scene_(scene) {}

    /// A matrix of the world: the identity for what stays in its place, and for what a skin places;
    /// none for what is scaled to nothing.
    std::optional<DoubleMat4> of(const Object& object);

private:
    struct Poses {
        const Model* model = nullptr;
        NodePoses rest, now;  // empty: nothing moves
    };
    const Scene& scene_;
    std::map<ModelId, Poses> known_;
};

/// Poses scenes, and keeps the meshes it made for the next time.
class ScenePoser {
public:
    /// The scene as it stands at its RenderSettings::time; the same one if nothing moves. What the
    /// user changed of an object stays with its part. Meshes that do not change their form are
    /// shared; those that do are made anew, on all cores. What is scaled to nothing is invisible.
    std::shared_ptr<const Scene> pose(std::shared_ptr<const Scene> scene);

private:
    // A mesh in one form.
    struct Form {
        std::vector<DoubleMat4> joints;
        std::shared_ptr<const Mesh> mesh;
    };
    using FormKey = std::tuple<ModelId, const DeformableMesh*, size_t, std::vector<double>>;
    using Forms = std::map<FormKey, Form>;

    void pose_model(const Model& model, double time, Scene& posed, Forms& forms) const;
    std::shared_ptr<const Mesh> form_of(const Model& model, const MotionPart& part,
                                        const NodePoses& poses, Forms& forms) const;

    std::shared_ptr<const Scene> scene_, posed_;  // of the last time
    Forms forms_;
};

}  // namespace tp
