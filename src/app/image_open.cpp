#include "image_open.h"

#include <teapath/editor/scene_edits.h>
#include <teapath/io/image_file.h>

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>
#include <portable_file_dialogs.h>

#include <chrono>

namespace tp {
namespace {

// As the scene file would name it: relative to its folder where the file lies in it.
std::string path_in_scene(const Scene& scene, const std::filesystem::path& file) {
    if (scene.origin.folder.empty()) return file.string();
    const std::filesystem::path relative =
        file.lexically_relative(std::filesystem::absolute(scene.origin.folder).lexically_normal());
    const bool is_inside = !relative.empty() && *relative.begin() != "..";
    return (is_inside ? relative : file).string();
}

void put_image(Document& document, SceneItem owner, const ImageFile& file) {
    document.edit(fmt::format("Image of {}", item_name(document.scene(), owner)), "",
                  [&](Scene& s) {
                      if (owner.kind == ItemKind::Background) {
                          s.background.kind = BackgroundKind::Image;
                          s.background.file = file;
                      } else if (Texture* t = find_texture(s, TextureId{owner.id})) {
                          t->kind = TextureKind::Image;
                          t->file = file;
                      }
                  });
}

}  // namespace

ImageOpen::ImageOpen() = default;
ImageOpen::~ImageOpen() = default;

void ImageOpen::ask(SceneItem owner, const Scene& scene, const std::string& path) {
    owner_ = owner;
    std::filesystem::path start = scene.origin.folder.empty() ? "." : scene.origin.folder;
    if (!path.empty()) start /= path;
    if (!pfd::settings::available()) {
        typed_ = path.empty() ? std::string() : start.string();
        shows_own_dialog_ = true;
        return;
    }
    dialog_ = std::make_unique<pfd::open_file>(
        "Open an image", start.string(),
        std::vector<std::string>{"Images", "*.png *.jpg *.jpeg *.tga *.bmp *.hdr *.exr *.pnm *.ppm",
                                 "All files", "*"});
}

void ImageOpen::load(SceneItem owner, const std::filesystem::path& file) {
    const std::filesystem::path whole = std::filesystem::absolute(file).lexically_normal();
    loading_.push_back({owner, whole, std::async(std::launch::async, [whole] {
                            return std::make_shared<const Image>(read_image(whole));
                        })});
}

bool ImageOpen::is_busy(SceneItem owner) const {
    for (const Loading& l : loading_)
        if (l.owner == owner) return true;
    return false;
}

void ImageOpen::draw_own_dialog() {
    const char* const title = "Open an image";
    if (shows_own_dialog_ && !ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
    ImGui::SetNextWindowSize({ImGui::GetFontSize() * 32, 0}, ImGuiCond_Appearing);
    if (!ImGui::BeginPopupModal(title, &shows_own_dialog_, ImGuiWindowFlags_NoSavedSettings))
        return;
    if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(-1);
    bool done = ImGui::InputTextWithHint("##path", "Path of an image file", &typed_,
                                         ImGuiInputTextFlags_EnterReturnsTrue);
    ImGui::Spacing();
    done |= ImGui::Button("Open") && !typed_.empty();
    ImGui::SameLine();
    if (ImGui::Button("Cancel") || ImGui::IsKeyPressed(ImGuiKey_Escape)) shows_own_dialog_ = false;
    if (done && !typed_.empty()) {
        load(owner_, typed_);
        shows_own_dialog_ = false;
    }
    if (!shows_own_dialog_) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

std::string ImageOpen::update(Document& document) {
    draw_own_dialog();
    if (dialog_ && dialog_->ready(0)) {
        const std::vector<std::string> chosen = dialog_->result();
        dialog_.reset();
        if (!chosen.empty()) load(owner_, chosen.front());
    }
    std::string problem;
    for (size_t i = 0; i < loading_.size();) {
        Loading& l = loading_[i];
        if (l.image.wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
            ++i;
            continue;
        }
        try {
            put_image(document, l.owner, {path_in_scene(document.scene(), l.file), l.image.get()});
        } catch (const std::exception& error) {
            problem = error.what();
        }
        loading_.erase(loading_.begin() + static_cast<std::ptrdiff_t>(i));
    }
    return problem;
}

}  // namespace tp
