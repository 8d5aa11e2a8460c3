// Frame times of the window: bench_window [SCENE] [SECONDS] [auto|cuda|host] [soak]. Opens it,
// plays each situation for some seconds, and prints the median and the 99th percentile of the time
// that a frame takes of the interface's thread: all of it, and without the driver's drawing and
// swap; and what the picture's way to the screen takes.
// With `soak` it plays all of them in turn, with other sizes and other scenes between, for that
// many seconds, and prints what memory is held.
#include "application.h"
#include "figures.h"

#include <teapath/core/error.h>
#include <teapath/editor/scene_edits.h>

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <string>
#include <thread>
#include <vector>

namespace {

using Clock = std::chrono::steady_clock;

double ms_since(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

double quantile(std::vector<double> values, double q) {
    if (values.empty()) return 0;
    std::sort(values.begin(), values.end());
    return values[static_cast<size_t>(q * static_cast<double>(values.size() - 1))];
}

void rest_of_frame(Clock::time_point begin) {
    const double rest = 1000.0 / 60 - ms_since(begin);
    if (rest > 0) std::this_thread::sleep_for(std::chrono::duration<double, std::milli>(rest));
}

// Plays frames at sixty a second at most; `act` changes something before each.
void play(tp::App& app, const char* name, double seconds, const std::function<void(int)>& act) {
    std::vector<double> frame, interface, interval, show;
    const auto start = Clock::now();
    auto last = start;
    for (int i = 0; ms_since(start) < seconds * 1e3; ++i) {
        const auto begin = Clock::now();
        act(i);
        app.draw_frame(0);
        app.window.show();
        frame.push_back(ms_since(begin));
        const tp::MetricsState& m = app.ui.metrics;
        interface.push_back(static_cast<double>(m.interface_ms[(m.frames - 1) % m.kFrames]));
        show.push_back(app.texture.show_ms());
        rest_of_frame(begin);
        interval.push_back(ms_since(last));
        last = Clock::now();
    }
    const tp::RenderStatus& s = app.status;
    fmt::print(
        "{:16} frame {:6.2f} ms, 99 % {:6.2f}; of it interface {:5.2f}, 99 % {:5.2f}; interval "
        "{:6.2f}, 99 % {:6.2f}; picture {:5.3f} ms, 99 % {:5.3f}; {} x {}, {} spp, {:.1f} "
        "Msamples/s, sync {:.2f} ms\n",
        name, quantile(frame, 0.5), quantile(frame, 0.99), quantile(interface, 0.5),
        quantile(interface, 0.99), quantile(interval, 0.5), quantile(interval, 0.99),
        quantile(show, 0.5), quantile(show, 0.99), s.width, s.height, s.samples,
        s.samples_per_second / 1e6, s.sync_ms);
    std::fflush(stdout);
}

tp::ObjectId last_object(const tp::Scene& scene) {
    return scene.objects.empty() ? tp::ObjectId{} : scene.objects.back().id;
}

void fly_round(tp::App& app, const tp::Camera& from, int i) {
    tp::Camera moved = from;
    const double angle = 0.01 * i;
    moved.look_from += tp::Double3(std::sin(angle), 0.2 * std::sin(0.7 * angle), 0);
    app.document.fly(moved);
}

void drag_shape(tp::App& app, tp::ObjectId object, int i) {
    app.document.edit("Move", "bench", [&](tp::Scene& s) {
        find_object(s, object)->transform.translation.x = 0.3 * std::sin(0.05 * i);
    });
}

void drag_color(tp::App& app, tp::ObjectId object, int i) {
    const tp::MaterialId material = find(app.document.scene(), object)->material;
    app.document.edit("Colour", "bench colour", [&](tp::Scene& s) {
        if (tp::Material* m = find_material(s, material))
            m->color.color.x = 0.5 + 0.5 * std::sin(0.05 * i);
    });
}

// Everything that takes memory, again and again.
void soak(tp::App& app, double seconds) {
    const std::string file = app.document.file().string();
    const int sizes[][2] = {{1920, 1080}, {801, 601}, {1280, 720}, {640, 361}, {1600, 1000}};
    const auto start = Clock::now();
    for (int round = 0; ms_since(start) < seconds * 1e3; ++round) {
        app.document.open(file);
        const auto& size = sizes[round % 5];
        app.window.put({0, 0, size[0], size[1], false});
        app.ui.preferences.viewport.display_way =
            tp::EnumTable<tp::DisplayWay>::rows[static_cast<size_t>(round) % 5].value;
        const tp::Camera camera = active_camera(app.document.scene());
        const tp::ObjectId object = last_object(app.document.scene());
        std::vector<double> interval;
        for (int i = 0; i < 600; ++i) {
            const auto begin = Clock::now();
            if (i < 150) fly_round(app, camera, i);
            if (i >= 150 && i < 300 && object) drag_shape(app, object, i);
            if (i >= 300 && i < 400 && object) drag_color(app, object, i);
            if (i == 400)
                while (app.document.can_undo())
                    app.document.undo();
            app.draw_frame(0);
            app.window.show();
            rest_of_frame(begin);
            interval.push_back(ms_since(begin));
        }
        fmt::print(
            "{:4.0f} s, {} x {}, {}: interval {:.2f} ms, 99 % {:.2f}; program {}, renderer {}{}\n",
            ms_since(start) / 1e3, app.status.width, app.status.height,
            tp::enum_name(app.texture.way()), quantile(interval, 0.5), quantile(interval, 0.99),
            tp::memory_text(tp::process_memory()), tp::memory_text(app.status.memory_bytes),
            app.status.error);
        std::fflush(stdout);
    }
}

}  // namespace

int main(int argc, char** argv) try {
    tp::AppOptions options;
    options.scene = argc > 1 ? argv[1] : "scenes/showcase.json";
    const double seconds = argc > 2 ? std::atof(argv[2]) : 4;
    options.backend = argc > 3 ? argv[3] : "auto";
    options.width = 1920;
    options.height = 1080;
    const auto start = Clock::now();
    tp::App app(options);
    while (!app.texture.id())
        app.draw_frame(0.001), app.window.show();
    fmt::print("first picture after {:.0f} ms in the process, {} on {}\n", ms_since(start),
               app.status.backend, app.window.gl_name());

    if (argc > 4) {
        soak(app, seconds);
        return 0;
    }
    const auto nothing = [](int) {};
    play(app, "still", seconds, nothing);
    const tp::Camera camera = active_camera(app.document.scene());
    play(app, "flying", seconds, [&](int i) { fly_round(app, camera, i); });
    app.document.fly(camera);
    if (const tp::ObjectId object = last_object(app.document.scene())) {
        play(app, "drag a shape", seconds, [&](int i) { drag_shape(app, object, i); });
        play(app, "drag a colour", seconds, [&](int i) { drag_color(app, object, i); });
    }
    for (const auto& way : tp::EnumTable<tp::DisplayWay>::rows) {
        app.ui.preferences.viewport.display_way = way.value;
        play(app, std::string(way.name).c_str(), seconds / 2, nothing);
    }
    return 0;
} catch (const tp::Error& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return error.exit_code();
}
