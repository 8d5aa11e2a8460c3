#include <teapath/core/error.h>
#include <teapath/core/log.h>
#include <teapath/io/image_file.h>
#include <teapath/render/denoised.h>
#include <teapath/render/output_files.h>
#include <teapath/render/rendered_image.h>
#include <teapath/render/scheduler.h>
#include <teapath/scene/enum_tables.h>

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <optional>
#include <utility>

namespace tp {
namespace {

// Short enough that a cancel feels prompt, long enough that a step's fixed cost does not count.
constexpr double kStepSeconds = 0.25;

// The backend without what differs from run to run, such as the number of threads.
std::string backend_kind(const Session& session) {
    const std::string name = session.backend_name();
    return name.substr(0, name.find(','));
}

std::map<std::string, std::string> metadata(const std::string& scene_name, const Scene& scene,
                                            const Session& session) {
    const PathSettings& path = scene.render.path;
    return {{"program", "Teapath"},
            {"version", TEAPATH_VERSION},
            {"scene", scene_name},
            {"camera", active_camera(scene).name},
            {"seed", fmt::to_string(path.seed)},
            {"samples", fmt::to_string(session.samples())},
            {"size", fmt::format("{}x{}", scene.render.width, scene.render.height)},
            {"depth", fmt::to_string(path.max_depth)},
            {"integrator", std::string(enum_name(path.integrator))},
            {"sampler", std::string(enum_name(path.sampler))},
            {"exposure", fmt::to_string(scene.display.exposure)},
            {"tone_curve", std::string(enum_name(scene.display.curve))},
            {"backend", backend_kind(session)}};
}

// Adds a plane of the film as a layer, unless it is empty.
template <class Value>
void add_layer(Picture& picture, const std::string& name, std::vector<std::string> channels,
               const std::vector<Value>& values) {
    if (values.empty()) return;
    picture.linear.push_back({name, std::move(channels), {values.begin(), values.end()}});
}

ImageLayer beauty_layer(const FilmImage& film, bool with_alpha) {
    if (!with_alpha) return {"", {"R", "G", "B"}, film.radiance};
    ImageLayer layer{"", {"R", "G", "B", "A"}, {}};
    layer.values.reserve(film.alpha.size() * 4);
    for (size_t i = 0; i < film.alpha.size(); ++i) {
        layer.values.insert(layer.values.end(), {film.radiance[3 * i], film.radiance[3 * i + 1],
                                                 film.radiance[3 * i + 2], film.alpha[i]});
    }
    return layer;
}

// The film as the layers of an EXR file.
void add_all_layers(Picture& picture, const FilmImage& film, const std::vector<float>& noisy) {
    picture.linear.push_back(beauty_layer(film, !film.alpha.empty()));
    add_layer(picture, "albedo", {"R", "G", "B"}, film.albedo);
    add_layer(picture, "normal", {"X", "Y", "Z"}, film.normal);
    add_layer(picture, "depth", {"Z"}, film.depth);
    add_layer(picture, "object_id", {"id"}, film.object_id);
    add_layer(picture, "material_id", {"id"}, film.material_id);
    add_layer(picture, "standard_error", {"Y"}, film.standard_error);
    const std::vector<float> counts(film.radiance.size() / 3, static_cast<float>(film.samples));
    add_layer(picture, "samples", {"count"}, counts);
    add_layer(picture, "noisy", {"R", "G", "B"}, noisy);
}

Picture picture_for(const std::filesystem::path& file, const RenderedImage& image) {
    Picture picture{image.width, image.height, {}, {}, image.metadata};
    switch (content_of(file)) {
        case FileContent::Display: picture.display = image.display; break;
        case FileContent::Radiance:
            picture.linear.push_back(beauty_layer(image.film, false));
            break;
        case FileContent::Layers:
            add_all_layers(picture, image.film, image.noisy);
            picture.metadata.insert(image.run.begin(), image.run.end());
            break;
    }
    return picture;
}

// Replaces the picture by one without noise, if the scene asks for it and it can be had.
void denoise(const Session& session, const Scene& scene, RenderedImage& image) {
    if (!scene.render.denoise || !(scene.render.denoise_strength > 0)) return;
    try {
        FilmDenoiser denoiser;
        FilmImage film = image.film.radiance.empty() ? session.film() : image.film;
        std::vector<float> noisy = film.radiance;
        denoiser.clean(session, film, scene.render.denoise_strength, DenoiseQuality::Final);
        if (!image.display.empty()) image.display = display_bytes(film, scene.display, 3);
        if (!image.film.radiance.empty()) {
            image.film = std::move(film);
            image.noisy = std::move(noisy);
        }
        image.metadata["denoiser"] = denoiser.name();
    } catch (const Error& error) {
        log_warning("{}; the picture keeps its noise", error.what());
    }
}

}  // namespace

double render_until(Session& session, const RenderGoal& goal,
                    const std::function<void(int64_t)>& done, const std::function<bool()>& stop) {
    const auto start = std::chrono::steady_clock::now();
    const auto seconds = [&] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    StepHistory history;
    history.target = goal.samples > 0 ? goal.samples : std::numeric_limits<int64_t>::max();
    double now = 0;
    for (;;) {
        const double left = goal.seconds > 0 ? goal.seconds - now : kStepSeconds;
        history.budget_seconds = std::clamp(left, 0.0, kStepSeconds);
        const int64_t samples = next_samples(history);
        if (samples == 0) break;

        const double before = now;
        if (!session.step(samples)) break;
        now = seconds();
        history.done += samples;
        history.last_samples = samples;
        history.last_seconds = now - before;
        done(history.done);

        // The next sample is not worth starting if most of it would lie past the end.
        const double sample_seconds = history.last_seconds / static_cast<double>(samples);
        if (stop()) break;
        if (goal.seconds > 0 && now + sample_seconds / 2 >= goal.seconds) break;
    }
    return now;
}

RenderedImage rendered_image(const Session& session, const Scene& scene,
                             const std::string& scene_name,
                             const std::vector<std::filesystem::path>& files, double seconds) {
    RenderedImage image;
    image.width = scene.render.width;
    image.height = scene.render.height;
    if (any_has(files, FileContent::Radiance) || any_has(files, FileContent::Layers))
        image.film = session.film();
    if (any_has(files, FileContent::Display)) image.display = session.display();
    image.metadata = metadata(scene_name, scene, session);
    denoise(session, scene, image);
    image.run = {{"seconds", fmt::format("{:.3f}", seconds)}, {"backend", session.backend_name()}};
    return image;
}

void write_files(const std::vector<std::filesystem::path>& files, const RenderedImage& image) {
    std::optional<Error> first_error;
    for (const std::filesystem::path& file : files) {
        try {
            write_picture(file, picture_for(file, image));
        } catch (const Error& error) {
            if (!first_error) first_error = error;
        }
    }
    if (first_error) throw *first_error;
}

}  // namespace tp
