#include "render_frames.h"

#include "render_loop.h"
#include "status.h"

#include <teapath/core/error.h>
#include <teapath/render/output_files.h>
#include <teapath/render/rendered_image.h>

#include <fmt/format.h>

#include <memory>

namespace tp {
namespace {

namespace fs = std::filesystem;

// Renders the scene at its time. False: cut short, and nothing is written.
bool render_frame(const RenderOptions& options, std::shared_ptr<const Scene> scene,
                  const std::vector<fs::path>& files, const ProgressGoal& goal, Session& session,
                  Progress& progress, const Interrupt& interrupt) {
    session.sync(scene);
    session.restart();
    progress.begin_frame();
    const double seconds =
        render_until(session, goal, progress, [&] { return interrupt.requested(); });
    const bool is_whole = goal.samples > 0 && session.samples() >= goal.samples;
    if (interrupt.requested() && !is_whole) return false;
    write_files(files,
                rendered_image(session, *scene, options.scene.filename().string(), files, seconds));
    return true;
}

}  // namespace

fs::path frame_path(const fs::path& pattern, int frame) {
    const std::string name = pattern.filename().string();
    const size_t end = name.find_last_of('#');
    if (end == std::string::npos)
        throw Error(ErrorKind::Usage,
                    fmt::format("{} has no place for the number of the frame", pattern.string()),
                    "--output", "write #### where it is to stand, as in -o frame_####.png");
    size_t begin = end;
    while (begin > 0 && name[begin - 1] == '#')
        --begin;
    return pattern.parent_path() / fmt::format("{}{:0{}}{}", name.substr(0, begin), frame,
                                               end - begin + 1, name.substr(end + 1));
}

std::vector<fs::path> frame_paths(const RenderOptions& options, int frame) {
    std::vector<fs::path> files;
    for (const fs::path& pattern : options.outputs)
        files.push_back(frame_path(pattern, frame));
    return files;
}

int render_frames(const RenderOptions& options, const Scene& scene, Session& session,
                  Interrupt& interrupt) {
    const FrameRange range = *options.frames;
    const bool open_ended = options.seconds && !options.samples;
    const ProgressGoal goal{open_ended ? 0 : scene.render.samples,
                            options.seconds.value_or(scene.render.seconds),
                            int64_t{scene.render.width} * scene.render.height, range.count()};
    interrupt.begin_saving();
    int written = 0;
    double seconds = 0;
    {
        Progress progress(options.quiet ? ProgressStyle::Quiet : progress_style_of_stderr(), goal,
                          [&] { return interrupt.requested(); });
        for (int frame = range.first; frame <= range.last && !interrupt.requested(); ++frame) {
            auto shown = std::make_shared<Scene>(scene);
            shown->render.time = frame / options.frames_per_second;
            const std::vector<fs::path> files = frame_paths(options, frame);
            if (!render_frame(options, shown, files, goal, session, progress, interrupt)) break;
            ++written;
        }
        seconds = progress.seconds();
    }
    if (!options.quiet)
        print_status(
            fmt::format("wrote {} of {} frames in {:.1f} s\n", written, range.count(), seconds));
    if (written == range.count()) return 0;
    print_status("interrupted: the frames so far are there\n");
    return kInterruptedExitCode;
}

}  // namespace tp
