// Images from files for textures and the background.
#include "dialogs.h"
#include "file_question.h"
#include "path_in_scene.h"

#include <teapath/editor/scene_edits.h>
#include <teapath/io/image_file.h>

#include <fmt/format.h>

namespace tp {
namespace {

namespace fs = std::filesystem;

void put_image(Document& document, SceneItem owner, const ImageFile& image) {
    document.edit(fmt::format("Image of {}", item_name(document.scene(), owner)), "",
                  [&](Scene& s) {
                      if (owner.kind == ItemKind::Background) {
                          s.background.kind = BackgroundKind::Image;
                          s.background.file = image;
                      } else if (Texture* t = find_texture(s, TextureId{owner.id})) {
                          t->kind = TextureKind::Image;
                          t->file = image;
                      }
                  });
}

}  // namespace

void read_image_then(PanelContext& c, const fs::path& file,
                     std::function<void(PanelContext&, const ImageFile&)> then) {
    JobOptions options;
    options.title = fmt::format("Reading {}", file.filename().string());
    c.ui.jobs.start(std::move(options), [file, then = std::move(then)](JobControl&) -> JobFinish {
        const auto image = std::make_shared<const Image>(read_image(file));
        return [file, then, image](PanelContext& p) {
            then(p, {path_in_scene(p.document.scene(), file), image});
        };
    });
}

void ask_for_image(PanelContext& c, SceneItem owner, const std::string& present) {
    FileQuestion question;
    question.title = "Open an image";
    question.accept = "Open";
    question.filters = texture_filters();
    question.purpose = "texture";
    question.suggestion = fs::path(c.document.scene().origin.folder) / present;
    question.then = [owner](PanelContext& p, const fs::path& file) {
        read_image_then(p, file, [owner](PanelContext& q, const ImageFile& image) {
            put_image(q.document, owner, image);
        });
    };
    ask_for_file(c, std::move(question));
}

}  // namespace tp
