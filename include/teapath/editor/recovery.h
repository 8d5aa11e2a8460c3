// What a crash leaves behind: each program that runs keeps its unsaved scene in a file of its own,
// and finds those of programs that ended without taking theirs away. Never the user's own file.
#pragma once

#include <teapath/scene/scene.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace tp {

/// A file that is locked while this lives; the lock goes with the process, however it ends.
class FileLock {
public:
    /// Makes the file if there is none. Not held if another process or object holds it.
    explicit FileLock(const std::filesystem::path& file);
    ~FileLock();
    FileLock(const FileLock&) = delete;
    FileLock& operator=(const FileLock&) = delete;

    bool is_held() const { return fd_ >= 0; }

private:
    int fd_ = -1;
};

/// The file into which this process writes its unsaved scene now and then. Thread-safe. A clean end
/// takes it away.
class AutosaveFile {
public:
    /// `folder` is made where it is missing; that it cannot be is found out by `write`.
    explicit AutosaveFile(const std::filesystem::path& folder);
    ~AutosaveFile();

    /// What `remove` and `write` compare; taken when the scene is, on the interface thread.
    uint64_t ticket() const;
    /// Writes the scene whole or not at all, with the user's file that it belongs to (may be
    /// empty). Does nothing if `remove` was called after the ticket was taken. Throws
    /// Error(Output).
    void write(const Scene& scene, const std::filesystem::path& original, uint64_t ticket);
    /// The scene is saved or given up: nothing is left to recover.
    void remove();

private:
    mutable std::mutex mutex_;
    std::filesystem::path folder_, stem_;
    std::unique_ptr<FileLock> lock_;
    uint64_t ticket_ = 1;
};

/// What a process that is no more has left.
struct Leftover {
    std::filesystem::path scene;     // the autosaved file
    std::filesystem::path original;  // the user's file, or empty
    std::chrono::system_clock::time_point time;
    std::shared_ptr<FileLock> lock;  // keeps others from offering it too

    /// Takes its files away.
    void discard() const;
};

/// All leftovers of a folder, the newest first; those of running processes are not among them.
std::vector<Leftover> find_leftovers(const std::filesystem::path& folder);

}  // namespace tp
