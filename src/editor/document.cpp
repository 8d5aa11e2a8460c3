#include <teapath/editor/document.h>
#include <teapath/io/scene_file.h>

#include <algorithm>

namespace tp {
namespace {

constexpr size_t kMaxSteps = 256;

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

// The camera after the way from one step of the history to another.
Camera camera_after(const std::vector<HistoryStep>& steps, size_t from, size_t to, Camera camera) {
    for (size_t i = from; i > to; --i)
        if (steps[i].is_jump) camera = steps[i].camera_before;
    for (size_t i = from + 1; i <= to; ++i)
        if (steps[i].is_jump) camera = active_camera(*steps[i].scene);
    return camera;
}

}  // namespace

Document::Document() {
    reset(fresh_scene(), {});
}

void Document::set_scene(Scene scene) {
    scene_ = std::make_shared<const Scene>(std::move(scene));
    modified_ = *scene_ != *saved_;
    std::erase_if(selection, [&](ObjectId id) { return !find(*scene_, id); });
}

void Document::reset(Scene scene, std::filesystem::path file) {
    scene_ = std::make_shared<const Scene>(std::move(scene));
    saved_ = scene_;
    steps_ = {{"Open", "", scene_, active_camera(*scene_), false}};
    position_ = 0;
    merging_ = false;
    modified_ = false;
    file_ = std::move(file);
    selection.clear();
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
        if (steps_.size() > kMaxSteps) steps_.erase(steps_.begin() + 1);
        position_ = steps_.size() - 1;
    }
    merging_ = !merge_key.empty();
}

void Document::fly(const Camera& camera) {
    Scene changed = *scene_;
    put_camera(camera, changed);
    scene_ = std::make_shared<const Scene>(std::move(changed));
    modified_ = true;
}

void Document::go_to(size_t position) {
    if (position >= steps_.size() || position == position_) return;
    Scene scene = *steps_[position].scene;
    put_camera(camera_after(steps_, position_, position, active_camera(*scene_)), scene);
    set_scene(std::move(scene));
    position_ = position;
    merging_ = false;
}

std::string Document::title() const {
    std::string title = file_.empty() ? std::string("Untitled") : file_.filename().string();
    return is_modified() ? title + " \xe2\x80\xa2" : title;
}

void Document::open(const std::filesystem::path& file) {
    reset(load_scene(file), file);
}

void Document::save(const std::filesystem::path& file) {
    save_scene(*scene_, file);
    file_ = file;
    saved_ = scene_;
    modified_ = false;
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

}  // namespace tp
