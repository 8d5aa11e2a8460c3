// `teapath info`: what a scene consists of, what this build and this machine can do.
#include "command.h"
#include "help_format.h"
#include "scene_report.h"
#include "status.h"
#include "version.h"

#include <teapath/core/parallel.h>
#include <teapath/device/devices.h>
#include <teapath/io/scene_file.h>
#include <teapath/scene/enum_tables.h>
#include <teapath/scene/pose.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>
#include <optional>

namespace tp {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kFooter = R"(Examples:
  teapath info
  teapath info scenes/cornell_box.json
  teapath info scenes/cornell_box.json --json)";

std::string bytes_text(size_t bytes) {
    constexpr double kKib = 1024;
    const auto value = static_cast<double>(bytes);
    if (value < kKib) return fmt::format("{} B", bytes);
    if (value < kKib * kKib) return fmt::format("{:.1f} KiB", value / kKib);
    if (value < kKib * kKib * kKib) return fmt::format("{:.1f} MiB", value / kKib / kKib);
    return fmt::format("{:.1f} GiB", value / kKib / kKib / kKib);
}

std::string line(std::string_view name, std::string_view value) {
    return fmt::format("{:<12}{}\n", name, value);
}

// "488: 480 sphere, 8 rectangle"
std::string counts_text(const KindCounts& counts) {
    std::string text = fmt::to_string(total(counts));
    const char* separator = ": ";
    for (const auto& [kind, count] : counts) {
        text += fmt::format("{}{} {}", separator, count, kind);
        separator = ", ";
    }
    return text;
}

std::string image_text(const ImageReport& image) {
    if (image.missing) return image.path + ": missing";
    return fmt::format("{}: {} x {}, {} channel{} of {} bit, {}", image.path, image.width,
                       image.height, image.channels, image.channels == 1 ? "" : "s", image.bits,
                       bytes_text(image.bytes));
}

std::string cameras_text(const Scene& scene) {
    const CameraId active = active_camera(scene).id;
    std::string text;
    for (const Camera& camera : scene.cameras) {
        if (!text.empty()) text += ", ";
        text += camera.name.empty() ? "unnamed" : camera.name;
        if (camera.id == active && scene.cameras.size() > 1) text += " (active)";
    }
    return text;
}

// A line for each model that moves.
std::string animations_text(const Scene& scene) {
    std::string text;
    for (const Model& model : scene.models) {
        if (!model.content || !model.content->motion) continue;
        std::string list;
        for (const Animation& animation : model.content->motion->animations)
            list += fmt::format("{}{} {:.2f} s", list.empty() ? "" : ", ", animation.name,
                                animation.length);
        text += line(text.empty() ? "Animations" : "", model.path + ": " + list);
    }
    return text;
}

Json animations_json(const Scene& scene) {
    Json list = Json::array();
    for (const Model& model : scene.models) {
        if (!model.content || !model.content->motion) continue;
        for (const Animation& animation : model.content->motion->animations)
            list.push_back(
                {{"model", model.path}, {"name", animation.name}, {"seconds", animation.length}});
    }
    return list;
}

std::string scene_text(const std::string& file, const Scene& scene, const SceneReport& report) {
    const RenderSettings& render = scene.render;
    std::string text = line("Scene", scene.name.empty() ? file : scene.name + " (" + file + ")");
    if (!scene.description.empty()) text += line("", scene.description);
    text += line("Render", fmt::format("{} x {}, {} samples, depth {}, {}, {}, seed {}",
                                       render.width, render.height, render.samples,
                                       render.path.max_depth, enum_name(render.path.integrator),
                                       enum_name(render.path.sampler), render.path.seed));
    text += line("Cameras", cameras_text(scene));
    std::string objects = counts_text(report.objects);
    if (report.generators > 0)
        objects += fmt::format(" ({} made by {} generator{})", report.generated_objects,
                               report.generators, report.generators == 1 ? "" : "s");
    if (report.hidden_objects > 0) objects += fmt::format(" ({} hidden)", report.hidden_objects);
    text += line("Objects", objects);
    text += line("Materials", counts_text(report.materials));
    text += line("Textures", counts_text(report.textures));
    for (const ImageReport& image : report.images)
        text += line("", image_text(image));
    text += animations_text(scene);
    text += line("Background", enum_name(scene.background.kind));
    text += line("Lights", fmt::to_string(report.lights));
    text += line("Tree", fmt::format("{} nodes, {} levels, cost {:.2f}, built in {:.1f} ms",
                                     report.tree_nodes, report.tree_depth, report.tree_cost,
                                     report.build_seconds * 1e3));
    return text + line("Memory", bytes_text(report.scene_bytes));
}

