// Renders beside the interface: a thread owns the Session, takes snapshots of the document, and
// publishes finished pictures. Nothing here waits for the renderer.
#pragma once

#include "live_denoiser.h"

#include <teapath/device/scene_arrays.h>
#include <teapath/render/session.h>
#include <teapath/scene/scene.h>

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace tp {

struct RenderStatus {
    std::shared_ptr<const Scene> scene;  // that the newest picture shows
    std::shared_ptr<const Scene> posed;  // the same at its time, as the picture has it
    std::string backend;
    std::string error;  // of the renderer, for people; empty if all is well
    int64_t samples = 0;
    int width = 0, height = 0;
    double samples_per_second = 0;  // camera samples
    double rays_per_second = 0;     // segments of paths, and queries for light
    double step_ms = 0;             // tracing
    double display_ms = 0;          // tone curve and copy
    double sync_ms = 0;             // of the last change of the scene
    double seconds = 0;             // of tracing in the picture so far
    size_t memory_bytes = 0;
    uint64_t invalid_samples = 0;
    size_t hittables = 0, lights = 0;
    BvhStats bvh;
    bool is_done = false;     // all samples wanted are there
    bool is_resting = false;  // nothing is being traced: paused or done
    bool is_preview = false;
};

class RenderWorker {
public:
    explicit RenderWorker(const SessionOptions& options);
    ~RenderWorker();
    /// Asks the thread to end, and does not wait; nothing is rendered after that.
    void stop();
    RenderWorker(const RenderWorker&) = delete;
    RenderWorker& operator=(const RenderWorker&) = delete;

    /// The scene to render from now on, at this size in pixels. `is_moving`: a drag or a flight is
    /// under way, so resolution may drop to keep up.
    void set_scene(std::shared_ptr<const Scene> scene, int width, int height, bool is_moving);
    void set_paused(bool paused);
    void restart();
    /// Renders on something else from now on: ends the session and begins another with the same
    /// scene. Waits for the step under way to give up.
    void set_options(const SessionOptions& options);
    /// By what the resolution is divided while something moves; 0 = by the renderer's speed.
    void set_moving_divider(int divider) { moving_divider_ = divider; }

    /// The newest picture, once.
    std::optional<DisplayImage> take_image();
    RenderStatus status() const;

    /// Runs `task` on the renderer's thread between two steps, once a picture at full resolution is
    /// there. `scene` has the picture's size.
    void post(std::function<void(const Session& session, const Scene& scene)> task);

    /// Asks what lies first along a ray; the answer is there at once unless the scene is being
    /// taken in just then, and comes after that otherwise. A new question replaces an old one of
    /// the same purpose.
    struct PickQuery {
        int purpose = 0;  // the asker's, given back with the answer
        Double3 origin{0, 0, 0};
        Double3 direction{0, 0, -1};  // a unit vector
        double t_max = 1e30;
    };
    void request_pick(const PickQuery& query);
    /// An answer to a question of that purpose, once.
    struct Pick {
        ObjectId object;  // none: the background
        Double3 point{0, 0, 0};
    };
    std::optional<Pick> take_pick(int purpose);

private:
    struct Request {
        std::shared_ptr<const Scene> scene;
        int width = 0, height = 0;
        bool is_moving = false;
        bool restart = false;
    };
    bool is_finished(const Session& session) const;
    void run(SessionOptions options);
    void work(Session& session);
    bool apply(Session& session, const Request& request);
    void answer_picks();
    void run_tasks(Session& session);
    void publish(Session& session, bool is_preview);
    int preview_divider(const Request& request) const;

    mutable std::mutex mutex_;
    std::condition_variable wake_;
    Request posted_;   // what the interface asked for last
    Request request_;  // what is to be done next
    bool has_request_ = false;
    bool paused_ = false;
    bool stopping_ = false;
    std::vector<PickQuery> pick_queries_;
    std::map<int, Pick> picks_;            // by purpose
    std::mutex arrays_mutex_;              // the session's arrays change, or are read
    const SceneArrays* arrays_ = nullptr;  // once a scene is there
    std::vector<std::function<void(const Session&, const Scene&)>> tasks_;
    std::optional<DisplayImage> image_;
    RenderStatus status_;
    std::atomic<Session*> session_ = nullptr;
    std::atomic<int> moving_divider_ = 0;

    // The thread's own.
    Request current_;
    std::shared_ptr<const Scene> rendered_;  // the scene of the session
    LiveDenoiser live_denoiser_;
    double pixels_per_second_ = 2e6;
    RenderCounters counted_;  // as of the last picture
    int divider_ = 1;
    int64_t target_ = 0;
    double limit_seconds_ = 0;  // of tracing; 0 = none
    double film_seconds_ = 0;
    std::thread thread_;
};

}  // namespace tp
