// A render from its first sample to its files: what `teapath render` and the window's export share,
// so that both write the same picture. It stands here because files are made out of films and io,
// the lower module, knows no film.
#pragma once

#include <teapath/render/film_image.h>
#include <teapath/render/session.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace tp {

/// Where a render ends: at the first of these that is reached; 0 = no limit.
struct RenderGoal {
    int64_t samples = 0;  // per pixel
    double seconds = 0;
};

/// Adds samples until the goal is reached, `stop` answers true or the session is cancelled; at
/// least one sample otherwise. `done` is told the samples after each step. Returns the seconds
/// taken.
double render_until(Session& session, const RenderGoal& goal,
                    const std::function<void(int64_t)>& done, const std::function<bool()>& stop);

struct RenderedImage {
    int width = 0;
    int height = 0;
    FilmImage film;                // empty if no file holds radiance
    std::vector<float> noisy;      // radiance before it was denoised; empty if it was not
    std::vector<uint8_t> display;  // RGB; empty if no file holds bytes

    std::map<std::string, std::string> metadata;  // the same for each run of the same render
    std::map<std::string, std::string> run;  // of this run, such as its time; EXR only, so that
                                             // the other files are the same byte for byte
};

/// What the files hold of a session that has synced `scene`: film or bytes as their formats need,
/// and how it was made. `scene_name` is for people, such as the name of the scene's file.
RenderedImage rendered_image(const Session& session, const Scene& scene,
                             const std::string& scene_name,
                             const std::vector<std::filesystem::path>& files, double seconds);

/// Writes every file, each whole or not at all. If one fails, the others are still written, then
/// its Error is thrown.
void write_files(const std::vector<std::filesystem::path>& files, const RenderedImage& image);

}  // namespace tp
