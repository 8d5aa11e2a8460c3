// `teapath render`: a scene file in, image files out.
#include "arguments.h"
#include "command.h"
#include "help_format.h"
#include "interrupt.h"
#include "progress.h"
#include "render_frames.h"
#include "render_loop.h"
#include "render_options.h"
#include "status.h"
#include "version.h"

#include <teapath/core/error.h>
#include <teapath/core/log.h>
#include <teapath/io/scene_file.h>
#include <teapath/render/output_files.h>
#include <teapath/render/rendered_image.h>
#include <teapath/render/session.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>

namespace tp {
namespace {

constexpr const char* kFooter =
    R"(Formats, by extension: png, jpg, bmp, tga and ppm (p3.ppm: as text) hold the
picture after exposure and tone curve; hdr, pfm and exr hold linear radiance,
exr also alpha, albedo, normal, depth, ids, standard error and samples as layers.

Ctrl-C ends the render after the step under way and saves what is there, of frames
those that are whole; a second one leaves at once.

Examples:
  teapath render scenes/cornell_box.json -o box.png
  teapath render scenes/cornell_box.json -o box.png -o box.exr --size 800x800
  teapath render scenes/cornell_box.json -o box.jpg --time 60 --backend cuda
  teapath render scenes/cornell_box.json -o box.png --set display.exposure=1.5
  teapath render walk.glb -o walk_####.png --frames 0-47 --fps 24
  teapath render walk.glb -o step.png --set render.time=0.5)";

constexpr int kMaxThreads = 1024;
constexpr int kMaxDevice = 1023;

// The options as typed.
struct Words {
    std::optional<std::string> scene, spp, time, size, depth, seed, camera, backend, device,
        threads, frames, fps;
    std::vector<std::string> outputs, settings;
    bool quiet = false, denoise = false;
};

void add_options(CLI::App& parser, Words& words) {
    const auto add = [&](const char* name, std::optional<std::string>& word, const char* value,
                         const char* description) {
        parser
            .add_option_function<std::string>(
                name, [&word](const std::string& text) { word = text; }, description)
            ->option_text(value);
    };
    const auto add_many = [&](const char* name, std::vector<std::string>& list, const char* value,
                              const char* description) {
        parser.add_option(name, list, description)
            ->option_text(value)
            ->take_all()
            ->allow_extra_args(false);
    };
    add("SCENE", words.scene, "", "The scene, a JSON file, or a model");
    add_many("-o,--output", words.outputs, "FILE", "Picture to write; may be given several times");
    add("--spp", words.spp, "N", "Samples per pixel, instead of the scene's");
    add("--time", words.time, "SECONDS",
        "Stop after this time, with at least one sample; without --spp there is no other limit");
    add("--size", words.size, "WxH", "Size in pixels, instead of the scene's");
    add("--depth", words.depth, "N", "Segments of a path at most, 1 = light seen by the camera");
    add("--seed", words.seed, "N|random", "One picture for each seed; random: from the clock");
    add("--frames", words.frames, "A-B",
        "Frames of the models' animations; the numbers stand for #### in the names of files");
    add("--fps", words.fps, "N", "Frames a second: frame n is n/N seconds in (24)");
    add("--camera", words.camera, "NAME", "One of the scene's cameras");
    add_many("--set", words.settings, "PATH=VALUE",
             "Any setting of the scene, as in render.sampler=sobol; may be given several times");
    add("--backend", words.backend, "auto|cuda|host",
        "Where to render (auto: CUDA where it works)");
    add("--device", words.device, "N", "Number of the CUDA device; teapath info lists them");
    add("--threads", words.threads, "N", "Threads of the host backend, instead of one a core");
    parser.add_flag("--denoise", words.denoise, "Take the noise away (Open Image Denoise)")
        ->disable_flag_override();
    parser.add_flag("-q,--quiet", words.quiet, "Only warnings and errors")->disable_flag_override();
}

RenderOptions parse_options(const Words& words) {
    const auto whole = [](const char* option, const std::optional<std::string>& word, int low,
                          int high) -> std::optional<int> {
        if (!word) return std::nullopt;
        return static_cast<int>(parse_whole(option, *word, low, high));
    };
    RenderOptions options;
    if (!words.scene)
        throw Error(ErrorKind::Usage, "no scene is named", "",
                    "as in teapath render scene.json -o image.png");
    options.scene = *words.scene;
    options.outputs.assign(words.outputs.begin(), words.outputs.end());
    options.samples = whole("--spp", words.spp, 1, kMaxSamples);
    if (words.time) options.seconds = parse_seconds("--time", *words.time);
    if (words.size) options.size = parse_size("--size", *words.size);
    options.depth = whole("--depth", words.depth, 1, kMaxPathDepth);
    if (words.frames) options.frames = parse_frames("--frames", *words.frames);
    if (words.fps) {
        if (!options.frames)
            throw Error(ErrorKind::Usage, "there are no frames", "--fps",
                        "say which, as in --frames 0-47");
        options.frames_per_second = parse_frame_rate("--fps", *words.fps);
    }
    if (words.seed) options.seed = parse_seed("--seed", *words.seed);
    options.camera = words.camera;
    options.settings = words.settings;
    if (words.backend) options.backend = parse_backend("--backend", *words.backend);
    options.threads = whole("--threads", words.threads, 1, kMaxThreads).value_or(0);
    options.quiet = words.quiet;
    options.denoise = words.denoise;

    // Who names a device means it: no falling back to the host.
    if (const auto device = whole("--device", words.device, 0, kMaxDevice)) {
        options.device = *device;
        if (options.backend == BackendKind::Host)
            throw Error(ErrorKind::Usage, "the host backend has no device numbers", "--device",
                        "leave it out, or render with --backend cuda");
        options.backend = BackendKind::Cuda;
    }
    return options;
}

std::string start_text(const RenderOptions& options, const Scene& scene, const Session& session) {
    std::string limit = options.seconds ? fmt::format("{} s", *options.seconds)
                                        : fmt::format("{} spp", scene.render.samples);
    if (!options.seconds && scene.render.seconds > 0)
        limit += fmt::format(" or {} s", scene.render.seconds);
    return fmt::format("{}: {} x {}, {}, seed {}, on {}\n", options.scene.filename().string(),
                       scene.render.width, scene.render.height, limit, scene.render.path.seed,
                       session.backend_name());
}

std::string end_text(const Session& session, int64_t pixels, double seconds) {
    const double rate = static_cast<double>(session.samples() * pixels) / std::max(seconds, 1e-9);
    return fmt::format("{} spp in {:.{}f} s, {}\n", session.samples(), seconds,
                       seconds < 10 ? 2 : 1, rate_text(rate));
}

void warn_of_invalid_samples(const RenderCounters& counters) {
    if (counters.invalid_samples == 0) return;
    log_warning(
        "{} of {} samples had a radiance that is NaN, infinite or beyond {:g}; they count "
        "as black (look for such numbers in images, and for lights that are too strong)",
        counters.invalid_samples, counters.samples, kMaxRadiance);
}

int render(const RenderOptions& options) {
    Interrupt interrupt;
    if (options.quiet) set_log_level(LogLevel::Warning);

    // Everything that can go wrong early, early.
    // The frames' files differ in their numbers alone.
    check_outputs(options.frames ? frame_paths(options, options.frames->first) : options.outputs);
    const auto scene =
        std::make_shared<const Scene>(apply_options(load_scene(options.scene), options));
    SessionOptions session_options{options.backend, options.device, options.threads,
                                   any_has(options.outputs, FileContent::Layers)};
    Session session(session_options);
    session.sync(scene);
    if (!options.quiet) print_status(start_text(options, *scene, session));

    if (options.frames) {
        const int code = render_frames(options, *scene, session, interrupt);
        warn_of_invalid_samples(session.counters());
        return code;
    }

    // Samples, until there are enough.
    const int64_t pixels = int64_t{scene->render.width} * scene->render.height;
    const bool open_ended = options.seconds && !options.samples;
    const ProgressGoal goal{open_ended ? 0 : scene->render.samples,
                            options.seconds.value_or(scene->render.seconds), pixels};
    interrupt.begin_saving();
    const auto stopping = [&] { return interrupt.requested(); };
    double seconds = 0;
    {
        Progress progress(options.quiet ? ProgressStyle::Quiet : progress_style_of_stderr(), goal,
                          stopping);
        seconds = render_until(session, goal, progress, stopping);
    }
    const bool cut_short =
        interrupt.requested() && (open_ended || session.samples() < scene->render.samples);
    if (!options.quiet) print_status(end_text(session, pixels, seconds));
    warn_of_invalid_samples(session.counters());

    // The picture.
    const RenderedImage image = rendered_image(session, *scene, options.scene.filename().string(),
                                               options.outputs, seconds);
    write_files(options.outputs, image);
    if (!options.quiet)
        for (const auto& file : options.outputs)
            print_status(fmt::format("wrote {}\n", file.string()));
    if (cut_short) {
        print_status("interrupted: the picture holds the samples so far\n");
        return kInterruptedExitCode;
    }
    return 0;
}

}  // namespace

Command add_render_command(CLI::App& program) {
    CLI::App* parser = program.add_subcommand("render", "Render a scene to image files");
    parser->formatter(std::make_shared<HelpFormat>("SCENE -o FILE [-o FILE] [OPTIONS]"));
    parser->footer(kFooter);
    const auto words = std::make_shared<Words>();
    add_options(*parser, *words);
    return {parser, [words] { return render(parse_options(*words)); }};
}

}  // namespace tp
