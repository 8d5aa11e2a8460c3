// Small pictures of materials and textures for tree and inspector. Materials are rendered by one
// thread of low priority, one at a time, and kept by what they look like.
#pragma once

#include "../display/gl_texture.h"

#include <teapath/scene/scene.h>

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <unordered_map>
#include <vector>

namespace tp {

class Previews {
public:
    static constexpr int kSize = 64;      // pixels
    static constexpr int kSamples = 16;   // of each pixel
    static constexpr size_t kMost = 256;  // pictures that are kept

    Previews();
    ~Previews();
    Previews(const Previews&) = delete;
    Previews& operator=(const Previews&) = delete;

    /// GL texture of a material's picture; 0 while it is rendered, which this asks for.
    uint64_t material(const Scene& scene, const Material& material);
    /// GL texture of a texture's picture: an image's thumbnail, or a pattern, which this asks for;
    /// 0 while it is rendered, and for what the caller draws, constants and checkers.
    uint64_t texture(const Scene& scene, const Texture& texture);
    /// GL texture of an image's thumbnail; 0 without an image.
    uint64_t image(const std::shared_ptr<const Image>& image);

    /// Takes what the thread has finished. Called once a frame.
    void begin_frame();

    /// True where all that were asked for are there; for tests.
    bool is_complete() const;
    /// Pictures rendered so far; for tests.
    size_t rendered() const { return rendered_; }

private:
    struct Entry {
        std::unique_ptr<GlTexture> texture;  // null: asked for
        std::shared_ptr<const Image> image;  // keeps the key of an image its own
        uint64_t last_used = 0;              // frame
    };
    struct Job {
        uint64_t key = 0;
        uint64_t owner = 0;  // owner_of
        std::shared_ptr<const Scene> scene;
    };
    struct Picture {
        uint64_t key = 0;
        std::vector<uint8_t> rgb;
    };
    void run();
    /// The picture of that key, or the owner's last one; `make` makes the scene to be rendered.
    template <class Make>
    uint64_t rendered_picture(uint64_t key, uint64_t owner, const Make& make);
    void ask(uint64_t key, uint64_t owner, std::shared_ptr<const Scene> scene);
    void forget_oldest();

    std::unordered_map<uint64_t, Entry> entries_;
    std::unordered_map<uint64_t, uint64_t> shown_;  // by owner: the picture shown last
    uint64_t frame_ = 0;
    size_t rendered_ = 0;

    std::mutex mutex_;
    std::condition_variable wake_;
    std::deque<Job> jobs_;
    std::vector<Picture> finished_;
    bool stopping_ = false;
    std::thread thread_;
};

}  // namespace tp
