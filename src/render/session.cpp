#include <teapath/core/error.h>
#include <teapath/core/log.h>
#include <teapath/render/session.h>

#include <utility>

namespace tp {
namespace {

std::unique_ptr<Backend> make_backend(const SessionOptions& options) {
    if (options.backend == BackendKind::Host) return make_host_backend(options.threads);
    if (options.backend == BackendKind::Cuda)
        return make_cuda_backend(options.device, options.launch_seconds);
    try {
        return make_cuda_backend(options.device, options.launch_seconds);
    } catch (const Error& error) {
        log_info("no CUDA device, rendering on the host: {}", error.what());
        return make_host_backend(options.threads);
    }
}

}  // namespace

Session::Session(const SessionOptions& options)
    : options_(options), backend_(make_backend(options)) {}

Session::~Session() = default;

void Session::sync(std::shared_ptr<const Scene> scene) {
    scene = poser_.pose(std::move(scene));
    const SceneParts parts = scene_ ? changed_parts(*scene_, *scene) : SceneParts::All;
    scene_ = std::move(scene);
    if (parts != SceneParts::None) {
        flatten(*scene_, parts, arrays_);
        backend_->upload(arrays_, parts);
    }
    const FilmSetup setup{scene_->render.width, scene_->render.height, options_.features};
    if (parts != SceneParts::None || setup != film_setup_) {
        film_setup_ = setup;
        empty_film();
    }
}

bool Session::step(int64_t samples) {
    if (!backend_->render({samples_, samples}, cancel_)) {
        cancel_ = false;
        empty_film();
        return false;
    }
    samples_ += samples;
    return true;
}

void Session::restart() {
    empty_film();
}

void Session::empty_film() {
    backend_->reset_film(film_setup_);
    samples_ = 0;
    ++film_number_;
}

FilmImage Session::film() const {
    return backend_->read_film();
}

std::vector<uint8_t> Session::display() const {
    return backend_->read_display(scene_->display);
}

FilmImage Session::guides(int64_t samples) const {
    return backend_->read_guides(samples);
}

DisplayImage Session::display_image() const {
    return backend_->display_image(scene_->display);
}

}  // namespace tp
