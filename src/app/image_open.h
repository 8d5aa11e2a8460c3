// Images for textures and the background: asks for a file and reads it without holding up a frame.
#pragma once

#include <teapath/editor/document.h>

#include <filesystem>
#include <future>
#include <memory>
#include <string>
#include <vector>

namespace pfd {
class open_file;
}

namespace tp {

class ImageOpen {
public:
    ImageOpen();
    ~ImageOpen();

    /// Asks for a file for that texture, or for the background: by the desktop's dialog where it
    /// has one, else by a small one of our own.
    void ask(SceneItem owner, const Scene& scene, const std::string& path);
    /// Reads that file for it, in the background.
    void load(SceneItem owner, const std::filesystem::path& file);
    bool is_busy(SceneItem owner) const;

    /// Draws the own dialog, and puts what was read into the document: one edit. Called once a
    /// frame; returns what went wrong, for a notice, or nothing.
    std::string update(Document& document);

private:
    struct Loading {
        SceneItem owner;
        std::filesystem::path file;
        std::future<std::shared_ptr<const Image>> image;
    };
    void draw_own_dialog();

    SceneItem owner_;  // for whom a file is being asked
    std::unique_ptr<pfd::open_file> dialog_;
    bool shows_own_dialog_ = false;
    std::string typed_;
    std::vector<Loading> loading_;
};

}  // namespace tp
