// "Which file?", asked by the desktop's own dialog where there is one and else by a browser drawn
// here. Neither holds up a frame; the answer comes in a later one.
#pragma once

#include "folder_list.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace tp {

struct PanelContext;

struct FileQuestion {
    std::string title;   // "Open a scene or a model"
    std::string accept;  // the button: "Open", "Save"
    bool saves = false;  // the file may be new; a replaced one is asked about
    std::vector<FileFilter> filters;
    std::string purpose;               // whose last folder is remembered: "scene", "image"
    std::filesystem::path suggestion;  // a file or its name; may be empty
    std::string extension;             // added to a saved name without one: ".json"
    std::function<void(PanelContext&, const std::filesystem::path&)> then;
};

/// Asks; a question that is open is given up for it.
void ask_for_file(PanelContext& c, FileQuestion question);
bool is_asking_for_file(const PanelContext& c);
/// Draws and polls; once a frame.
void draw_file_question(PanelContext& c);

/// Scenes, and every file.
std::vector<FileFilter> scene_filters();
/// Images that can be read.
std::vector<FileFilter> texture_filters();
/// Models and meshes.
std::vector<FileFilter> model_filters();
/// What opens as a scene: scenes and models, together and apart, and every file.
std::vector<FileFilter> openable_filters();
/// Images that can be written.
std::vector<FileFilter> picture_filters();

/// Finds out in the background whether the desktop has a dialog; called at the start.
void look_for_native_dialogs();

/// The state of an open question.
struct FileDialog;

/// Draws the browser; true once the question is answered or given up (then `chosen` is empty).
bool draw_file_browser(FileDialog& dialog, std::filesystem::path& chosen);

}  // namespace tp
