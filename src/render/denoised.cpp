#include <teapath/core/parallel.h>
#include <teapath/kernel/post.h>
#include <teapath/render/denoised.h>

#include <algorithm>

namespace tp {
namespace {

// Camera rays that each pixel's albedo and normal are means of.
constexpr int64_t kLiveGuides = 4, kFinalGuides = 64;

}  // namespace

void FilmDenoiser::clean(const Session& session, FilmImage& film, double strength,
                         DenoiseQuality quality) {
    if (!(strength > 0) || film.samples == 0) return;
    if (!denoiser_) denoiser_.emplace(session.backend_kind() == BackendKind::Cuda);
    const int64_t wanted = quality == DenoiseQuality::Final ? kFinalGuides : kLiveGuides;
    if (!guides_ || guides_->samples < wanted || guided_film_ != session.film_number())
        guides_ = session.guides(wanted);
    guided_film_ = session.film_number();
    const std::vector<float> without = denoiser_->run(
        {film.width, film.height, film.radiance, guides_->albedo, guides_->normal}, quality);
    const auto share = static_cast<float>(std::min(strength, 1.0));
    for (size_t i = 0; i < without.size(); ++i)
        film.radiance[i] += (without[i] - film.radiance[i]) * share;
}

std::vector<uint8_t> display_bytes(const FilmImage& film, const DisplaySettings& display,
                                   int channels) {
    const size_t pixels = film.radiance.size() / 3;
    std::vector<uint8_t> bytes(pixels * static_cast<size_t>(channels));
    parallel_for(static_cast<int64_t>(pixels), 16384, [&](int64_t first, int64_t last) {
        for (auto i = static_cast<size_t>(first); i < static_cast<size_t>(last); ++i) {
            const float* r = &film.radiance[3 * i];
            const Rgb8 c = display_color(Vec3(r[0], r[1], r[2]), display);
            uint8_t* out = &bytes[i * static_cast<size_t>(channels)];
            out[0] = c.r;
            out[1] = c.g;
            out[2] = c.b;
            if (channels == 4) out[3] = 255;
        }
    });
    return bytes;
}

}  // namespace tp
