// Exports: a render to files beside the window, by the code of `teapath render`; a still, or frames
// along a way of the camera. Knows no ImGui.
#pragma once

#include "jobs.h"

#include <teapath/core/enum_table.h>
#include <teapath/render/backend.h>
#include <teapath/scene/scene.h>

#include <filesystem>
#include <string>
#include <vector>

namespace tp {

enum class ExportMotion : uint8_t { Still, Bookmarks, Turntable, Animation };

template <>
struct EnumTable<ExportMotion> {
    using E = ExportMotion;
    static constexpr std::array rows = {
        EnumRow<E>{E::Still, "still", "One picture"},
        EnumRow<E>{E::Bookmarks, "bookmarks", "Along the bookmarks"},
        EnumRow<E>{E::Turntable, "turntable", "Turntable"},
        EnumRow<E>{E::Animation, "animation", "The models' animations"}};
};

struct ExportSettings {
    std::filesystem::path file;  // of frames: name.png becomes name_0001.png …
    int width = 1280, height = 720;
    int samples = 64;
    uint64_t seed = 0;
    CameraId camera;
    bool features = true;  // EXR: also alpha, albedo, normal, depth and ids
    BackendKind backend = BackendKind::Auto;
    int device = 0;
    int threads = 0;

    ExportMotion motion = ExportMotion::Still;
    int frames = 48;
    double frames_per_second = 24;
    bool new_seeds = false;  // frame n has seed + n

    friend bool operator==(const ExportSettings&, const ExportSettings&) = default;
};

/// As the scene says, to begin with.
ExportSettings export_settings_of(const Scene& scene);

/// Why these cannot be exported, in a few words; empty if they can.
std::string why_not_exported(const Scene& scene, const ExportSettings& settings);

/// Frames that there will be; 1 for a still.
int frame_count(const ExportSettings& settings);
/// Seconds from the start of the motion to frame n, from 0.
double frame_time(const ExportSettings& settings, int frame);
/// The file of frame n, from 0: name_0001.png for the first.
std::filesystem::path frame_file(const ExportSettings& settings, int frame);
/// The scene that frame n shows: what `teapath render` of it writes is the exported picture.
Scene export_scene(const Scene& scene, const ExportSettings& settings, int frame);

struct ExportResult {
    std::vector<std::filesystem::path> files;  // that were written
    bool is_whole = true;                      // false: cut short
    double seconds = 0;
};

/// Renders and writes. Cancelled: what was written is taken away, or with `keeps` stays, the
/// picture under way too. Throws Error; the frames before it stay then.
ExportResult run_export(const Scene& scene, const std::string& scene_name,
                        const ExportSettings& settings, JobControl& control);

/// "0:42", "1:02:03".
std::string clock_text(double seconds);

}  // namespace tp
