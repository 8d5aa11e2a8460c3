// Jobs: progress, results, errors and cancelling; the export that runs as one writes what the
// command line would.
#include "app/jobs/export_job.h"
#include "app/jobs/jobs.h"
#include "support/scene_maker.h"
#include "support/temporary_folder.h"

#include <teapath/core/error.h>
#include <teapath/io/image_file.h>
#include <teapath/render/rendered_image.h>
#include <teapath/render/session.h>

#include <doctest/doctest.h>
#include <sys/resource.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <fstream>
#include <iterator>
#include <thread>

using namespace tp;
using tp::test::SceneMaker;
using tp::test::TemporaryFolder;
namespace fs = std::filesystem;

namespace {

using Clock = std::chrono::steady_clock;

std::vector<JobResult> wait_for_all(Jobs& jobs) {
    std::vector<JobResult> results;
    const auto start = Clock::now();
    while (!jobs.is_idle() && Clock::now() - start < std::chrono::seconds(60)) {
        for (JobResult& result : jobs.take_finished())
            results.push_back(std::move(result));
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    REQUIRE(jobs.is_idle());
    return results;
}

JobOptions titled(const std::string& title) {
    JobOptions options;
    options.title = title;
    return options;
}

Scene small_scene() {
    SceneMaker maker;
    maker.background(0.5);
    Object ball;
    ball.id = {1};
    ball.shape = SphereShape{{0, 0, 0}, 1};
    ball.material = maker.lambertian(0.6);
    maker.scene.objects.edit().push_back(ball);
    return maker.scene;
}

ExportSettings small_export(const Scene& scene, const fs::path& file) {
    ExportSettings settings = export_settings_of(scene);
    settings.file = file;
    settings.width = 40;
    settings.height = 30;
    settings.samples = 8;
    settings.backend = BackendKind::Host;
    settings.threads = 2;
    return settings;
}

std::string bytes_of(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

// Exports in a job, to its end.
ExportResult export_now(const Scene& scene, const ExportSettings& settings) {
    Jobs jobs;
    ExportResult result;
    jobs.start(titled("Export"), [&](JobControl& control) -> JobFinish {
        result = run_export(scene, "scene.json", settings, control);
        return nullptr;
    });
    const auto results = wait_for_all(jobs);
    REQUIRE(results.size() == 1);
    CHECK(results[0].error == "");
    return result;
}

}  // namespace

TEST_CASE("jobs: progress is seen, the result comes to the thread that asks") {
    Jobs jobs;
    std::atomic<bool> goes_on = false;
    bool finished = false;
    const uint64_t id = jobs.start(titled("Work"), [&](JobControl& control) -> JobFinish {
        control.set_progress(0.25, "a quarter");
        while (!goes_on)
            std::this_thread::yield();
        return [&finished](PanelContext&) { finished = true; };
    });
    const auto start = Clock::now();
    while ((jobs.running().empty() || jobs.running()[0].text.empty()) &&
           Clock::now() - start < std::chrono::seconds(20))
        std::this_thread::yield();
    const std::vector<JobView> views = jobs.running();
    REQUIRE(views.size() == 1);
    CHECK(views[0].id == id);
    CHECK(views[0].title == "Work");
    CHECK(views[0].text == "a quarter");
    CHECK(views[0].share == 0.25);
    CHECK(!views[0].is_cancelling);
    CHECK(jobs.take_finished().empty());
    CHECK(jobs.is_running(id));
    goes_on = true;
    const auto results = wait_for_all(jobs);
    REQUIRE(results.size() == 1);
    CHECK(results[0].error.empty());
    CHECK(results[0].finish);
    CHECK(!finished);
    CHECK(!jobs.is_running(id));
}

TEST_CASE("jobs: an error is a text, with the job's own handler") {
    Jobs jobs;
    JobOptions options = titled("Bad");
    options.failed = [](PanelContext&, const std::string&) {};
    jobs.start(std::move(options), [](JobControl&) -> JobFinish {
        throw Error(ErrorKind::Output, "no room", "/disk");
    });
    const auto results = wait_for_all(jobs);
    REQUIRE(results.size() == 1);
    CHECK(results[0].error.find("no room") != std::string::npos);
    CHECK(results[0].failed);
    CHECK(!results[0].finish);
}

TEST_CASE("jobs: hidden ones are not listed; the end of the window cancels and waits") {
    std::atomic<bool> ended = false;
    {
        Jobs jobs;
        JobOptions options = titled("Hidden");
        options.is_shown = false;
        jobs.start(std::move(options), [&](JobControl& control) -> JobFinish {
            while (!control.is_cancelled())
                std::this_thread::yield();
            ended = true;
            return nullptr;
        });
        CHECK(jobs.running().empty());
        CHECK(!jobs.is_idle());
    }
    CHECK(ended);
}

TEST_CASE("jobs: a cancel that keeps may become one that drops, not the other way round") {
    Jobs jobs;
    std::atomic<int> kept = 0, dropped = 0;
    std::atomic<bool> goes_on = false, is_ready = false;
    JobOptions options = titled("Work");
    options.can_keep = true;
    const uint64_t id = jobs.start(std::move(options), [&](JobControl& control) -> JobFinish {
        control.set_cancel_hook([&](bool keep) { ++(keep ? kept : dropped); });
        is_ready = true;
        while (!goes_on)
            std::this_thread::yield();
        CHECK(control.is_cancelled());
        CHECK(!control.keeps());
        return nullptr;
    });
    while (!is_ready)
        std::this_thread::yield();
    jobs.cancel(id, true);
    jobs.cancel(id, true);
    jobs.cancel(id, false);
    jobs.cancel(id, true);
    jobs.cancel(id, false);
    CHECK(kept == 1);
    CHECK(dropped == 1);
    CHECK(jobs.running()[0].is_cancelling);
    goes_on = true;
    wait_for_all(jobs);
}

TEST_CASE("jobs: gentle ones give way, and so do threads that they start") {
    Jobs jobs;
    std::atomic<int> own = -1, child = -1;
    const int before = getpriority(PRIO_PROCESS, 0);
    JobOptions options = titled("Gentle");
    options.is_gentle = true;
    jobs.start(std::move(options), [&](JobControl&) -> JobFinish {
        own = getpriority(PRIO_PROCESS, 0);
        std::thread([&] { child = getpriority(PRIO_PROCESS, 0); }).join();
        return nullptr;
    });
    wait_for_all(jobs);
    CHECK(own == std::max(10, before));
    CHECK(child == own);
    CHECK(getpriority(PRIO_PROCESS, 0) == before);
}

TEST_CASE("export: the files are those of the command line's code, byte for byte") {
    TemporaryFolder folder;
    const Scene scene = small_scene();
    for (const char* name : {"a.png", "a.jpg", "a.hdr", "a.exr"}) {
        CAPTURE(name);
        const ExportSettings settings = small_export(scene, folder.path / name);
        const ExportResult result = export_now(scene, settings);
        CHECK(result.is_whole);
        REQUIRE(result.files == std::vector<fs::path>{folder.path / name});

        const auto shown = std::make_shared<const Scene>(export_scene(scene, settings, 0));
        const std::vector<fs::path> files = {folder.path / "by_hand" / name};
        fs::create_directories(files[0].parent_path());
        Session session({BackendKind::Host, 0, 1, std::string(name) == "a.exr"});
        session.sync(shown);
        session.step(settings.samples);
        write_files(files, rendered_image(session, *shown, "scene.json", files, 0));
        if (std::string(name) == "a.exr") {  // its header holds the time that it took
            const Image a = read_image(files[0]), b = read_image(folder.path / name);
            CHECK(a == b);
        } else {
            CHECK(bytes_of(files[0]) == bytes_of(folder.path / name));
        }
    }
}

TEST_CASE("export: frames of a turntable and along bookmarks, each as a still of its own scene") {
    TemporaryFolder folder;
    Scene scene = small_scene();
    for (uint32_t n = 1; n <= 3; ++n) {
        Camera camera = scene.cameras[0];
        camera.id = {100 + n};
        camera.name = "bookmark " + std::to_string(n);
        camera.look_from = {static_cast<double>(n), 1, 4};
        scene.cameras.push_back(camera);
    }
    for (const ExportMotion motion : {ExportMotion::Turntable, ExportMotion::Bookmarks}) {
        ExportSettings settings = small_export(scene, folder.path / "walk.png");
        settings.motion = motion;
        settings.frames = 4;
        settings.new_seeds = true;
        const ExportResult result = export_now(scene, settings);
        REQUIRE(result.files.size() == 4);
        CHECK(result.files[0].filename() == "walk_0001.png");
        CHECK(result.files[3].filename() == "walk_0004.png");
        CHECK(frame_time(settings, 3) == doctest::Approx(3 / 24.0));
        CHECK(bytes_of(result.files[0]) != bytes_of(result.files[2]));
        // Frame 3 alone.
        const Scene third = export_scene(scene, settings, 2);
        CHECK(third.render.path.seed == settings.seed + 2);
        ExportSettings still = small_export(third, folder.path / "third.png");
        export_now(third, still);
        CHECK(read_image(result.files[2]) == read_image(still.file));
    }
}

TEST_CASE("export: cancelled, it keeps nothing or what is there") {
    TemporaryFolder folder;
    const Scene scene = small_scene();
    for (const bool keep : {false, true}) {
        CAPTURE(keep);
        Jobs jobs;
        ExportSettings settings = small_export(scene, folder.path / "long.png");
        settings.width = settings.height = 400;
        settings.samples = 1 << 30;
        ExportResult result;
        JobOptions options = titled("Export");
        options.can_keep = true;
        const uint64_t id = jobs.start(std::move(options), [&](JobControl& control) -> JobFinish {
            result = run_export(scene, "scene.json", settings, control);
            return nullptr;
        });
        while (jobs.running().empty() || jobs.running()[0].share <= 0)
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        CHECK(jobs.running()[0].text.find("left") != std::string::npos);
        const auto start = Clock::now();
        jobs.cancel(id, keep);
        wait_for_all(jobs);
        const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
        CHECK(seconds < 2);
        CHECK(!result.is_whole);
        CHECK(fs::exists(folder.path / "long.png") == keep);
        CHECK(result.files.size() == (keep ? 1 : 0));
    }
}

TEST_CASE("export: what cannot be exported is said before it starts") {
    TemporaryFolder folder;
    const Scene scene = small_scene();
    ExportSettings settings = small_export(scene, folder.path / "a.png");
    CHECK(why_not_exported(scene, settings) == "");
    settings.file = folder.path / "a.txt";
    CHECK(why_not_exported(scene, settings) != "");
    settings.file = folder.path / "missing" / "a.png";
    CHECK(why_not_exported(scene, settings).find("missing") != std::string::npos);
    settings.file = "";
    CHECK(why_not_exported(scene, settings) != "");
    settings.file = folder.path / "a.png";
    settings.motion = ExportMotion::Bookmarks;
    CHECK(why_not_exported(scene, settings).find("bookmarks") != std::string::npos);
    settings.motion = ExportMotion::Animation;
    CHECK(why_not_exported(scene, settings).find("animation") != std::string::npos);
    settings.frames_per_second = 10;
    CHECK(export_scene(scene, settings, 5).render.time == 0.5);
    settings.motion = ExportMotion::Still;
    settings.width = 65536;
    settings.height = 65536;
    CHECK(why_not_exported(scene, settings) != "");
}

TEST_CASE("export: time left in words") {
    CHECK(clock_text(0.2) == "0:00");
    CHECK(clock_text(42) == "0:42");
    CHECK(clock_text(3723) == "1:02:03");
    CHECK(clock_text(-5) == "0:00");
}
