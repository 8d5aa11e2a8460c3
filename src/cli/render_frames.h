// Frames of an animation, one after the other, into files with numbers.
#pragma once

#include "interrupt.h"
#include "render_options.h"

#include <teapath/render/session.h>

#include <filesystem>
#include <vector>

namespace tp {

/// The file of a frame: the last `#`s of the name become its number, with as many digits at least.
/// Throws Error(Usage) for a name without them.
std::filesystem::path frame_path(const std::filesystem::path& pattern, int frame);

/// The files of a frame.
std::vector<std::filesystem::path> frame_paths(const RenderOptions& options, int frame);

/// Renders the frames at their times: frame n at n over the frames a second. One that is
/// interrupted is not written, those before it stay. Returns the exit code.
int render_frames(const RenderOptions& options, const Scene& scene, Session& session,
                  Interrupt& interrupt);

}  // namespace tp
