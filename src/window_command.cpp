#include "window_command.h"

#include <teapath/app/app.h>
#include <teapath/core/error.h>
#include <teapath/io/model_file.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <string>

namespace tp {

std::optional<int> run_window_command(int argc, char** argv) {
    if (argc == 2 && std::string(argv[1]) == "--print-keys") {
        std::fputs(keys_page().c_str(), stdout);
        return 0;
    }
    const bool names_scene = argc > 1 && (std::filesystem::path(argv[1]).extension() == ".json" ||
                                          can_read_model(argv[1]));
    if (argc > 1 && !names_scene) return std::nullopt;
    AppOptions options;
    CLI::App parser("Opens a scene in the window.", "teapath");
    std::string size;
    parser.add_option("scene", options.scene, "The scene or model file to open");
    parser.add_option("--backend", options.backend, "auto, cuda or host")
        ->check(CLI::IsMember({"auto", "cuda", "host"}));
    parser.add_option("--device", options.device, "CUDA device number");
    parser.add_option("--threads", options.threads, "Threads of the host backend; 0 = all cores");
    parser.add_option("--width", options.width, "Width of the window")
        ->check(CLI::Range(100, 16384));
    parser.add_option("--height", options.height, "Height of the window")
        ->check(CLI::Range(100, 16384));
    parser.add_option("--quit-after", options.quit_after,
                      "Close the window after this many seconds");
    parser.add_option("--screenshot", options.screenshot,
                      "Write the window's picture to this file before closing");
    try {
        parser.parse(argc, argv);
    } catch (const CLI::Success& success) {
        return parser.exit(success);
    } catch (const CLI::ParseError& error) {
        throw Error(ErrorKind::Usage, error.what(), "",
                    fmt::format("to render it: teapath render {} -o image.png; see teapath --help",
                                names_scene ? argv[1] : "scene.json"));
    }
    return run_app(options);
}

}  // namespace tp
