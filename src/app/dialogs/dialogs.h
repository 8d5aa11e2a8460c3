// The windows that ask something, and what they lead to. Reading and writing files are jobs: the
// document changes in a later frame.
#pragma once

#include "../context.h"

#include <teapath/io/model_file.h>

namespace tp {

/// Draws the dialogs that are open, polls the jobs and the native dialogs; once a frame.
void draw_dialogs(PanelContext& c);

// Scenes (scene_files.cpp).
/// Does `then` at once, or after the question about unsaved changes. `verb` is for the question:
/// "opening another scene".
void ask_first(PanelContext& c, const std::string& verb, std::function<void(PanelContext&)> then);
/// Reads a scene file and takes its scene; a broken one is a message, and the old scene stays.
/// Asks nothing.
void open_scene(PanelContext& c, const std::filesystem::path& file);
/// The message about a scene file that cannot be read.
void show_unreadable(UiState& ui, const std::filesystem::path& file, const std::string& error);
/// Asks which file to open.
void ask_to_open(PanelContext& c);
/// Saves under the document's name, or asks for one; then goes on with `then`, if it was saved.
void save_scene_or_ask(PanelContext& c, std::function<void(PanelContext&)> then = nullptr);
void ask_to_save_as(PanelContext& c, std::function<void(PanelContext&)> then = nullptr);
/// Ends the program, after the questions about what would be lost.
void ask_to_quit(PanelContext& c);
/// The items of "Open recent".
void draw_recent_files(PanelContext& c);
void draw_unsaved_question(PanelContext& c);

// Images for textures and the background (texture_files.cpp).
/// Reads an image, and in a later frame does `then` with it, named as the scene is to name it.
void read_image_then(PanelContext& c, const std::filesystem::path& file,
                     std::function<void(PanelContext&, const ImageFile&)> then);
/// Asks for an image for that texture, or for the background; `present` is the path it has now.
void ask_for_image(PanelContext& c, SceneItem owner, const std::string& present);

// Meshes and models (model_files.cpp).
/// Reads a model, and in a later frame adds it, placed in view; a mesh (.ply, .stl) as one object.
/// In place of a scene that is empty and untouched it is opened.
void open_model(PanelContext& c, const std::filesystem::path& file);
/// Asks for a model to add.
void ask_for_model(PanelContext& c);
/// Makes a procedural mesh ("procedural://knot?p=2"), and in a later frame adds it, placed in view.
void make_mesh(PanelContext& c, const std::string& recipe, const std::string& label);
/// Makes it, and in a later frame these objects have it in place of the mesh that they had.
void change_mesh(PanelContext& c, const std::vector<ObjectId>& objects, const std::string& recipe);
/// Options of a reading in a job: it shows how far it is, and can be cancelled.
ModelReadOptions reading_in(JobControl& control);

// Files dropped on the window (drop.cpp).
/// A scene is opened, after the question; a model is added; an image becomes the selected objects'
/// colour or, over the viewport with nothing selected, the background; anything else is a notice.
void drop_file(PanelContext& c, const std::filesystem::path& file);

// Pictures (image_files.cpp).
void ask_to_save_image(PanelContext& c);
/// With the interface: the window's pixels.
void ask_to_save_window(PanelContext& c);
void copy_image(PanelContext& c);
/// Why the picture cannot go to the clipboard; empty if it can.
std::string why_not_copied();
/// Takes the window's pixels where they were asked for; after the frame is drawn.
void take_window_image(PanelContext& c);

/// The windows, each drawn where it is open.
void draw_export_window(PanelContext& c);
void draw_messages(PanelContext& c);
void draw_recovery_window(PanelContext& c);
void draw_save_layout_window(PanelContext& c);
/// The table of keys, from the action table.
void draw_keys_window(PanelContext& c);

/// The user's settings.
void draw_settings_window(PanelContext& c);
/// Shows a text until it is closed, and logs it; for errors that are longer than a notice.
void show_message(UiState& ui, const std::string& title, const std::string& text);

/// A window of a few lines in the middle of the screen; ImGui::End follows always.
bool begin_note(const char* title, bool* is_open);
/// A question that is answered before anything else; ImGui::EndPopup follows where it is true.
bool begin_question(const char* title);

}  // namespace tp
