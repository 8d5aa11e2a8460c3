#include "export_job.h"

#include <teapath/core/error.h>
#include <teapath/core/log.h>
#include <teapath/render/output_files.h>
#include <teapath/render/rendered_image.h>
#include <teapath/render/session.h>
#include <teapath/scene/camera_path.h>
#include <teapath/scene/pose.h>
#include <teapath/scene/validate.h>

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <memory>

namespace tp {
namespace {

namespace fs = std::filesystem;

// Where the whole export is, told to the job's control.
class ExportProgress {
public:
    ExportProgress(const ExportSettings& settings, JobControl& control)
        : settings_(settings), control_(control) {}

    void update(int frame, int64_t samples) {
        const int frames = frame_count(settings_);
        const double share =
            (frame + static_cast<double>(samples) / settings_.samples) / std::max(1, frames);
        std::string text = fmt::format("{} / {} spp", samples, settings_.samples);
        if (frames > 1) text = fmt::format("frame {} of {}, {}", frame + 1, frames, text);
        if (share > 0 && share < 1)
            text += fmt::format(", {} left", clock_text(seconds() * (1 - share) / share));
        control_.set_progress(share, text);
    }

    double seconds() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }

private:
    const ExportSettings& settings_;
    JobControl& control_;
    const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

std::vector<fs::path> files_of(const ExportSettings& settings) {
    std::vector<fs::path> files;
    for (int frame = 0; frame < frame_count(settings); ++frame)
        files.push_back(frame_file(settings, frame));
    return files;
}

// The way of the camera, n-th frame.
Camera camera_of(const Scene& scene, const ExportSettings& settings, int frame) {
    const int frames = frame_count(settings);
    const Camera camera = active_camera(scene);
    if (settings.motion == ExportMotion::Turntable)
        return camera_on_turntable(camera, static_cast<double>(frame) / frames);
    if (settings.motion == ExportMotion::Bookmarks) {
        const std::vector<Camera> keys = bookmark_cameras(scene);
        Camera on_path =
            camera_on_path(keys, frames > 1 ? static_cast<double>(frame) / (frames - 1) : 0);
        on_path.id = camera.id;
        on_path.name = camera.name;
        return on_path;
    }
    return camera;
}

}  // namespace

ExportSettings export_settings_of(const Scene& scene) {
    ExportSettings settings;
    settings.width = scene.render.width;
    settings.height = scene.render.height;
    settings.samples = scene.render.samples;
    settings.seed = scene.render.path.seed;
    settings.camera = active_camera(scene).id;
    return settings;
}

int frame_count(const ExportSettings& settings) {
    return settings.motion == ExportMotion::Still ? 1 : std::max(1, settings.frames);
}

double frame_time(const ExportSettings& settings, int frame) {
    return frame / settings.frames_per_second;
}

fs::path frame_file(const ExportSettings& settings, int frame) {
    if (settings.motion == ExportMotion::Still) return settings.file;
    fs::path name = settings.file.stem();
    name += fmt::format("_{:04}", frame + 1);
    name += settings.file.extension();
    return settings.file.parent_path() / name;
}

Scene export_scene(const Scene& scene, const ExportSettings& settings, int frame) {
    Scene changed = scene;
    changed.render.width = settings.width;
    changed.render.height = settings.height;
    changed.render.samples = settings.samples;
    changed.render.path.seed =
        settings.seed + (settings.new_seeds ? static_cast<uint64_t>(frame) : 0);
    if (find(changed, settings.camera)) changed.active_camera = settings.camera;
    if (settings.motion == ExportMotion::Animation)
        changed.render.time = frame_time(settings, frame);
    const Camera camera = camera_of(changed, settings, frame);
    for (Camera& c : changed.cameras)
        if (c.id == camera.id) c = camera;
    return changed;
}

std::string why_not_exported(const Scene& scene, const ExportSettings& settings) {
    if (settings.file.empty()) return "choose a file first";
    if (settings.motion == ExportMotion::Bookmarks && bookmark_cameras(scene).size() < 2)
        return "the way needs two bookmarks at least (Ctrl with 1 to 9 sets them)";
    if (settings.motion == ExportMotion::Animation && !(animation_length(scene) > 0))
        return "no model of the scene has an animation that plays";
    try {
        check_outputs({frame_file(settings, 0)});
        for (const Problem& problem : validate(export_scene(scene, settings, 0)))
            if (problem.fatal) return fmt::format("{}: {}", problem.where, problem.what);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

ExportResult run_export(const Scene& scene, const std::string& scene_name,
                        const ExportSettings& settings, JobControl& control) {
    const std::vector<fs::path> files = files_of(settings);
    check_outputs(files);
    Session session({settings.backend, settings.device, settings.threads,
                     settings.features && any_has(files, FileContent::Layers)});
    control.set_cancel_hook([&session](bool keep) {
        if (!keep) session.cancel();
    });
    const struct HookEnd {
        JobControl& control;
        ~HookEnd() { control.set_cancel_hook(nullptr); }
    } hook_end{control};

    ExportProgress progress(settings, control);
    ExportResult result;
    for (int frame = 0; frame < frame_count(settings) && !control.is_cancelled(); ++frame) {
        const auto shown = std::make_shared<const Scene>(export_scene(scene, settings, frame));
        progress.update(frame, 0);
        session.sync(shown);
        session.restart();
        const double seconds = render_until(
            session, {settings.samples, 0}, [&](int64_t done) { progress.update(frame, done); },
            [&] { return control.is_cancelled(); });
        if (control.is_cancelled() && !control.keeps()) break;
        const std::vector<fs::path> file = {files[static_cast<size_t>(frame)]};
        write_files(file, rendered_image(session, *shown, scene_name, file, seconds));
        result.files.push_back(file.front());
    }
    result.is_whole = !control.is_cancelled();
    result.seconds = progress.seconds();
    if (control.is_cancelled() && !control.keeps()) {
        std::error_code ignored;
        for (const fs::path& file : result.files)
            fs::remove(file, ignored);
        result.files.clear();
    }
    if (const RenderCounters counters = session.counters(); counters.invalid_samples > 0)
        log_warning("export: {} of {} samples had NaN or infinite radiance and count as black",
                    counters.invalid_samples, counters.samples);
    return result;
}

std::string clock_text(double seconds) {
    const auto whole = static_cast<int64_t>(std::clamp(seconds, 0.0, 3.6e8) + 0.5);
    if (whole >= 3600)
        return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
    return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

}  // namespace tp
