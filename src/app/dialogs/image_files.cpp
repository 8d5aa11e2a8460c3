// The picture as it is now: to a file, with or without the interface, or to the clipboard.
#include "../jobs/clipboard.h"
#include "dialogs.h"
#include "file_question.h"

#include <teapath/core/error.h>
#include <teapath/io/image_file.h>
#include <teapath/render/output_files.h>
#include <teapath/render/rendered_image.h>

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <future>
#include <utility>

namespace tp {
namespace {

namespace fs = std::filesystem;

std::string scene_name(const Document& document) {
    return document.file().empty() ? "untitled.json" : document.file().filename().string();
}

// What the renderer holds, once its thread comes to it.
std::future<RenderedImage> rendered_now(PanelContext& c, const std::vector<fs::path>& files) {
    const auto promise = std::make_shared<std::promise<RenderedImage>>();
    c.worker.post([promise, files, name = scene_name(c.document)](const Session& session,
                                                                  const Scene& scene) {
        try {
            promise->set_value(rendered_image(session, scene, name, files, 0));
        } catch (...) {
            promise->set_exception(std::current_exception());
        }
    });
    return promise->get_future();
}

// Nothing if the job is cancelled first.
bool wait_for(const std::future<RenderedImage>& image, const JobControl& control) {
    while (image.wait_for(std::chrono::milliseconds(20)) != std::future_status::ready)
        if (control.is_cancelled()) return false;
    return true;
}

void save_image(PanelContext& c, const fs::path& file) {
    const std::vector<fs::path> files = {file};
    const auto image = std::make_shared<std::future<RenderedImage>>(rendered_now(c, files));
    JobOptions options;
    options.title = fmt::format("Writing {}", file.filename().string());
    c.ui.jobs.start(std::move(options), [files, image](JobControl& control) -> JobFinish {
        check_outputs(files);
        if (!wait_for(*image, control)) return nullptr;
        const RenderedImage rendered = image->get();
        write_files(files, rendered);
        return [file = files.front(), spp = rendered.metadata.at("samples")](PanelContext& p) {
            p.toast(fmt::format("Wrote {}, {} spp", file.string(), spp));
        };
    });
}

void ask(PanelContext& c, const char* title, const std::string& name,
         std::function<void(PanelContext&, const fs::path&)> then) {
    FileQuestion question;
    question.title = title;
    question.accept = "Save";
    question.saves = true;
    question.filters = picture_filters();
    question.purpose = "image";
    question.suggestion = name;
    question.extension = ".png";
    question.then = std::move(then);
    ask_for_file(c, std::move(question));
}

std::string stem(const Document& document) {
    return document.file().empty() ? "untitled" : document.file().stem().string();
}

}  // namespace

void ask_to_save_image(PanelContext& c) {
    ask(c, "Save the image as", stem(c.document) + ".png", save_image);
}

void ask_to_save_window(PanelContext& c) {
    ask(c, "Save a picture of the window as", stem(c.document) + "_window.png",
        [](PanelContext& p, const fs::path& file) { p.ui.dialogs.window_image = file; });
}

void take_window_image(PanelContext& c) {
    if (c.ui.dialogs.window_image.empty()) return;
    const fs::path file = std::exchange(c.ui.dialogs.window_image, {});
    Picture picture;
    picture.display = c.window.read_pixels(picture.width, picture.height);
    picture.metadata = {{"program", "Teapath"}, {"scene", scene_name(c.document)}};
    JobOptions options;
    options.title = fmt::format("Writing {}", file.filename().string());
    c.ui.jobs.start(std::move(options), [file, picture](JobControl&) -> JobFinish {
        if (content_of(file) != FileContent::Display)
            throw Error(ErrorKind::Usage, "the window has no linear radiance", file.string(),
                        "save it as .png, .jpg, .bmp, .tga or .ppm");
        check_outputs({file});
        write_picture(file, picture);
        return [file](PanelContext& p) { p.toast(fmt::format("Wrote {}", file.string())); };
    });
}

std::string why_not_copied() {
    return why_no_clipboard();
}

void copy_image(PanelContext& c) {
    std::error_code ignored;
    const fs::path file =
        fs::temp_directory_path(ignored) / fmt::format("teapath_copy_{}.png", getpid());
    const auto image = std::make_shared<std::future<RenderedImage>>(rendered_now(c, {file}));
    JobOptions options;
    options.title = "Copying the image";
    c.ui.jobs.start(std::move(options), [file, image](JobControl& control) -> JobFinish {
        if (!wait_for(*image, control)) return nullptr;
        const struct FileEnd {
            fs::path file;
            ~FileEnd() {
                std::error_code error;
                fs::remove(file, error);
            }
        } file_end{file};
        write_files({file}, image->get());
        copy_png(file);
        return [](PanelContext& p) { p.toast("The image is in the clipboard"); };
    });
}

}  // namespace tp
