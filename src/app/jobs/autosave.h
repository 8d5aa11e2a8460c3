// Keeps the unsaved scene of this window where the next start finds it after a crash.
#pragma once

#include <teapath/editor/document.h>
#include <teapath/editor/recovery.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <vector>

namespace tp {

class Jobs;

class Autosave {
public:
    /// Begins to keep files in `folder`; `seconds` replaces the minutes of the settings, 0 = none.
    void start(const std::filesystem::path& folder, double seconds = 0);

    /// Once a frame: writes the document, as a job, where it has changes and the time has come;
    /// takes the file away where it has none. `is_dragging`: not now.
    void update(const Document& document, Jobs& jobs, int minutes, bool is_dragging);

    /// What earlier programs left and nobody has decided on.
    std::vector<Leftover> leftovers;
    /// Keeps a leftover until its scene, now in the document, is in a file of this window's own.
    void take_over(Leftover leftover);

private:
    std::shared_ptr<AutosaveFile> file_;
    double seconds_ = 0;
    std::vector<Leftover> taken_;
    bool is_written_ = false;     // the file holds something
    bool failed_ = false;         // and it was said
    uint64_t written_edits_ = 0;  // what was written last
    ScenePtr written_scene_;
    uint64_t job_ = 0;
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// The user's folder for what is neither settings nor cache ($XDG_STATE_HOME or ~/.local/state,
/// teapath).
std::filesystem::path state_folder();

}  // namespace tp
