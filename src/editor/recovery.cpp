#include <teapath/core/error.h>
#include <teapath/core/log.h>
#include <teapath/editor/recovery.h>
#include <teapath/io/scene_file.h>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>

namespace tp {
namespace {

namespace fs = std::filesystem;

// Three files of one process: NAME.json the scene, NAME.from the user's file, NAME.lock.
fs::path with(const fs::path& stem, const char* extension) {
    fs::path file = stem;
    return file += extension;
}

void remove_files(const fs::path& stem) {
    std::error_code ignored;
    for (const char* extension : {".json", ".from", ".lock"})
        fs::remove(with(stem, extension), ignored);
}

// Linux has no way from a file's clock to the system's; both count from the same start.
std::chrono::system_clock::time_point time_of(const fs::path& file) {
    struct stat status = {};
    if (stat(file.c_str(), &status) != 0) return {};
    return std::chrono::system_clock::from_time_t(status.st_mtime);
}

}  // namespace

FileLock::FileLock(const fs::path& file) {
    fd_ = open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
    if (fd_ < 0) return;
    // Whoever held it may have removed the file between open and flock: then this locks nothing.
    struct stat opened = {}, named = {};
    const bool locked = flock(fd_, LOCK_EX | LOCK_NB) == 0 && fstat(fd_, &opened) == 0 &&
                        stat(file.c_str(), &named) == 0 && opened.st_ino == named.st_ino;
    if (locked) return;
    close(fd_);
    fd_ = -1;
}

FileLock::~FileLock() {
    if (fd_ >= 0) close(fd_);
}

AutosaveFile::AutosaveFile(const fs::path& folder) : folder_(folder) {
    std::error_code ignored;
    fs::create_directories(folder, ignored);
    for (int n = 0; n < 100; ++n) {
        stem_ = folder / fmt::format("{}-{}", getpid(), n);
        // What an older process of this number left is not touched.
        if (fs::exists(with(stem_, ".json"), ignored)) continue;
        lock_ = std::make_unique<FileLock>(with(stem_, ".lock"));
        if (lock_->is_held()) return;
    }
    log_warning("autosave: {} cannot be written to", folder.string());
}

AutosaveFile::~AutosaveFile() {
    if (lock_ && lock_->is_held()) remove_files(stem_);
}

uint64_t AutosaveFile::ticket() const {
    const std::lock_guard guard(mutex_);
    return ticket_;
}

void AutosaveFile::write(const Scene& scene, const fs::path& original, uint64_t ticket) {
    const std::lock_guard guard(mutex_);
    if (ticket != ticket_) return;
    if (!lock_ || !lock_->is_held())
        throw Error(ErrorKind::Output, "the scene cannot be kept for recovery", folder_.string(),
                    "save it yourself, or make the folder writable");
    // The origin first: a scene without it would be recovered as a new one.
    {
        std::ofstream out(with(stem_, ".from"), std::ios::binary);
        out << (original.empty() ? "" : fs::absolute(original).string());
    }
    save_scene(scene, with(stem_, ".json"));
}

void AutosaveFile::remove() {
    const std::lock_guard guard(mutex_);
    ++ticket_;
    std::error_code ignored;
    fs::remove(with(stem_, ".json"), ignored);
    fs::remove(with(stem_, ".from"), ignored);
}

void Leftover::discard() const {
    fs::path stem = scene;
    remove_files(stem.replace_extension());
}

std::vector<Leftover> find_leftovers(const fs::path& folder) {
    std::vector<Leftover> found;
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
        if (entry.path().extension() != ".json") continue;
        fs::path stem = entry.path();
        stem.replace_extension();
        auto lock = std::make_shared<FileLock>(with(stem, ".lock"));
        if (!lock->is_held()) continue;
        Leftover leftover{entry.path(), {}, time_of(entry.path()), std::move(lock)};
        std::string original;
        std::getline(std::ifstream(with(stem, ".from"), std::ios::binary), original, '\0');
        leftover.original = original;
        found.push_back(std::move(leftover));
    }
    std::sort(found.begin(), found.end(),
              [](const Leftover& a, const Leftover& b) { return a.time > b.time; });
    return found;
}

}  // namespace tp
