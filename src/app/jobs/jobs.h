// Work beside the interface: loading, saving, exporting. Each job has a thread of its own, a share
// done, and a result that the interface thread takes when it is there. Knows no ImGui.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace tp {

struct PanelContext;

/// What a job's work may say and ask, from its own thread.
class JobControl {
public:
    /// `share` of the work done, 0 to 1; below 0: unknown. `text` says where it is.
    void set_progress(double share, const std::string& text);
    /// True once the work is to end early; `keeps`: with what there is so far.
    bool is_cancelled() const;
    bool keeps() const;
    /// `hook` is called once, by the thread that cancels or, if that has happened, at once. Null
    /// takes it away; after that it is not running any more.
    void set_cancel_hook(std::function<void(bool keep)> hook);

private:
    friend class Jobs;
    mutable std::mutex mutex_;
    double share_ = -1;
    std::string text_;
    bool cancelled_ = false, keeps_ = false;
    std::function<void(bool)> hook_;
};

/// What is to be done with the result, on the interface thread; may be null.
using JobFinish = std::function<void(PanelContext&)>;
/// Runs on the job's thread. Throws tp::Error, or anything, where it fails.
using JobWork = std::function<JobFinish(JobControl&)>;

struct JobOptions {
    std::string title;       // "Exporting teapot.png"
    bool is_shown = true;    // in the list of running jobs
    bool can_keep = false;   // a cancel may keep what there is so far
    bool is_gentle = false;  // its threads give way to others (nice 10)
    std::function<void(PanelContext&, const std::string&)> failed;  // null: a notice
};

/// A running job, for the list.
struct JobView {
    uint64_t id;
    std::string title, text;
    double share;    // done; below 0: unknown
    double seconds;  // since it began
    bool can_keep, is_cancelling;
};

struct JobResult {
    std::string title;
    std::string error;  // empty: it went well
    JobFinish finish;
    std::function<void(PanelContext&, const std::string&)> failed;
};

/// All jobs of a window. Used by the interface thread.
class Jobs {
public:
    Jobs();
    /// Cancels what runs and waits for it.
    ~Jobs();
    Jobs(const Jobs&) = delete;
    Jobs& operator=(const Jobs&) = delete;

    /// Returns the job's number, from 1.
    uint64_t start(JobOptions options, JobWork work);
    void cancel(uint64_t id, bool keep = false);
    /// The jobs that are shown, oldest first.
    std::vector<JobView> running() const;
    bool is_idle() const { return jobs_.empty(); }
    bool is_running(uint64_t id) const;
    /// What has ended since the last call.
    std::vector<JobResult> take_finished();

private:
    struct Job;
    std::list<std::unique_ptr<Job>> jobs_;
    uint64_t last_id_ = 0;
};

}  // namespace tp
