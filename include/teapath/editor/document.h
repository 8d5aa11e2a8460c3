// The open document: a scene, its file, what is selected, and the history of edits. No window, no
// GL. Every way a user can change the scene goes through `edit` (undoable) or `fly` (the camera
// while flying, which is no step of the history).
#pragma once

#include <teapath/editor/scene_item.h>
#include <teapath/scene/scene.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace tp {

using ScenePtr = std::shared_ptr<const Scene>;

/// One step of the history: the scene after it. Steps share what they did not change.
struct HistoryStep {
    std::string label;      // "Move sphere"
    std::string merge_key;  // a drag's steps carry the same key and become one
    ScenePtr scene;
    Camera camera_before;  // the active camera just before the step, wherever it had been flown
    bool is_jump = false;  // the step changed the active camera
};

/// What a history may grow to. Beyond it the oldest steps go, but for the first one: the way back
/// to the start stays. Lists and images that only the history still holds count, each once.
struct HistoryLimit {
    size_t steps = 256;
    size_t bytes = size_t{512} << 20;
};

class Document {
public:
    /// An empty scene with a camera, a sky and a floor to begin with.
    explicit Document(HistoryLimit limit = {});

    const Scene& scene() const { return *scene_; }
    /// The scene as an immutable snapshot; a new one after each change.
    const ScenePtr& snapshot() const { return scene_; }

    /// Changes a copy of the scene by `change` and makes a step of it. Steps with the same,
    /// non-empty `merge_key` that follow each other are one. Nothing happens if nothing changes.
    void edit(const std::string& label, const std::string& merge_key,
              const std::function<void(Scene&)>& change);
    /// Ends a run of merged steps, as when the mouse button is released.
    void end_merge() { merging_ = false; }

    /// Moves the active camera without a step of the history.
    void fly(const Camera& camera);

    /// Goes to a time of the animations, in seconds, without a step of the history.
    void set_time(double seconds);

    bool can_undo() const { return position_ > 0; }
    bool can_redo() const { return position_ + 1 < steps_.size(); }
    void undo() { go_to(position_ - 1); }
    void redo() { go_to(position_ + 1); }
    /// Goes to a step of the history. The camera stays where it has been flown to, unless the way
    /// there passes a step that changed it: then it is where it was before or after that step. A
    /// step that changed its lens alone leaves it in its place. So does the time.
    void go_to(size_t position);
    const std::vector<HistoryStep>& history() const { return steps_; }
    size_t history_position() const { return position_; }
    /// The step that the file holds; history().size() if none does.
    size_t history_saved() const;
    /// Memory that the history holds beside the present scene.
    size_t history_bytes() const;
    /// Counts edits, undos and openings, not flights: equal numbers, equal scene but for the
    /// camera.
    uint64_t edits() const { return edits_; }

    /// True if the scene differs from what the file holds.
    bool is_modified() const { return modified_; }
    const std::filesystem::path& file() const { return file_; }
    std::string title() const;

    /// Throw Error; the document is as before then.
    void open(const std::filesystem::path& file);
    void save(const std::filesystem::path& file);
    void start_new();
    // The same in two parts, for a thread that reads or writes the file meanwhile.
    /// Takes a scene that was read from `file`.
    void adopt(Scene scene, const std::filesystem::path& file);
    /// Takes a scene that `file` does not hold, such as one from before a crash; `file` may be
    /// empty.
    void recover(Scene scene, const std::filesystem::path& file);
    /// `scene`, a snapshot, has been written to `file`.
    void mark_saved(ScenePtr scene, const std::filesystem::path& file);

    // What tree, viewport and inspector show as selected: objects, or else things of one other
    // kind.
    std::vector<ObjectId> selection;  // the last one is the active one
    bool is_selected(ObjectId id) const;
    void select(ObjectId id, bool add = false);
    /// The selection of whatever kind; the last one is the active one.
    std::vector<SceneItem> selected_items() const;
    bool is_selected(SceneItem item) const;
    void select(SceneItem item, bool add = false);
    /// Selects these; all are of the kind of the last one, the others are left out.
    void select_items(const std::vector<SceneItem>& items);

private:
    void set_scene(Scene scene);
    void reset(Scene scene, std::filesystem::path file);
    void trim_history();

    std::vector<SceneItem> other_selection_;  // counts where no object is selected
    ScenePtr scene_;
    ScenePtr saved_;  // what the file holds; null: nothing
    HistoryLimit limit_;
    uint64_t edits_ = 0;
    std::vector<HistoryStep> steps_;
    size_t position_ = 0;
    bool merging_ = false;
    bool modified_ = false;
    std::filesystem::path file_;
};

}  // namespace tp
