// A session's film without its noise, and how it looks.
#pragma once

#include <teapath/denoise/denoiser.h>
#include <teapath/kernel/settings.h>
#include <teapath/render/film_image.h>
#include <teapath/render/session.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tp {

/// Keeps the denoiser and what guides it between pictures of one film. One thread uses it.
class FilmDenoiser {
public:
    /// Takes the noise out of the radiance of the session's film; `strength` 0 to 1 blends from the
    /// noisy one. Throws Error(Device) where there is no denoiser or it fails.
    void clean(const Session& session, FilmImage& film, double strength, DenoiseQuality quality);

    std::string name() const { return denoiser_ ? denoiser_->name() : std::string(); }

private:
    std::optional<Denoiser> denoiser_;
    std::optional<FilmImage> guides_;
    uint64_t guided_film_ = 0;
};

/// The film after exposure and tone curve, `channels` 3 or 4 bytes a pixel (opaque), as a backend
/// makes them.
std::vector<uint8_t> display_bytes(const FilmImage& film, const DisplaySettings& display,
                                   int channels);

}  // namespace tp
