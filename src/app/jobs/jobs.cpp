#include "jobs.h"

#include <sys/resource.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <utility>

namespace tp {
namespace {

using Clock = std::chrono::steady_clock;

// Of this thread and of those that it will start: on Linux both have a priority of their own.
void lower_priority() {
    setpriority(PRIO_PROCESS, 0, std::max(10, getpriority(PRIO_PROCESS, 0)));
}

}  // namespace

struct Jobs::Job {
    uint64_t id = 0;
    JobOptions options;
    JobControl control;
    Clock::time_point start = Clock::now();
    // Written by the thread before `is_done`.
    JobFinish finish;
    std::string error;
    std::atomic<bool> is_done = false;
    std::thread thread;

    void run(const JobWork& work) {
        if (options.is_gentle) lower_priority();
        try {
            finish = work(control);
        } catch (const std::exception& e) {
            error = e.what()[0] ? e.what() : "it failed";
        }
        control.set_cancel_hook(nullptr);
        is_done = true;
    }
};

void JobControl::set_progress(double share, const std::string& text) {
    const std::lock_guard lock(mutex_);
    share_ = share;
    text_ = text;
}

bool JobControl::is_cancelled() const {
    const std::lock_guard lock(mutex_);
    return cancelled_;
}

bool JobControl::keeps() const {
    const std::lock_guard lock(mutex_);
    return keeps_;
}

void JobControl::set_cancel_hook(std::function<void(bool)> hook) {
    const std::lock_guard lock(mutex_);
    hook_ = std::move(hook);
    if (cancelled_ && hook_) hook_(keeps_);
}

Jobs::Jobs() = default;

Jobs::~Jobs() {
    for (const auto& job : jobs_)
        cancel(job->id);
    for (const auto& job : jobs_)
        job->thread.join();
}

uint64_t Jobs::start(JobOptions options, JobWork work) {
    auto job = std::make_unique<Job>();
    job->id = ++last_id_;
    job->options = std::move(options);
    Job* raw = job.get();
    raw->thread = std::thread([raw, work = std::move(work)] { raw->run(work); });
    jobs_.push_back(std::move(job));
    return last_id_;
}

void Jobs::cancel(uint64_t id, bool keep) {
    for (const auto& job : jobs_) {
        JobControl& control = job->control;
        if (job->id != id) continue;
        const std::lock_guard lock(control.mutex_);
        // Who has asked to keep may still ask to drop.
        if (control.cancelled_ && (keep || !control.keeps_)) continue;
        control.cancelled_ = true;
        control.keeps_ = keep && job->options.can_keep;
        if (control.hook_) control.hook_(control.keeps_);
    }
}

std::vector<JobView> Jobs::running() const {
    std::vector<JobView> views;
    for (const auto& job : jobs_) {
        if (!job->options.is_shown) continue;
        const JobControl& control = job->control;
        const std::lock_guard lock(control.mutex_);
        const double seconds = std::chrono::duration<double>(Clock::now() - job->start).count();
        views.push_back({job->id, job->options.title, control.text_, control.share_, seconds,
                         job->options.can_keep, control.cancelled_});
    }
    return views;
}

bool Jobs::is_running(uint64_t id) const {
    return std::any_of(jobs_.begin(), jobs_.end(), [&](const auto& j) { return j->id == id; });
}

std::vector<JobResult> Jobs::take_finished() {
    std::vector<JobResult> results;
    for (auto it = jobs_.begin(); it != jobs_.end();) {
        Job& job = **it;
        if (!job.is_done) {
            ++it;
            continue;
        }
        job.thread.join();
        results.push_back({job.options.title, job.error, job.finish, job.options.failed});
        it = jobs_.erase(it);
    }
    return results;
}

}  // namespace tp
