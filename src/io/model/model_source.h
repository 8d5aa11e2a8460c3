// Where a model file comes from, and the files beside it that it names: buffers, images, material
// libraries.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace tp {

struct ModelSource {
    std::string name;                      // of the file, in messages
    std::filesystem::path folder;          // that the names of other files start from
    bool allow_outside = false;            // they may leave it
    bool has_files = true;                 // false: there is nothing but the bytes at hand
    std::function<bool(double)> progress;  // see ModelReadOptions
    uint64_t memory = 0;                   // most bytes that meshes and images may take; 0 = all
};

/// The path of a file that a model names; both slashes part its folders. Throws Error(Input) at
/// `where` if it is empty, a web address, absolute or above the folder (unless allowed).
std::filesystem::path path_beside(const ModelSource& source, std::string_view name,
                                  const std::string& where);

/// All bytes of that file. Throws Error(Input).
std::string read_beside(const ModelSource& source, std::string_view name, const char* kind,
                        const std::string& where);

/// Bytes that a model may take: source.memory, or three quarters of what the machine has.
uint64_t memory_for(const ModelSource& source);

/// What the images of a model may take, counted before each is decoded, on any thread.
class ImageBudget {
public:
    explicit ImageBudget(const ModelSource& source) : source_(source) {}
    /// Throws Error(Input) if this image would take what is more than memory_for.
    void take(std::string_view bytes);

private:
    const ModelSource& source_;
    std::atomic<uint64_t> taken_{0};
};

/// Throws Error(Input) if that many bytes are more than memory_for.
void check_memory(const ModelSource& source, double bytes);

}  // namespace tp
