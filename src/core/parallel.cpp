#include <teapath/core/parallel.h>

#include <sched.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <exception>

namespace tp {
namespace {

// The cores that this process may use, which a container or taskset may have narrowed.
int usable_cores() {
    cpu_set_t set;
    CPU_ZERO(&set);
    if (sched_getaffinity(0, sizeof set, &set) == 0) return std::max(1, CPU_COUNT(&set));
    return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

}  // namespace

struct ThreadPool::Loop {
    int64_t count;
    const std::function<void(int64_t)>* body;
    std::atomic<int64_t> next = 0;
    int active = 0;  // workers inside, guarded by the pool's mutex
    std::mutex error_mutex;
    std::exception_ptr error;

    void run() {
        for (int64_t i; (i = next.fetch_add(1)) < count;) {
            try {
                (*body)(i);
            } catch (...) {
                const std::lock_guard lock(error_mutex);
                if (!error) error = std::current_exception();
                next = count;
            }
        }
    }
};

ThreadPool::ThreadPool(int threads) {
    const int total = threads > 0 ? threads : usable_cores();
    for (int i = 1; i < total; ++i)
        workers_.emplace_back([this] { work(); });
}

ThreadPool::~ThreadPool() {
    {
        const std::lock_guard lock(mutex_);
        stopping_ = true;
    }
    wake_.notify_all();
    for (std::thread& worker : workers_)
        worker.join();
}

void ThreadPool::work() {
    uint64_t seen = 0;
    std::unique_lock lock(mutex_);
    for (;;) {
        wake_.wait(lock, [&] { return stopping_ || generation_ != seen; });
        if (stopping_) return;
        seen = generation_;
        const std::shared_ptr<Loop> loop = loop_;
        if (!loop) continue;
        ++loop->active;
        lock.unlock();
        loop->run();
        lock.lock();
        if (--loop->active == 0) done_.notify_all();
    }
}

void ThreadPool::for_each(int64_t count, const std::function<void(int64_t)>& body) {
    const auto loop = std::make_shared<Loop>();
    loop->count = count;
    loop->body = &body;
    if (!workers_.empty() && count > 1) {
        {
            const std::lock_guard lock(mutex_);
            loop_ = loop;
            ++generation_;
        }
        wake_.notify_all();
    }
    loop->run();
    {
        std::unique_lock lock(mutex_);
        if (loop_ == loop) loop_.reset();
        done_.wait(lock, [&] { return loop->active == 0; });
    }
    if (loop->error) std::rethrow_exception(loop->error);
}

void lower_thread_priority() {
    // Linux keeps a niceness for each thread, which threads that it starts inherit.
    constexpr int kNiceness = 5;
    setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), kNiceness);
}

ThreadPool& shared_pool() {
    static ThreadPool pool;
    return pool;
}

void parallel_for(int64_t count, int64_t grain, const std::function<void(int64_t, int64_t)>& body) {
    if (count <= grain || shared_pool().thread_count() == 1) {
        if (count > 0) body(0, count);
        return;
    }
    const int64_t wanted = int64_t{4} * shared_pool().thread_count();
    const int64_t chunk = std::max(grain, (count + wanted - 1) / wanted);
    const int64_t chunks = (count + chunk - 1) / chunk;
    shared_pool().for_each(chunks,
                           [&](int64_t i) { body(i * chunk, std::min(count, (i + 1) * chunk)); });
}

}  // namespace tp
