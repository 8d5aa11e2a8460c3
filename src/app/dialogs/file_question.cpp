#include "file_question.h"

#include "../context.h"
#include "file_dialog.h"

#include <portable_file_dialogs.h>

#include <future>
#include <utility>

namespace tp {
namespace {

namespace fs = std::filesystem;

// Answered by a thread, for the question runs programs.
std::shared_future<bool>& native_dialogs() {
    static std::shared_future<bool> answer;
    return answer;
}

bool has_native_dialogs() {
    look_for_native_dialogs();
    return native_dialogs().get();
}

// "Scenes (*.json)", "*.json", …
std::vector<std::string> native_filters(const std::vector<FileFilter>& filters) {
    std::vector<std::string> list;
    for (const FileFilter& filter : filters) {
        std::string patterns;
        for (const std::string& extension : filter.extensions)
            patterns += (patterns.empty() ? "*" : " *") + extension;
        list.push_back(filter.label());
        list.push_back(patterns.empty() ? "*" : patterns);
    }
    return list;
}

// Where to begin: the folder of the suggestion, else the one used last, else the home folder.
fs::path start_folder(PanelContext& c, const FileQuestion& question) {
    std::error_code ignored;
    if (question.suggestion.has_parent_path() &&
        fs::is_directory(question.suggestion.parent_path(), ignored))
        return fs::absolute(question.suggestion.parent_path(), ignored);
    const auto remembered = c.ui.preferences.folders.find(question.purpose);
    if (remembered != c.ui.preferences.folders.end() &&
        fs::is_directory(remembered->second, ignored))
        return remembered->second;
    return fs::current_path(ignored);
}

void start_native(FileDialog& dialog) {
    const FileQuestion& q = dialog.question;
    const std::string at = (dialog.folder / q.suggestion.filename()).string();
    if (q.saves)
        dialog.native_save =
            std::make_shared<pfd::save_file>(q.title, at, native_filters(q.filters));
    else
        dialog.native_open =
            std::make_shared<pfd::open_file>(q.title, at, native_filters(q.filters));
}

// True once the native dialog is closed.
bool poll_native(FileDialog& dialog, fs::path& chosen) {
    if (dialog.native_save) {
        if (!dialog.native_save->ready(0)) return false;
        chosen = dialog.native_save->result();
        return true;
    }
    if (!dialog.native_open->ready(0)) return false;
    const std::vector<std::string> files = dialog.native_open->result();
    if (!files.empty()) chosen = files.front();
    return true;
}

void give_up(FileDialog& dialog) {
    // Its destructor would wait for the user.
    if (dialog.native_open) dialog.native_open->kill();
    if (dialog.native_save) dialog.native_save->kill();
}

}  // namespace

void look_for_native_dialogs() {
    if (!native_dialogs().valid())
        native_dialogs() =
            std::async(std::launch::async, [] { return pfd::settings::available(); }).share();
}

void ask_for_file(PanelContext& c, FileQuestion question) {
    if (c.ui.dialogs.file) give_up(*c.ui.dialogs.file);
    auto dialog = std::make_shared<FileDialog>();
    dialog->question = std::move(question);
    dialog->folder = start_folder(c, dialog->question);
    if (dialog->question.saves) dialog->name = dialog->question.suggestion.filename().string();
    if (c.ui.preferences.native_dialogs && has_native_dialogs()) start_native(*dialog);
    c.ui.dialogs.file = std::move(dialog);
}

bool is_asking_for_file(const PanelContext& c) {
    return c.ui.dialogs.file != nullptr;
}

void draw_file_question(PanelContext& c) {
    const std::shared_ptr<FileDialog> dialog = c.ui.dialogs.file;
    if (!dialog) return;
    fs::path chosen;
    const bool is_answered =
        dialog->is_native() ? poll_native(*dialog, chosen) : draw_file_browser(*dialog, chosen);
    if (!is_answered) return;
    // The answer may ask for the next file.
    c.ui.dialogs.file.reset();
    if (chosen.empty()) return;
    const FileQuestion& q = dialog->question;
    if (q.saves && !chosen.has_extension()) chosen += q.extension;
    c.ui.preferences.folders[q.purpose] = chosen.parent_path().string();
    q.then(c, chosen);
}

std::vector<FileFilter> scene_filters() {
    return {{"Scenes", {".json"}}, {"All files", {}}};
}

std::vector<FileFilter> openable_filters() {
    std::vector<FileFilter> filters = {scene_filters().front(), model_filters().front()};
    FileFilter both{"Scenes and models", filters[0].extensions};
    both.extensions.insert(both.extensions.end(), filters[1].extensions.begin(),
                           filters[1].extensions.end());
    filters.insert(filters.begin(), both);
    filters.push_back({"All files", {}});
    return filters;
}

std::vector<FileFilter> texture_filters() {
    return {{"Images",
             {".png", ".jpg", ".jpeg", ".hdr", ".exr", ".tga", ".bmp", ".psd", ".gif", ".pic",
              ".pnm", ".ppm", ".pgm"}},
            {"All files", {}}};
}

std::vector<FileFilter> picture_filters() {
    return {
        {"All pictures", {".png", ".jpg", ".jpeg", ".exr", ".hdr", ".bmp", ".tga", ".ppm", ".pfm"}},
        {"PNG", {".png"}},
        {"JPEG", {".jpg", ".jpeg"}},
        {"OpenEXR, linear", {".exr"}},
        {"Radiance HDR, linear", {".hdr"}},
        {"All files", {}}};
}

}  // namespace tp
