// A running render: takes snapshots of the scene, keeps the flat arrays and the backend in step
// with them, and adds samples. One thread uses a session.
//
// What a change resets:
//   | changed                              | rebuilt                      | film    |
//   | exposure, tone curve, names          | nothing                      | kept    |
//   | camera, seed, any path setting       | the launch parameters        | emptied |
//   | size                                 | the film                     | emptied |
//   | material, texture, background        | their records, the lights    | emptied |
//   | object: transform, shape, material   | hittables, tree, lights      | emptied |
//   | time, by what it moves               | hittables, tree, lights, and | emptied |
//   |                                      | meshes of another form       |         |
#pragma once

#include <teapath/device/scene_arrays.h>
#include <teapath/render/backend.h>
#include <teapath/render/film_image.h>
#include <teapath/scene/pose.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace tp {

struct SessionOptions {
    BackendKind backend = BackendKind::Auto;  // Auto: CUDA where it works, else host
    int device = 0;                           // CUDA device number
    int threads = 0;                          // of the host backend; 0 = all cores
    bool features = false;                    // keep the feature planes of FilmImage
    double launch_seconds = 0;  // that a CUDA launch may take, so that a window can draw; 0 = any
};

class Session {
public:
    /// Throws Error(Device) if a backend that was named cannot start. Auto logs one line where it
    /// falls back to the host.
    explicit Session(const SessionOptions& options);
    ~Session();

    /// Takes a snapshot, posed at its time; the table above says what it resets.
    void sync(std::shared_ptr<const Scene> scene);

    /// Adds this many samples to every pixel. Returns false if cancelled on the way: the film is
    /// then empty again.
    bool step(int64_t samples);

    /// Empties the film.
    void restart();

    /// Asks a step under way, from any thread, to end early.
    void cancel() { cancel_ = true; }

    int64_t samples() const { return samples_; }           // per pixel, in the film
    uint64_t film_number() const { return film_number_; }  // another one each time it is emptied
    FilmImage film() const;
    std::vector<uint8_t> display() const;     // RGB bytes after the scene's display settings
    DisplayImage display_image() const;       // for a window
    FilmImage guides(int64_t samples) const;  // albedo and normal of so many samples, traced now

    std::string backend_name() const { return backend_->name(); }
    BackendKind backend_kind() const { return backend_->kind(); }  // Cuda or Host
    RenderCounters counters() const { return backend_->counters(); }
    size_t memory_bytes() const { return backend_->memory_bytes(); }
    /// The scene as it stands at its time; the snapshot itself where nothing moves.
    const std::shared_ptr<const Scene>& posed_scene() const { return scene_; }
    const SceneArrays& arrays() const { return arrays_; }

private:
    void empty_film();

    SessionOptions options_;
    std::unique_ptr<Backend> backend_;
    ScenePoser poser_;
    std::shared_ptr<const Scene> scene_;  // posed
    SceneArrays arrays_;
    FilmSetup film_setup_;
    int64_t samples_ = 0;
    uint64_t film_number_ = 0;
    std::atomic<bool> cancel_ = false;
};

}  // namespace tp
