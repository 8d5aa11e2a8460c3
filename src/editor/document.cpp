#include <teapath/editor/document.h>
#include <teapath/io/scene_file.h>

#include <algorithm>
#include <unordered_set>

namespace tp {
namespace {

Scene fresh_scene() {
    Scene scene;
    scene.name = "Untitled";
    Camera camera;
    camera.id = {1};
    camera.look_from = {3, 2, 5};
    camera.look_at = {0, 0.5, 0};
    scene.cameras = {camera};
    Material ground;
    ground.id = {1};
    ground.name = "ground";
    ground.color.color = {0.5, 0.5, 0.5};
    Material red;
    red.id = {2};
    red.name = "red";
    red.color.color = {0.8, 0.2, 0.15};
    scene.materials = {ground, red};
    Object floor;
    floor.id = {1};
    floor.name = "floor";
    floor.shape = XzRectShape{{-10, -10}, {10, 10}, 0};
    floor.material = {1};
    Object ball;
    ball.id = {2};
    ball.name = "ball";
    ball.shape = SphereShape{{0, 0.5, 0}, 0.5};
    ball.material = {2};
    scene.objects = {floor, ball};
    scene.render.samples = 1024;
    return scene;
}

// Puts a camera into a scene that still has it.
void put_camera(const Camera& camera, Scene& scene) {
    for (Camera& c : scene.cameras)
        if (c.id == camera.id) c = camera;
}

// The camera once a change from `from` to `to` has been made to `camera`, which may have been flown
// elsewhere: what flying changes and the change did not stays as it is.
Camera camera_changed(const Camera& camera, const Camera& from, Camera to) {
    if (camera.id != to.id || from.id != to.id) return to;
    if (from.look_from == to.look_from && from.look_at == to.look_at && from.up == to.up) {
        to.look_from = camera.look_from;
        to.look_at = camera.look_at;
        to.up = camera.up;
    }
    if (from.vertical_fov == to.vertical_fov) to.vertical_fov = camera.vertical_fov;
    return to;
}

// The camera after the way from one step of the history to another.
Camera camera_after(const std::vector<HistoryStep>& steps, size_t from, size_t to, Camera camera) {
    for (size_t i = from; i > to; --i)
        if (steps[i].is_jump)
            camera = camera_changed(camera, active_camera(*steps[i].scene), steps[i].camera_before);
    for (size_t i = from + 1; i <= to; ++i)
        if (steps[i].is_jump)
            camera = camera_changed(camera, steps[i].camera_before, active_camera(*steps[i].scene));
    return camera;
}

// The memory that scenes take together, each list and image once. Long names are not counted.
class MemoryCount {
public:
    /// Adds a scene; returns the bytes that none before it had.
    size_t add(const Scene& scene) {
        size_t bytes = add_part(&scene, sizeof(Scene) + scene.description.capacity() +
                                            scene.cameras.size() * sizeof(Camera));
        bytes += add_list(scene.objects) + add_list(scene.generators) + add_list(scene.materials);
        bytes += add_image(scene.background.file) + add_image(scene.background.backdrop_file);
        if (const size_t list = add_list(scene.textures); list > 0) {
            bytes += list;
            for (const Texture& texture : scene.textures)
                bytes += add_image(texture.file);
        }
        return bytes;
    }

private:
    size_t add_part(const void* part, size_t bytes) {
        return parts_.insert(part).second ? bytes : 0;
    }
    template <class T>
    size_t add_list(const SharedList<T>& list) {
        return add_part(&list.items(), list.size() * sizeof(T));
    }
    size_t add_image(const ImageFile& file) {
        return file.image ? add_part(file.image.get(), file.image->bytes.size()) : 0;
    }
    std::unordered_set<const void*> parts_;
};

}  // namespace

Document::Document(HistoryLimit limit) : limit_(limit) {
    reset(fresh_scene(), {});
}

void Document::set_scene(Scene scene) {
    scene_ = std::make_shared<const Scene>(std::move(scene));
    modified_ = !saved_ || *scene_ != *saved_;
    ++edits_;
    if (selection.size() == 1 && !find(*scene_, selection[0])) selection.clear();
    if (selection.size() > 1) {
        std::unordered_set<uint32_t> alive;
        for (const Object& o : scene_->objects)
            alive.insert(o.id.value);
        std::erase_if(selection, [&](ObjectId id) { return !alive.count(id.value); });
    }
    std::erase_if(other_selection_, [&](SceneItem item) { return !exists(*scene_, item); });
}

void Document::reset(Scene scene, std::filesystem::path file) {
    scene_ = std::make_shared<const Scene>(std::move(scene));
    saved_ = scene_;
    ++edits_;
    steps_ = {{"Open", "", scene_, active_camera(*scene_), false}};
    position_ = 0;
    merging_ = false;
    modified_ = false;
    file_ = std::move(file);
    selection.clear();
    other_selection_.clear();
}

void Document::edit(const std::string& label, const std::string& merge_key,
                    const std::function<void(Scene&)>& change) {
    Scene changed = *scene_;
    change(changed);
    if (changed == *scene_) return;
    const Camera camera_before = active_camera(*scene_);
    const bool is_jump = active_camera(changed) != camera_before;
    set_scene(std::move(changed));
    const bool merges =
        merging_ && !merge_key.empty() && position_ > 0 && steps_[position_].merge_key == merge_key;
    if (merges) {
        steps_[position_].scene = scene_;
        steps_[position_].is_jump |= is_jump;
    } else {
        steps_.resize(position_ + 1);
        steps_.push_back({label, merge_key, scene_, camera_before, is_jump});
        position_ = steps_.size() - 1;
    }
    trim_history();
    merging_ = !merge_key.empty();
}

// The oldest steps go first; the first one stays, and the step after a gap takes over the camera
// from before it.
void Document::trim_history() {
    while (steps_.size() > 2 && (steps_.size() > limit_.steps || history_bytes() > limit_.bytes)) {
        const HistoryStep& gone = steps_[1];
        if (gone.is_jump) {
            steps_[2].camera_before = gone.camera_before;
            steps_[2].is_jump = true;
        }
        steps_.erase(steps_.begin() + 1);
        position_ = steps_.size() - 1;
    }
}

size_t Document::history_bytes() const {
    MemoryCount memory;
    memory.add(*scene_);
    size_t bytes = 0;
    for (const HistoryStep& step : steps_)
        bytes += memory.add(*step.scene);
    return bytes;
}

void Document::fly(const Camera& camera) {
    Scene changed = *scene_;
    put_camera(camera, changed);
    scene_ = std::make_shared<const Scene>(std::move(changed));
    modified_ = !saved_ || *scene_ != *saved_;
}

void Document::set_time(double seconds) {
    if (scene_->render.time == seconds) return;
    Scene changed = *scene_;
    changed.render.time = seconds;
    scene_ = std::make_shared<const Scene>(std::move(changed));
    modified_ = !saved_ || *scene_ != *saved_;
}

void Document::go_to(size_t position) {
    if (position >= steps_.size() || position == position_) return;
    Scene scene = *steps_[position].scene;
    put_camera(camera_after(steps_, position_, position, active_camera(*scene_)), scene);
    scene.render.time = scene_->render.time;
    set_scene(std::move(scene));
    position_ = position;
    merging_ = false;
}

std::string Document::title() const {
    std::string title = file_.empty() ? std::string("Untitled") : file_.filename().string();
    return is_modified() ? title + " \xe2\x80\xa2" : title;
}

void Document::open(const std::filesystem::path& file) {
    adopt(load_scene(file), can_read_model(file) ? std::filesystem::path() : file);
}

void Document::adopt(Scene scene, const std::filesystem::path& file) {
    reset(std::move(scene), file);
}

void Document::recover(Scene scene, const std::filesystem::path& file) {
    reset(std::move(scene), file);
    saved_ = nullptr;
    modified_ = true;
}

void Document::save(const std::filesystem::path& file) {
    save_scene(*scene_, file);
    mark_saved(scene_, file);
}

void Document::mark_saved(ScenePtr scene, const std::filesystem::path& file) {
    file_ = file;
    saved_ = std::move(scene);
    modified_ = scene_ != saved_ && *scene_ != *saved_;
}

void Document::start_new() {
    reset(fresh_scene(), {});
}

bool Document::is_selected(ObjectId id) const {
    return std::find(selection.begin(), selection.end(), id) != selection.end();
}

void Document::select(ObjectId id, bool add) {
    if (!add) selection.clear();
    if (!id) return;
    if (is_selected(id))
        std::erase(selection, id);
    else
        selection.push_back(id);
}

std::vector<SceneItem> Document::selected_items() const {
    if (selection.empty()) return other_selection_;
    std::vector<SceneItem> items;
    items.reserve(selection.size());
    for (const ObjectId id : selection)
        items.push_back(item_of(id));
    return items;
}

bool Document::is_selected(SceneItem item) const {
    if (item.kind == ItemKind::Object) return is_selected(ObjectId{item.id});
    return selection.empty() && std::find(other_selection_.begin(), other_selection_.end(), item) !=
                                    other_selection_.end();
}

void Document::select(SceneItem item, bool add) {
    std::vector<SceneItem> items;
    if (add) items = selected_items();
    if (std::erase(items, item) == 0) items.push_back(item);
    select_items(items);
}

void Document::select_items(const std::vector<SceneItem>& items) {
    selection.clear();
    other_selection_.clear();
    for (const SceneItem item : items) {
        if (item.kind != items.back().kind) continue;
        if (item.kind == ItemKind::Object)
            selection.push_back({item.id});
        else
            other_selection_.push_back(item);
    }
}

size_t Document::history_saved() const {
    for (size_t i = 0; i < steps_.size(); ++i)
        if (steps_[i].scene == saved_) return i;
    return steps_.size();
}

}  // namespace tp
