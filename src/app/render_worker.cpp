#include "render_worker.h"

#include <teapath/core/error.h>
#include <teapath/core/log.h>
#include <teapath/core/parallel.h>
#include <teapath/device/pick.h>
#include <teapath/render/scheduler.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace tp {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

constexpr double kPreviewSeconds = 0.03;   // that a picture may take while the user moves something
constexpr double kHostStepSeconds = 0.05;  // that a step may take when all is still
constexpr double kCudaStepSeconds = 0.012;
constexpr double kLaunchSeconds = 0.004;  // that a launch may keep the card from drawing
constexpr double kRestSeconds = 0.15;     // of stillness before full resolution comes back

}  // namespace

RenderWorker::RenderWorker(const SessionOptions& options)
    : thread_([this, options] { run(options); }) {}

RenderWorker::~RenderWorker() {
    stop();
    thread_.join();
}

void RenderWorker::stop() {
    {
        const std::lock_guard lock(mutex_);
        stopping_ = true;
        if (Session* session = session_) session->cancel();
    }
    wake_.notify_all();
}

void RenderWorker::set_scene(std::shared_ptr<const Scene> scene, int width, int height,
                             bool is_moving) {
    const std::lock_guard lock(mutex_);
    const bool same_size = posted_.width == width && posted_.height == height;
    if (posted_.scene == scene && same_size) return;
    const auto restarts_film = [&] {
        return !posted_.scene || !same_size ||
               changed_parts(*posted_.scene, *scene) != SceneParts::None ||
               pose_differs(*posted_.scene, *scene);
    };
    // A long step at full resolution gives way to another film; a short one is let finish, so that
    // pictures come.
    if (Session* session = session_;
        session && status_.step_ms > 100 && !status_.is_preview && restarts_film())
        session->cancel();
    posted_ = {scene, width, height, is_moving, false};
    request_ = {std::move(scene), width, height, is_moving, request_.restart};
    has_request_ = true;
    wake_.notify_all();
}

void RenderWorker::set_paused(bool paused) {
    const std::lock_guard lock(mutex_);
    paused_ = paused;
    wake_.notify_all();
}

void RenderWorker::set_options(const SessionOptions& options) {
    stop();
    thread_.join();
    stopping_ = false;
    status_ = {};
    has_request_ = request_.scene != nullptr;
    request_.restart = false;
    current_ = {};
    divider_ = 1;
    thread_ = std::thread([this, options] { run(options); });
}

bool RenderWorker::is_finished(const Session& session) const {
    if (session.samples() == 0) return target_ == 0;
    return session.samples() >= target_ || (limit_seconds_ > 0 && film_seconds_ >= limit_seconds_);
}

void RenderWorker::restart() {
    const std::lock_guard lock(mutex_);
    request_.restart = true;
    has_request_ = request_.scene != nullptr;
    wake_.notify_all();
}

std::optional<DisplayImage> RenderWorker::take_image() {
    const std::lock_guard lock(mutex_);
    return std::exchange(image_, std::nullopt);
}

RenderStatus RenderWorker::status() const {
    const std::lock_guard lock(mutex_);
    return status_;
}

void RenderWorker::request_pick(const PickQuery& query) {
    {
        const std::lock_guard lock(mutex_);
        std::erase_if(pick_queries_,
                      [&](const PickQuery& q) { return q.purpose == query.purpose; });
        picks_.erase(query.purpose);
        pick_queries_.push_back(query);
    }
    // Tracing a ray is a matter of microseconds; the thread answers where the arrays are not free.
    if (const std::unique_lock arrays(arrays_mutex_, std::try_to_lock); arrays && arrays_)
        answer_picks();
    else
        wake_.notify_all();
}

void RenderWorker::post(std::function<void(const Session&, const Scene&)> task) {
    const std::lock_guard lock(mutex_);
    tasks_.push_back(std::move(task));
    wake_.notify_all();
}

std::optional<RenderWorker::Pick> RenderWorker::take_pick(int purpose) {
    const std::lock_guard lock(mutex_);
    const auto found = picks_.find(purpose);
    if (found == picks_.end()) return std::nullopt;
    const Pick pick = found->second;
    picks_.erase(found);
    return pick;
}

// With arrays_mutex_ held.
void RenderWorker::answer_picks() {
    const std::lock_guard lock(mutex_);
    for (const PickQuery& query : std::exchange(pick_queries_, {})) {
        const PickResult result = tp::pick(*arrays_, query.origin, query.direction, query.t_max);
        picks_[query.purpose] = {result.object, result.point};
    }
}

void RenderWorker::run(SessionOptions options) {
    lower_thread_priority();  // the interface goes first
    options.launch_seconds = kLaunchSeconds;
    // A device that fails is left for the host; the scene is not touched.
    for (;;) {
        try {
            Session session(options);
            session_ = &session;
            work(session);
            session_ = nullptr;
            return;
        } catch (const std::exception& error) {
            session_ = nullptr;
            log_line(LogLevel::Error, error.what());
            const std::lock_guard lock(mutex_);
            status_.error = error.what();
            if (stopping_ || options.backend == BackendKind::Host) return;
            options.backend = BackendKind::Host;
            has_request_ = request_.scene != nullptr;
        }
    }
}

