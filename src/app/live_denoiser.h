// What the window shows while the picture is denoised: the noisy one at once, then one without
// noise as often as that can be afforded.
#pragma once

#include <teapath/render/denoised.h>
#include <teapath/scene/scene.h>

#include <chrono>
#include <memory>
#include <optional>

namespace tp {

class LiveDenoiser {
public:
    /// The next picture to show of a session that has synced `scene`; nothing: what is shown stays.
    /// `is_preview`: at a lower resolution while something moves. `is_last`: the render rests.
    std::optional<DisplayImage> next(const Session& session,
                                     const std::shared_ptr<const Scene>& scene, bool is_preview,
                                     bool is_last);

private:
    using Clock = std::chrono::steady_clock;

    FilmDenoiser denoiser_;
    bool has_failed_ = false;  // then the noise stays, and the log has said why
    uint64_t shown_film_ = ~uint64_t{0};
    std::shared_ptr<const Scene> shown_scene_;  // of the last denoised picture
    Clock::time_point end_;                     // of the last one
    double seconds_ = 0;                        // that it took
};

}  // namespace tp
