// A pool of worker threads and loops over it. Host only.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace tp {

/// Worker threads that run loops; the caller works too. One loop at a time.
class ThreadPool {
public:
    /// `threads` counts the caller; 0 means one for each core that the process may use.
    explicit ThreadPool(int threads = 0);
    ~ThreadPool();
    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;

    int thread_count() const { return static_cast<int>(workers_.size()) + 1; }

    /// Calls `body(i)` once for each i in [0, count), in any order on any thread, and returns when
    /// all are done. The first exception that a body throws is thrown again here.
    void for_each(int64_t count, const std::function<void(int64_t)>& body);

private:
    struct Loop;
    void work();

    std::vector<std::thread> workers_;
    std::mutex mutex_;
    std::condition_variable wake_;
    std::condition_variable done_;
    std::shared_ptr<Loop> loop_;
    uint64_t generation_ = 0;
    bool stopping_ = false;
};

/// The calling thread, and those that it starts from here on, leave the cores to other threads of
/// this program and of others when these want them. Nothing where the system refuses.
void lower_thread_priority();

/// The process-wide pool for builds and file work (all cores).
ThreadPool& shared_pool();

/// Splits [0, count) into chunks of at least `grain` and calls `body(first, last)` on the shared
/// pool; runs in place where there is only one chunk. Not to be nested.
void parallel_for(int64_t count, int64_t grain, const std::function<void(int64_t, int64_t)>& body);

}  // namespace tp
