// The window program.
#pragma once

#include <filesystem>
#include <string>

namespace tp {

struct AppOptions {
    std::filesystem::path scene;  // empty: a fresh scene
    std::string backend = "auto";
    int device = 0;
    int threads = 0;
    int width = 0;  // of the window, in screen coordinates; 0: as it was last, else 1280 x 720
    int height = 0;
    double quit_after = 0;             // seconds; 0 = never; for tests
    std::filesystem::path screenshot;  // written before quitting, for tests
};

/// Opens the window and runs until it is closed. Returns the exit code. Throws Error where no
/// window can be opened.
int run_app(const AppOptions& options);

/// The table of keys as shipped, as a Markdown page: docs/keys.md.
std::string keys_page();

/// True if a display is there to open a window on.
bool has_display();

}  // namespace tp
