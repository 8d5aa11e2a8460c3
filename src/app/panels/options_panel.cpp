// Settings of the render: camera, sampling, output and display are in the scene file; device and
// viewport belong to the user.
#include "add_menu.h"
#include "inspector.h"
#include "panels.h"

#include <teapath/denoise/denoiser.h>
#include <teapath/device/devices.h>
#include <teapath/render/backend_names.h>
#include <teapath/scene/enum_tables.h>

#include <icons_font_awesome_6.h>

#include <algorithm>
#include <chrono>
#include <future>
#include <random>
#include <thread>

namespace tp {
namespace {

void choose_camera(PanelContext& c) {
    const ScenePtr scene = c.document.snapshot();
    const CameraId active = active_camera(*scene).id;
    ui::begin_row("Camera", "The camera that is looked through and rendered");
    const float space =
        std::max(1.0f, ImGui::GetContentRegionAvail().x - ImGui::GetFrameHeight() - ui::px(2));
    ImGui::SetNextItemWidth(space);
    const std::string name = item_name(*scene, item_of(active));
    if (ImGui::BeginCombo("##camera",
                          ui::fitted(name, space - ImGui::GetFrameHeight() - ui::px(12)).c_str())) {
        for (const Camera& camera : scene->cameras) {
            ImGui::PushID(static_cast<int>(camera.id.value));
            if (ImGui::Selectable(item_name(*scene, item_of(camera.id)).c_str(),
                                  camera.id == active))
                c.document.edit("Choose camera", "",
                                [id = camera.id](Scene& s) { s.active_camera = id; });
            ImGui::PopID();
        }
        ImGui::EndCombo();
    }
    ImGui::SameLine(0, ui::px(2));
    if (ui::icon_button(ICON_FA_PLUS "##camera", "Another camera where you look from now"))
        add_camera(c);
}

void draw_camera(PanelContext& c) {
    const ScenePtr scene = c.document.snapshot();
    if (!ui::begin_rows("camera")) return;
    choose_camera(c);
    if (!scene->cameras.empty()) {
        PropertyRows<Camera> rows = camera_property_rows(c, {active_camera(*scene).id});
        camera_rows(rows);
    }
    ui::end_rows();
}

PropertyRows<RenderSettings> render_rows(PanelContext& c, const ScenePtr& scene) {
    return PropertyRows<RenderSettings>(c, "the render", "render", {&scene->render},
                                        [](Scene& s, size_t) { return &s.render; });
}

void stop_rows(PropertyRows<RenderSettings>& rows) {
    rows.number(
        {.name = "Samples",
         .help = "Samples of each pixel before the render rests",
         .speed = 0.25,
         .low = 1,
         .high = 1 << 30,
         .relative = true},
        [](auto& r) -> auto& { return r.samples; });
    rows.number(
        {.name = "Time limit",
         .help = "Seconds before the render rests, whatever the samples; 0 is off",
         .speed = 0.1,
         .low = 0,
         .high = 1e9,
         .decimals = 0,
         .unit = " s",
         .relative = true},
        [](auto& r) -> auto& { return r.seconds; });
}

void denoise_rows(PropertyRows<RenderSettings>& rows) {
    // The library is opened beside the interface: that takes longer than a frame may.
    static const std::shared_future<std::string> missing =
        std::async(std::launch::async, &Denoiser::why_missing).share();
    if (missing.wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
        ui::row_text("Denoise", "...", "Looking for the library");
        return;
    }
    if (!missing.get().empty()) {
        ui::row_text("Denoise", "not here", missing.get().c_str());
        return;
    }
    rows.toggle(
        "Denoise", "Takes the noise away from what is shown and saved; the render goes on",
        [](auto& r) -> auto& { return r.denoise; });
    if (rows.active().denoise)
        rows.number(
            {.name = "Strength",
             .help = "From the noisy picture to the one without noise",
             .speed = 0.003,
             .low = 0,
             .high = 1},
            [](auto& r) -> auto& { return r.denoise_strength; });
}

void path_rows(PropertyRows<RenderSettings>& rows) {
    rows.choice(
        "Integrator", "What is computed along a path",
        [](auto& r) -> auto& { return r.path.integrator; });
    const IntegratorKind integrator = rows.active().path.integrator;
    const bool traces = integrator == IntegratorKind::Path || integrator == IntegratorKind::Book;
    if (!traces) return;
    rows.number(
        {.name = "Max depth",
         .help = "Path segments: 1 is light seen by the camera, 2 is direct light",
         .speed = 0.1,
         .low = 1,
         .high = 4096},
        [](auto& r) -> auto& { return r.path.max_depth; });
    if (integrator == IntegratorKind::Book) {
        rows.choice(
            "Scatter rule", "How matt surfaces scatter in the book's integrator",
            [](auto& r) -> auto& { return r.path.scatter; });
        return;
    }
    rows.number(
        {.name = "Roulette from",
         .help = "Segments before paths may be ended by chance; 0 is never",
         .speed = 0.1,
         .low = 0,
         .high = 4096},
        [](auto& r) -> auto& { return r.path.roulette_depth; });
    rows.toggle(
        "Light sampling", "Aims at the lights from every surface",
        [](auto& r) -> auto& { return r.path.light_sampling; });
    if (rows.active().path.light_sampling)
        rows.choice(
            "Light choice", "Which light is aimed at: what matters most there, or each alike",
            [](auto& r) -> auto& { return r.path.light_rule; });
    const auto limit = [&](const char* name, const char* help, auto get) {
        rows.number(
            {.name = name, .help = help, .speed = 0.01, .low = 0, .high = 1e6, .relative = true},
            get);
    };
    limit(
        "Clamp direct", "Most radiance of light that was scattered once; 0 is any",
        [](auto& r) -> auto& { return r.path.clamp_direct; });
    limit(
        "Clamp indirect", "Most radiance of light that was scattered more often; 0 is any",
        [](auto& r) -> auto& { return r.path.clamp_indirect; });
    rows.toggle(
        "Terminator fix", "Keeps the triangles of smooth meshes out of their own shadow",
        [](auto& r) -> auto& { return r.path.terminator_fix; });
}

const char* rounds_hint(int rounds) {
    if (rounds < 8) return "Fastest; enough for pictures";
    if (rounds < 16) return "No pattern in any test";
    return "More than a picture needs";
}

void seed_row(PropertyRows<RenderSettings>& rows) {
    const double standard = 0;
    double seed = static_cast<double>(rows.active().path.seed);
    const ui::NumberRow row{.name = "Seed",
                            .help = "Each number gives a picture with other noise",
                            .speed = 0.1,
                            .low = 0,
                            .high = 9007199254740991.0,
                            .decimals = 0,
                            .whole = true};
    const auto set = [&](uint64_t value) {
        rows.apply("Seed", true, [&](RenderSettings& r) { r.path.seed = value; });
    };
    if (ui::row(row, &seed, &standard, 1) != 0) set(static_cast<uint64_t>(seed));
    ImGui::TableNextRow();
    ImGui::TableSetColumnIndex(1);
    if (ImGui::Button(ICON_FA_DICE "  Random")) set(std::random_device{}());
    ui::tooltip("A seed by chance");
}

void random_rows(PropertyRows<RenderSettings>& rows) {
    rows.choice(
        "Sampler", "Where random numbers come from",
        [](auto& r) -> auto& { return r.path.sampler; });
    rows.number(
        {.name = "TEA rounds",
         .help = "Of the cipher that makes the random numbers: quality against speed",
         .speed = 0.05,
         .low = 6,
         .high = 32},
        [](auto& r) -> auto& { return r.path.tea_rounds; });
    ImGui::TableNextRow();
    ImGui::TableSetColumnIndex(1);
    ImGui::PushTextWrapPos(0);
    ImGui::TextDisabled("%s", rounds_hint(rows.active().path.tea_rounds));
    ImGui::PopTextWrapPos();
    rows.number(
        {.name = "Key rounds",
         .help = "Of the cipher where it makes the key from the seed, once for each pixel",
         .speed = 0.05,
         .low = 6,
         .high = 32},
        [](auto& r) -> auto& { return r.path.key_rounds; });
    seed_row(rows);
}

void draw_sampling(PanelContext& c) {
    const ScenePtr scene = c.document.snapshot();
    PropertyRows<RenderSettings> rows = render_rows(c, scene);
    if (!ui::begin_rows("sampling")) return;
    stop_rows(rows);
    denoise_rows(rows);
    path_rows(rows);
    random_rows(rows);
    ui::end_rows();
}

void draw_output(PanelContext& c) {
    const ScenePtr scene = c.document.snapshot();
    PropertyRows<RenderSettings> rows = render_rows(c, scene);
    if (!ui::begin_rows("output")) return;
    const char* help =
        "Pixels of a picture that is rendered to a file; the viewport follows its panel";
    rows.number(
        {.name = "Width", .help = help, .speed = 1, .low = 1, .high = 65536, .unit = " px"},
        [](auto& r) -> auto& { return r.width; });
    rows.number(
        {.name = "Height", .help = help, .speed = 1, .low = 1, .high = 65536, .unit = " px"},
        [](auto& r) -> auto& { return r.height; });
    ui::end_rows();
}

void exposure_rule_rows(PropertyRows<DisplaySettings>& rows) {
    rows.choice(
        "Exposure by", "What the brightness follows beside the stops above",
        [](auto& d) -> auto& { return d.rule; });
    if (rows.active().rule == ExposureRule::Ev)
        rows.number(
            {.name = "Value",
             .help = "Exposure value at ISO 100: sun 15, overcast 12, room 6, night 0",
             .speed = 0.02,
             .low = -16,
             .high = 24,
             .unit = " EV"},
            [](auto& d) -> auto& { return d.ev; });
    if (rows.active().rule != ExposureRule::Photo) return;
    const auto number = [&](const char* name, const char* help, double low, double high, auto get) {
        rows.number(
            {.name = name, .help = help, .speed = 0.01, .low = low, .high = high, .relative = true},
            get);
    };
    number(
        "f-number", "Focal length over the diameter of the lens", 0.1, 1000,
        [](auto& d) -> auto& { return d.f_number; });
    number(
        "Shutter", "Seconds that the shutter is open", 1e-6, 1e6,
        [](auto& d) -> auto& { return d.shutter; });
    number(
        "ISO", "Sensitivity of the film", 1, 1e7, [](auto& d) -> auto& { return d.iso; });
}

void draw_display(PanelContext& c) {
    const ScenePtr scene = c.document.snapshot();
    PropertyRows<DisplaySettings> rows(c, "the display", "display", {&scene->display},
                                       [](Scene& s, size_t) { return &s.display; });
    if (!ui::begin_rows("display")) return;
    rows.number(
        {.name = "Exposure",
         .help = "Stops: 1 is twice as bright. The render goes on",
         .speed = 0.02,
         .low = -16,
         .high = 16,
         .unit = " EV"},
        [](auto& d) -> auto& { return d.exposure; });
    exposure_rule_rows(rows);
    rows.choice(
        "Tone curve", "From radiance to what the screen shows",
        [](auto& d) -> auto& { return d.curve; });
    ui::end_rows();
}

// The devices of this machine, looked for once.
const DeviceList& devices() {
    static const DeviceList list = cuda_devices();
    return list;
}

void draw_device(PanelContext& c) {
    SessionOptions options = c.ui.session;
    if (!ui::begin_rows("device")) return;
    const BackendKind standard = BackendKind::Auto;
    bool changed = ui::row("Renders on", options.backend,
                           "Automatic takes CUDA where it works, else the host's cores", &standard);
    if (options.backend != BackendKind::Host && !devices().devices.empty()) {
        std::vector<std::string> names;
        for (const DeviceInfo& device : devices().devices)
            names.push_back(fmt::format("{}  {}", device.index, device.name));
        changed |= ui::row_choice("Device", options.device, names, "Which CUDA device", 0);
    }
    if (options.backend != BackendKind::Cuda)
        changed |= ui::row({.name = "Threads",
                            .help = "Of the host; 0 takes all cores",
                            .speed = 0.05,
                            .low = 0,
                            .high = std::max(1.0, std::thread::hardware_concurrency() * 1.0)},
                           options.threads, 0);
    if (devices().devices.empty()) ui::row_text("CUDA", devices().status);
    ui::row_text("Now", c.status.backend.empty() ? "starting" : c.status.backend);
    ui::end_rows();
    if (changed) c.ui.session = options;
    // The renderer starts anew once the number stands still.
    SessionOptions& used = c.ui.used_session;
    const bool differs = used.backend != c.ui.session.backend ||
                         used.device != c.ui.session.device || used.threads != c.ui.session.threads;
    if (!differs || ImGui::IsAnyItemActive()) return;
    used = c.ui.session;
    c.worker.set_options(used);
}

void draw_viewport_options(PanelContext& c) {
    ViewportPreferences& viewport = c.ui.preferences.viewport;
    if (!ui::begin_rows("viewport")) return;
    const ViewportPreferences standard;
    int scale = viewport.resolution_percent;
    if (ui::row({.name = "Resolution",
                 .help = "Of the picture, as a share of the panel's pixels",
                 .speed = 0.5,
                 .low = 10,
                 .high = 100,
                 .unit = "%"},
                scale, standard.resolution_percent))
        viewport.resolution_percent = scale;
    int index = viewport.moving_divider == 0   ? 0
                : viewport.moving_divider == 1 ? 1
                : viewport.moving_divider == 2 ? 2
                : viewport.moving_divider == 4 ? 3
                                               : 4;
    if (ui::row_choice("While moving", index, {"Automatic", "Full", "1/2", "1/4", "1/8"},
                       "Resolution while the camera or an object moves", 0)) {
        const int dividers[] = {0, 1, 2, 4, 8};
        viewport.moving_divider = dividers[index];
    }
    c.worker.set_moving_divider(viewport.moving_divider);
    ui::row("Display path", viewport.display_way,
            "How a picture of an NVIDIA GPU gets to the screen: all but the last without leaving "
            "the card. Metrics shows the time",
            &standard.display_way);
    ui::end_rows();
}

}  // namespace

void draw_options(PanelContext& c) {
    if (begin_panel(c, "Options")) {
        std::vector<std::string>& folded = c.ui.preferences.folded;
        if (ui::section("Camera##options", folded)) draw_camera(c);
        if (ui::section("Sampling##options", folded)) draw_sampling(c);
        if (ui::section("Display##options", folded)) draw_display(c);
        if (ui::section("Picture file##options", folded)) draw_output(c);
        if (ui::section("Device##options", folded)) draw_device(c);
        if (ui::section("Viewport##options", folded)) draw_viewport_options(c);
    }
    ImGui::End();
}

}  // namespace tp
