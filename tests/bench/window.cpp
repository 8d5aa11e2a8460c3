// Frame times of the window: bench_window [SCENE] [SECONDS] [auto|cuda|host]. Opens it, plays each
// situation for some seconds, and prints the median and the 99th percentile of the time that a
// frame takes of the interface's thread, and what the picture's way to the screen takes.
#include "application.h"

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

// Plays frames at sixty a second at most; `act` changes something before each.
void play(tp::App& app, const char* name, double seconds, const std::function<void(int)>& act) {
    std::vector<double> frame, interval, show;
    const auto start = Clock::now();
    auto last = start;
    for (int i = 0; ms_since(start) < seconds * 1e3; ++i) {
        const auto begin = Clock::now();
        act(i);
        app.draw_frame(0);
        app.window.show();
        frame.push_back(ms_since(begin));
        show.push_back(app.texture.show_ms());
        const double rest = 1000.0 / 60 - ms_since(begin);
        if (rest > 0) std::this_thread::sleep_for(std::chrono::duration<double, std::milli>(rest));
        interval.push_back(ms_since(last));
        last = Clock::now();
    }
    const tp::RenderStatus& s = app.status;
    fmt::print(
        "{:16} frame {:6.2f} ms, 99 % {:6.2f}; interval {:6.2f}, 99 % {:6.2f}; picture {:5.3f} ms, "
        "99 % {:5.3f}; {} x {}, {} spp, {:.1f} Msamples/s, sync {:.2f} ms\n",
        name, quantile(frame, 0.5), quantile(frame, 0.99), quantile(interval, 0.5),
        quantile(interval, 0.99), quantile(show, 0.5), quantile(show, 0.99), s.width, s.height,
        s.samples, s.samples_per_second / 1e6, s.sync_ms);
    std::fflush(stdout);
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

    const auto nothing = [](int) {};
    play(app, "still", seconds, nothing);
    const tp::Camera camera = active_camera(app.document.scene());
    play(app, "flying", seconds, [&](int i) {
        tp::Camera moved = camera;
        const double angle = 0.01 * i;
        moved.look_from += tp::Double3(std::sin(angle), 0.2 * std::sin(0.7 * angle), 0);
        app.document.fly(moved);
    });
    app.document.fly(camera);
    const tp::ObjectId object = app.document.scene().objects.empty()
                                    ? tp::ObjectId{}
                                    : app.document.scene().objects.back().id;
    if (object) {
        play(app, "drag a shape", seconds, [&](int i) {
            app.document.edit("Move", "bench", [&](tp::Scene& s) {
                find_object(s, object)->transform.translation.x = 0.3 * std::sin(0.05 * i);
            });
        });
        const tp::MaterialId material = find(app.document.scene(), object)->material;
        play(app, "drag a colour", seconds, [&](int i) {
            app.document.edit("Colour", "bench colour", [&](tp::Scene& s) {
                if (tp::Material* m = find_material(s, material))
                    m->color.color.x = 0.5 + 0.5 * std::sin(0.05 * i);
            });
        });
    }
    for (const auto& way : tp::EnumTable<tp::DisplayWay>::rows) {
        app.texture.set_way(way.value);
        play(app, std::string(way.name).c_str(), seconds / 2, nothing);
    }
    return 0;
} catch (const tp::Error& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return error.exit_code();
}