std::string devices_text() {
    const DeviceList list = cuda_devices();
    std::string text;
    for (const DeviceInfo& device : list.devices) {
        const std::string name = text.empty() ? "Devices" : "";
        text += line(name,
                     fmt::format("{}: {}, {}, compute {}.{}, {} multiprocessors, {}", device.index,
                                 device.name, bytes_text(device.memory_bytes), device.compute_major,
                                 device.compute_minor, device.multiprocessors, device.uuid));
    }
    if (list.devices.empty()) text += line("Devices", "no CUDA device: " + list.status);
    return text + line("Host", fmt::format("{} threads", shared_pool().thread_count()));
}

Json counts_json(const KindCounts& counts) {
    Json json = {{"total", total(counts)}};
    for (const auto& [kind, count] : counts)
        json[kind] = count;
    return json;
}

Json image_json(const ImageReport& image) {
    if (image.missing) return {{"path", image.path}, {"missing", true}};
    return {{"path", image.path},         {"width", image.width}, {"height", image.height},
            {"channels", image.channels}, {"bits", image.bits},   {"bytes", image.bytes}};
}

Json scene_json(const std::string& file, const Scene& scene, const SceneReport& report) {
    const RenderSettings& render = scene.render;
    Json json = {{"file", file}, {"name", scene.name}, {"description", scene.description}};
    json["render"] = {{"width", render.width},
                      {"height", render.height},
                      {"samples", render.samples},
                      {"max_depth", render.path.max_depth},
                      {"integrator", enum_name(render.path.integrator)},
                      {"sampler", enum_name(render.path.sampler)},
                      {"seed", render.path.seed}};
    json["cameras"] = Json::array();
    for (const Camera& camera : scene.cameras)
        json["cameras"].push_back(camera.name);
    json["active_camera"] = active_camera(scene).name;
    json["objects"] = counts_json(report.objects);
    json["generators"] = report.generators;
    json["generated_objects"] = report.generated_objects;
    json["hidden_objects"] = report.hidden_objects;
    json["materials"] = counts_json(report.materials);
    json["textures"] = counts_json(report.textures);
    json["images"] = Json::array();
    for (const ImageReport& image : report.images)
        json["images"].push_back(image_json(image));
    json["animations"] = animations_json(scene);
    json["background"] = enum_name(scene.background.kind);
    json["lights"] = report.lights;
    json["tree"] = {{"nodes", report.tree_nodes},
                    {"depth", report.tree_depth},
                    {"cost", report.tree_cost},
                    {"build_seconds", report.build_seconds}};
    json["scene_bytes"] = report.scene_bytes;
    return json;
}

Json machine_json() {
    const DeviceList list = cuda_devices();
    Json devices = Json::array();
    for (const DeviceInfo& device : list.devices) {
        devices.push_back(
            {{"index", device.index},
             {"name", device.name},
             {"compute", fmt::format("{}.{}", device.compute_major, device.compute_minor)},
             {"multiprocessors", device.multiprocessors},
             {"memory_bytes", device.memory_bytes},
             {"uuid", device.uuid}});
    }
    return {{"cuda_devices", devices},
            {"cuda_status", list.status},
            {"host_threads", shared_pool().thread_count()}};
}

std::string info_json(const std::optional<std::string>& file) {
    Json json = {
        {"program", {{"name", "Teapath"}, {"version", version()}, {"cuda", built_with_cuda()}}}};
    if (file) {
        const Scene scene = load_scene(*file);
        json["scene"] = scene_json(*file, scene, report_scene(scene));
    }
    json["machine"] = machine_json();
    // Names in a scene may hold bytes that are not UTF-8; they must not stop the report.
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string info_text(const std::optional<std::string>& file) {
    if (!file) return line("Program", version_line()) + devices_text();
    const Scene scene = load_scene(*file);
    return scene_text(*file, scene, report_scene(scene)) + devices_text();
}

}  // namespace

Command add_info_command(CLI::App& program) {
    CLI::App* parser = program.add_subcommand(
        "info", "What a scene consists of; without one, this build and the devices");
    parser->formatter(std::make_shared<HelpFormat>("[SCENE] [--json]"));
    parser->footer(kFooter);
    struct Words {
        std::optional<std::string> scene;
        bool json = false;
    };
    const auto words = std::make_shared<Words>();
    parser->add_option_function<std::string>(
        "SCENE", [words](const std::string& text) { words->scene = text; },
        "The scene, a JSON file");
    parser->add_flag("--json", words->json, "As JSON, for programs")->disable_flag_override();
    return {parser, [words] {
                print_result(words->json ? info_json(words->scene) : info_text(words->scene));
                return 0;
            }};
}

}  // namespace tp