void RenderWorker::work(Session& session) {
    // However this ends, nobody reads the arrays of a session that is gone.
    const struct Forget {
        RenderWorker& worker;
        ~Forget() {
            const std::lock_guard arrays(worker.arrays_mutex_);
            worker.arrays_ = nullptr;
        }
    } forget{*this};
    auto last_change = Clock::now();
    StepHistory history;
    for (;;) {
        Request request;
        bool changed = false;
        {
            std::unique_lock lock(mutex_);
            status_.backend = session.backend_name();
            // A step that was cancelled leaves the film empty: while paused it still has its one
            // sample to make.
            const auto idle = [&] {
                const bool holds = paused_ && session.samples() > 0;
                return holds || !current_.scene || is_finished(session);
            };
            const auto has_tasks = [&] {
                return !tasks_.empty() && divider_ == 1 && session.samples() > 0;
            };
            const auto news = [&] {
                return stopping_ || has_request_ || has_tasks() ||
                       (current_.scene && !pick_queries_.empty());
            };
            if (!news() && divider_ > 1) {
                // Low resolution is for moving; it ends after a short rest.
                const double left = kRestSeconds - seconds_since(last_change);
                if (left > 0) wake_.wait_for(lock, std::chrono::duration<double>(left), news);
                if (!news()) {
                    request_ = current_;
                    request_.is_moving = false;
                    has_request_ = true;
                }
            } else if (idle() && !news()) {
                status_.is_resting = true;
                wake_.wait(lock, [&] { return news() || !idle(); });
                status_.is_resting = false;
            }
            if (stopping_) return;
            if (has_request_) {
                request = request_;
                request_.restart = false;
                has_request_ = false;
                changed = true;
            }
        }
        if (changed && apply(session, request)) {
            if (request.is_moving) last_change = Clock::now();
            history = {};
        }
        if (!current_.scene) continue;
        {
            const std::lock_guard arrays(arrays_mutex_);
            answer_picks();
        }
        run_tasks(session);

        history.done = session.samples();
        history.target = target_;
        history.budget_seconds =
            session.backend_kind() == BackendKind::Cuda ? kCudaStepSeconds : kHostStepSeconds;
        int64_t samples = next_samples(history);
        {
            const std::lock_guard lock(mutex_);
            if (paused_ && session.samples() > 0) samples = 0;  // one sample shows what was changed
            if (is_finished(session)) samples = 0;
        }
        if (samples == 0) {
            if (changed && session.samples() > 0)
                publish(session, divider_ > 1);  // exposure, tone curve
            continue;
        }
        const auto start = Clock::now();
        if (history.done == 0) film_seconds_ = 0;
        if (!session.step(samples)) continue;
        const double seconds = seconds_since(start);
        film_seconds_ += seconds;
        history.last_samples = samples;
        history.last_seconds = seconds;
        const double traced =
            static_cast<double>(samples) * current_.width * current_.height / (divider_ * divider_);
        pixels_per_second_ = traced / std::max(seconds, 1e-6);
        {
            const std::lock_guard lock(mutex_);
            status_.step_ms = seconds * 1e3;
            status_.samples_per_second = pixels_per_second_;
            status_.seconds = film_seconds_;
        }
        publish(session, divider_ > 1);
    }
}

int RenderWorker::preview_divider(const Request& request) const {
    if (!request.is_moving) return 1;
    if (const int chosen = moving_divider_; chosen > 0) return chosen;
    const double pixels = static_cast<double>(request.width) * request.height;
    const double wanted = std::sqrt(pixels / std::max(1.0, pixels_per_second_ * kPreviewSeconds));
    return std::clamp(static_cast<int>(std::ceil(wanted)), 1, 8);
}

bool RenderWorker::apply(Session& session, const Request& request) {
    const int divider = preview_divider(request);
    const bool same = current_.scene == request.scene && current_.width == request.width &&
                      current_.height == request.height && divider_ == divider && !request.restart;
    current_ = request;
    if (same) return false;
    divider_ = divider;
    const auto start = Clock::now();
    auto scene = std::make_shared<Scene>(*request.scene);
    scene->render.width = std::max(1, request.width / divider);
    scene->render.height = std::max(1, request.height / divider);
    target_ = scene->render.samples;
    limit_seconds_ = scene->render.seconds;
    rendered_ = scene;
    {
        const std::lock_guard arrays(arrays_mutex_);
        arrays_ = nullptr;
        session.sync(std::move(scene));
        arrays_ = &session.arrays();
    }
    if (request.restart) session.restart();
    const std::lock_guard lock(mutex_);
    status_.error.clear();
    status_.sync_ms = seconds_since(start) * 1e3;
    status_.hittables = session.arrays().hittables.size();
    status_.lights = session.arrays().lights.size();
    status_.bvh = session.arrays().bvh;
    return true;
}

void RenderWorker::run_tasks(Session& session) {
    if (divider_ != 1 || session.samples() == 0) return;
    std::vector<std::function<void(const Session&, const Scene&)>> tasks;
    {
        const std::lock_guard lock(mutex_);
        tasks.swap(tasks_);
    }
    for (const auto& task : tasks)
        task(session, *rendered_);
}

void RenderWorker::publish(Session& session, bool is_preview) {
    const auto start = Clock::now();
    std::optional<DisplayImage> image =
        live_denoiser_.next(session, rendered_, is_preview, is_finished(session));
    const RenderCounters counters = session.counters();
    const std::lock_guard lock(mutex_);
    status_.display_ms = seconds_since(start) * 1e3;
    status_.scene = current_.scene;
    status_.posed = session.posed_scene();
    status_.samples = session.samples();
    status_.width = rendered_->render.width;
    status_.height = rendered_->render.height;
    status_.memory_bytes = session.memory_bytes();
    status_.invalid_samples = counters.invalid_samples;
    if (counters.samples > counted_.samples)
        status_.rays_per_second = pixels_per_second_ *
                                  static_cast<double>(counters.rays - counted_.rays) /
                                  static_cast<double>(counters.samples - counted_.samples);
    counted_ = counters;
    if (image) image_ = std::move(image);
    status_.is_done = is_finished(session);
    status_.is_preview = is_preview;
}

}  // namespace tp
