#include "live_denoiser.h"

#include <teapath/core/error.h>
#include <teapath/core/log.h>

#include <algorithm>

namespace tp {
namespace {

constexpr double kLeastPause = 0.1;  // seconds between two denoised pictures
constexpr double kPauseShare = 2;    // and this many times as long as one takes

DisplayImage denoised_image(FilmDenoiser& denoiser, const Session& session, const Scene& scene) {
    FilmImage film = session.film();
    denoiser.clean(session, film, scene.render.denoise_strength, DenoiseQuality::Live);
    return {film.width, film.height, film.samples, display_bytes(film, scene.display, 4), nullptr};
}

}  // namespace

std::optional<DisplayImage> LiveDenoiser::next(const Session& session,
                                               const std::shared_ptr<const Scene>& scene,
                                               bool is_preview, bool is_last) {
    const bool wanted = scene->render.denoise && scene->render.denoise_strength > 0;
    const bool is_new = shown_film_ != session.film_number();
    shown_film_ = session.film_number();
    if (!wanted || is_preview || has_failed_ || (is_new && !is_last)) {
        shown_scene_.reset();
        end_ = Clock::now();
        return session.display_image();
    }
    const double pause = std::chrono::duration<double>(Clock::now() - end_).count();
    const bool is_changed = shown_scene_ && shown_scene_ != scene;
    if (!is_last && !is_changed && pause < std::max(kLeastPause, kPauseShare * seconds_))
        return std::nullopt;
    try {
        const Clock::time_point start = Clock::now();
        DisplayImage image = denoised_image(denoiser_, session, *scene);
        end_ = Clock::now();
        seconds_ = std::chrono::duration<double>(end_ - start).count();
        shown_scene_ = scene;
        return image;
    } catch (const Error& error) {
        log_warning("{}; the picture keeps its noise", error.what());
        has_failed_ = true;
        return session.display_image();
    }
}

}  // namespace tp
