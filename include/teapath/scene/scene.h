// The document: everything that a scene file holds, as plain values. Copies are snapshots and
// cheap, for they share images, and lists that may be long until these change; == is a test.
// Nothing here is derived; BVH, lights and arrays are made in device/.
#pragma once

#include <teapath/core/shared_list.h>
#include <teapath/kernel/settings.h>
#include <teapath/scene/camera.h>
#include <teapath/scene/generator.h>
#include <teapath/scene/material.h>
#include <teapath/scene/model.h>
#include <teapath/scene/object.h>
#include <teapath/scene/texture.h>

#include <cstdint>
#include <string>
#include <vector>

namespace tp {

/// A clear sky with the sun in it; device/sky_image.h has the model. North is -z, east is +x.
struct Sky {
    SunRule sun_by = SunRule::Angles;
    double sun_elevation = 35;      // Angles: degrees above the horizon, -90 to 90
    double sun_azimuth = 120;       // Angles: degrees from north to the east
    double latitude = 48;           // Place: degrees, north is positive
    double longitude = 11;          // Place: degrees, east is positive
    double day = 172;               // Place: of the year, 1 to 366
    double hour = 15;               // Place: of the day in UTC, 0 to 24
    double sun_size = 0.53;         // degrees across, 0.01 to 90
    double sun_strength = 1;        // times that of the sun; 0 = a sky without its disk
    double haze = 1;                // aerosols, times those of clear air, 0 to 20
    Double3 ground{0.3, 0.3, 0.3};  // albedo of the earth below the horizon

    friend bool operator==(const Sky&, const Sky&) = default;
};

struct Background {
    BackgroundKind kind = BackgroundKind::Gradient;
    Double3 bottom{1, 1, 1};  // Gradient: lerp(bottom, top, (y + 1) / 2) of the unit direction
    Double3 top{0.5, 0.7, 1.0};
    Double3 color{0, 0, 0};  // Constant
    ImageFile file;          // Image: equirectangular; -z at its edges, +x a quarter from the left
    ColorSpace color_space = ColorSpace::Auto;
    double rotation = 0;    // Image: degrees about y
    double strength = 1;    // multiplies every kind
    Double3 tint{1, 1, 1};  // Image, Sky
    Sky sky;

    BackdropKind backdrop = BackdropKind::Same;
    Double3 backdrop_color{0, 0, 0};  // Constant
    ImageFile backdrop_file;          // Image: equirectangular, turned as `file` is

    friend bool operator==(const Background&, const Background&) = default;
};

inline constexpr int kMaxImageSide = 65536;
inline constexpr int64_t kMaxImagePixels = int64_t{1} << 28;
inline constexpr int kMaxSamples = 1 << 30;

struct RenderSettings {
    int width = 1280;  // pixels, 1 to 65,536; width * height at most 2^28
    int height = 720;
    int samples = 64;             // per pixel, 1 to 2^30
    double seconds = 0;           // the render stops after, whatever the samples; 0 = no limit
    double time = 0;              // seconds from the start of the models' animations
    bool denoise = false;         // takes the noise away from what is shown and written
    double denoise_strength = 1;  // 0 to 1: from the noisy picture to the one without noise
    PathSettings path;

    friend bool operator==(const RenderSettings&, const RenderSettings&) = default;
};

/// What a scene remembers of its file. No part of what it is: scenes of different files may be
/// equal.
struct SceneOrigin {
    std::string folder;  // where relative paths start; empty: unknown
    std::string schema;  // the file's "$schema", kept for text editors

    friend bool operator==(const SceneOrigin&, const SceneOrigin&) { return true; }
};

struct Scene {
    SceneOrigin origin;
    std::string name;
    std::string description;
    std::vector<Camera> cameras;  // at least one after loading
    CameraId active_camera;       // the one to render; none = the first
    SharedList<Model> models;
    SharedList<Object> objects;  // of models too
    SharedList<Generator> generators;
    SharedList<Material> materials;
    SharedList<Texture> textures;
    Background background;
    RenderSettings render;
    DisplaySettings display;

    friend bool operator==(const Scene&, const Scene&) = default;
};

/// The thing with that id, or null. Linear in the number of things.
const Material* find(const Scene& scene, MaterialId id);
const Texture* find(const Scene& scene, TextureId id);
const Object* find(const Scene& scene, ObjectId id);
const Camera* find(const Scene& scene, CameraId id);

struct SunPosition {
    double elevation = 0, azimuth = 0;  // degrees: above the horizon; from north to the east
};
/// Where the sky's sun stands (Spencer, "Fourier Series Representation of the Position of the Sun",
/// 1971; within half a degree).
SunPosition sun_position(const Sky& sky);

/// The camera to render: the active one, else the first, else a default camera.
Camera active_camera(const Scene& scene);

/// The focus distance that a camera has in fact (at look_at where it says 0).
double effective_focus_distance(const Camera& camera);

/// A scene whose generators have become objects and materials (ids beyond the existing ones,
/// deterministic), and `generators` is empty. Everything else is as before.
Scene expand_generators(const Scene& scene);

}  // namespace tp
