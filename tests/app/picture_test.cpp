// What the window shows is what `teapath render` writes: decision 7 of the design.
#include "window_test.h"

#include <teapath/cli/program.h>
#include <teapath/io/image_file.h>
#include <teapath/io/scene_file.h>

#include <doctest/doctest.h>

#include <cstdint>
#include <string>
#include <vector>

using namespace tp;
using namespace tp::test;

namespace {

// The pixels that the command line gives the file at this size.
std::vector<uint8_t> rendered(const std::filesystem::path& file, int width, int height) {
    const std::filesystem::path out = window_test_options().folder / "rendered.png";
    const std::string size = std::to_string(width) + "x" + std::to_string(height);
    const std::string& backend = window_test_options().backend;
    const char* arguments[] = {"teapath",   "render",        file.c_str(), "--size",   size.c_str(),
                               "--backend", backend.c_str(), "-o",         out.c_str()};
    REQUIRE(run_command_line(static_cast<int>(std::size(arguments)), arguments) == 0);
    const Image image = read_image(out);
    std::vector<uint8_t> bytes;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (int c = 0; c < 3; ++c)
                bytes.push_back(static_cast<uint8_t>(
                    image.bytes[static_cast<size_t>((y * image.width + x) * image.channels + c)]));
    return bytes;
}

}  // namespace

TEST_CASE("picture: the window's pixels are those of teapath render, exactly") {
    for (const char* name : {"small", "cornell_box", "showcase"}) {
        INFO(std::string(name));
        Scene scene =
            std::string(name) == "small" ? small_scene() : load_scene(shipped_scene(name));
        scene.render.samples = 3;
        scene.render.path.seed = 12345;
        scene.display.exposure = 0.3f;
        WindowTest t(scene, 700, 480);
        // An edit and a flight on the way: the picture is that of the scene as it is at the end.
        t.app->document.edit("Change", "", [](Scene& s) { s.render.path.max_depth = 6; });
        t.frames(5);
        Camera camera = t.camera();
        camera.look_from += (camera.look_at - camera.look_from) * 0.05;
        t.app->document.fly(camera);
        t.frames(2);
        const std::filesystem::path file = window_test_options().folder / "saved.json";
        t.app->document.save(file);
        REQUIRE(t.frames_until(
            [&] {
                return t.app->status.scene == t.app->document.snapshot() && t.app->status.is_done &&
                       !t.app->status.is_preview &&
                       t.app->texture.width() == t.app->ui.viewport.width;
            },
            60));
        t.frames(2);
        const int width = t.app->texture.width(), height = t.app->texture.height();
        CHECK(t.app->status.samples == 3);
        CHECK(t.app->texture.pixels() == rendered(file, width, height));
    }
}
