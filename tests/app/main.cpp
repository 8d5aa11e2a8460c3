// The runner of the window's tests: doctest's options, and
//   --platform null|display   GLFW's null platform with EGL, or a window on the display; without
//                             it, the display where DISPLAY names one
//   --backend host|cuda       what renders
//   --steps N, --seed N       of the random driver
//   --screenshots FOLDER      where tests leave pictures of the window
// and what guide_test.cpp says of its pictures.
// Settings and layouts of the user are not touched: a temporary folder takes their place.
#define DOCTEST_CONFIG_IMPLEMENT
#include "window_test.h"

#include <GLFW/glfw3.h>
#include <doctest/doctest.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>

namespace {

/// A folder that ends with the program.
struct TemporaryFolder {
    TemporaryFolder() {
        std::string name =
            (std::filesystem::temp_directory_path() / "teapath_window.XXXXXX").string();
        path = mkdtemp(name.data());
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path, ignored);
    }
    std::filesystem::path path;
};

}  // namespace

int main(int argc, char** argv) {
    tp::test::WindowTestOptions& options = tp::test::window_test_options();
    const char* display = std::getenv("DISPLAY");
    bool use_null = !display || !*display;
    for (int i = 1; i < argc; ++i)
        options.is_light = options.is_light || std::strcmp(argv[i], "--light") == 0;
    for (int i = 1; i + 1 < argc; ++i) {
        if (std::strcmp(argv[i], "--platform") == 0)
            use_null = std::strcmp(argv[i + 1], "null") == 0;
        if (std::strcmp(argv[i], "--backend") == 0) options.backend = argv[i + 1];
        if (std::strcmp(argv[i], "--steps") == 0) options.steps = std::atoi(argv[i + 1]);
        if (std::strcmp(argv[i], "--seed") == 0)
            options.seed = std::strtoull(argv[i + 1], nullptr, 10);
        if (std::strcmp(argv[i], "--screenshots") == 0) options.screenshots = argv[i + 1];
        if (std::strcmp(argv[i], "--size") == 0)
            std::sscanf(argv[i + 1], "%dx%d", &options.width, &options.height);
        if (std::strcmp(argv[i], "--scale") == 0)
            options.scale = static_cast<float>(std::atof(argv[i + 1]));
        if (std::strcmp(argv[i], "--samples") == 0) options.samples = std::atoi(argv[i + 1]);
        if (std::strcmp(argv[i], "--model") == 0) options.model = argv[i + 1];
        if (std::strcmp(argv[i], "--pictures") == 0) options.pictures = argv[i + 1];
    }
    if (use_null) glfwInitHint(GLFW_PLATFORM, GLFW_PLATFORM_NULL);
    options.is_null_platform = use_null;

    const TemporaryFolder folder;
    options.folder = folder.path;
    for (const char* name :
         {"XDG_CONFIG_HOME", "XDG_STATE_HOME", "XDG_CACHE_HOME", "XDG_DATA_HOME", "HOME"})
        setenv(name, (folder.path / name).c_str(), 1);
    return doctest::Context(argc, argv).run();
}
