#include "previews.h"

#include "preview_scene.h"

#include <teapath/core/log.h>
#include <teapath/render/session.h>
#include <teapath/scene/texture_uses.h>

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>

namespace tp {
namespace {

constexpr size_t kMostWaiting = 64;  // what is asked for and no longer seen is asked again

// Jobs are told apart by the ids of materials, and of textures beyond this.
constexpr uint64_t kTextureOwner = uint64_t{1} << 32;

// The picture that the user looks at goes first.
void lower_priority() {
    setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), 10);
}

}  // namespace

Previews::Previews() : thread_([this] { run(); }) {}

Previews::~Previews() {
    {
        const std::lock_guard lock(mutex_);
        stopping_ = true;
    }
    wake_.notify_all();
    thread_.join();
}

void Previews::run() {
    lower_priority();
    SessionOptions options;
    options.backend = BackendKind::Host;
    options.threads = 1;
    std::unique_ptr<Session> session;
    for (;;) {
        Job job;
        {
            std::unique_lock lock(mutex_);
            wake_.wait(lock, [&] { return stopping_ || !jobs_.empty(); });
            if (stopping_) return;
            job = std::move(jobs_.front());
            jobs_.pop_front();
        }
        Picture picture{job.key, {}};
        try {
            if (!session) session = std::make_unique<Session>(options);
            session->sync(job.scene);
            session->step(kSamples);
            picture.rgb = session->display();
        } catch (const std::exception& error) {
            log_warning("no preview: {}", error.what());
            session.reset();
        }
        const std::lock_guard lock(mutex_);
        finished_.push_back(std::move(picture));
    }
}

template <class Make>
uint64_t Previews::rendered_picture(uint64_t key, uint64_t owner, const Make& make) {
    const auto [found, is_new] = entries_.try_emplace(key);
    found->second.last_used = frame_;
    if (is_new) ask(key, owner, std::make_shared<const Scene>(make()));
    uint64_t& shown = shown_[owner];
    const auto now = entries_.find(key);
    if (now != entries_.end() && now->second.texture) shown = key;
    // While a value is dragged the last picture stays until there is a newer one.
    const auto last = entries_.find(shown);
    if (last == entries_.end() || !last->second.texture) return 0;
    last->second.last_used = frame_;
    return last->second.texture->id();
}

uint64_t Previews::material(const Scene& scene, const Material& material) {
    return rendered_picture(preview_key(scene, material), material.id.value,
                            [&] { return preview_scene(scene, material, kSize); });
}

uint64_t Previews::texture(const Scene& scene, const Texture& texture) {
    if (texture.kind == TextureKind::Image) return image(texture.file.image);
    if (!is_blend(texture.kind)) return 0;
    return rendered_picture(preview_key(scene, texture), texture.id.value | kTextureOwner,
                            [&] { return preview_scene(scene, texture, kSize); });
}

void Previews::ask(uint64_t key, uint64_t owner, std::shared_ptr<const Scene> scene) {
    const std::lock_guard lock(mutex_);
    // What waits for the same thing is out of date; what is seen no more is asked for again.
    std::erase_if(jobs_, [&](const Job& job) {
        if (job.owner != owner) return false;
        entries_.erase(job.key);
        return true;
    });
    jobs_.push_back({key, owner, std::move(scene)});
    while (jobs_.size() > kMostWaiting) {
        entries_.erase(jobs_.front().key);
        jobs_.pop_front();
    }
    wake_.notify_one();
}

uint64_t Previews::image(const std::shared_ptr<const Image>& image) {
    if (!image) return 0;
    Entry& entry = entries_[reinterpret_cast<uint64_t>(image.get())];
    entry.last_used = frame_;
    if (!entry.texture) {
        entry.image = image;
        entry.texture = std::make_unique<GlTexture>(kSize, kSize);
        entry.texture->fill_rgb(image_thumbnail(*image, kSize).data());
    }
    return entry.texture->id();
}

void Previews::begin_frame() {
    ++frame_;
    std::vector<Picture> finished;
    {
        const std::lock_guard lock(mutex_);
        finished.swap(finished_);
    }
    for (const Picture& picture : finished) {
        const auto found = entries_.find(picture.key);
        if (found == entries_.end() || picture.rgb.empty()) continue;
        found->second.texture = std::make_unique<GlTexture>(kSize, kSize);
        found->second.texture->fill_rgb(picture.rgb.data());
        ++rendered_;
    }
    while (entries_.size() > kMost)
        forget_oldest();
}

bool Previews::is_complete() const {
    return std::all_of(entries_.begin(), entries_.end(),
                       [](const auto& entry) { return entry.second.texture != nullptr; });
}

void Previews::forget_oldest() {
    const auto oldest = std::min_element(
        entries_.begin(), entries_.end(),
        [](const auto& a, const auto& b) { return a.second.last_used < b.second.last_used; });
    entries_.erase(oldest);
}

}  // namespace tp
