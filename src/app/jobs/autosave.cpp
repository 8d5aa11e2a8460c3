#include "autosave.h"

#include "jobs.h"

#include <teapath/core/log.h>

#include <cstdlib>
#include <utility>

namespace tp {

void Autosave::start(const std::filesystem::path& folder, double seconds) {
    leftovers = find_leftovers(folder);
    file_ = std::make_shared<AutosaveFile>(folder);
    seconds_ = seconds;
}

void Autosave::take_over(Leftover leftover) {
    taken_.push_back(std::move(leftover));
    written_scene_ = nullptr;
    last_ = {};  // at once
}

void Autosave::update(const Document& document, Jobs& jobs, int minutes, bool is_dragging) {
    if (!file_ || (job_ != 0 && jobs.is_running(job_))) return;
    const auto now = std::chrono::steady_clock::now();
    const bool job_ended = std::exchange(job_, 0) != 0;
    if (!document.is_modified()) {
        if (is_written_) file_->remove();
        is_written_ = false;
        written_scene_ = nullptr;
        last_ = now;
        for (const Leftover& leftover : std::exchange(taken_, {}))
            leftover.discard();
        return;
    }
    // Written with this window's own lock: the crashed one's file has done its duty.
    if (job_ended && is_written_)
        for (const Leftover& leftover : std::exchange(taken_, {}))
            leftover.discard();
    const double wait = seconds_ > 0 ? seconds_ : 60.0 * minutes;
    if (wait <= 0 || is_dragging || document.snapshot() == written_scene_) return;
    if (std::chrono::duration<double>(now - last_).count() < wait) return;

    last_ = now;
    written_scene_ = document.snapshot();
    is_written_ = true;
    JobOptions options;
    options.title = "Autosave";
    options.is_shown = false;
    options.is_gentle = true;
    options.failed = [this](PanelContext&, const std::string& error) {
        is_written_ = false;
        if (!failed_) log_warning("autosave: {}", error);
        failed_ = true;
    };
    job_ = jobs.start(std::move(options),
                      [file = file_, scene = written_scene_, original = document.file(),
                       ticket = file_->ticket()](JobControl&) -> JobFinish {
                          file->write(*scene, original, ticket);
                          return nullptr;
                      });
}

std::filesystem::path state_folder() {
    const char* xdg = std::getenv("XDG_STATE_HOME");
    const char* home = std::getenv("HOME");
    return (xdg && *xdg ? std::filesystem::path(xdg)
                        : std::filesystem::path(home ? home : ".") / ".local" / "state") /
           "teapath";
}

}  // namespace tp
