// Images to the desktop's clipboard, by the tools that Linux desktops have for it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace tp {

/// The command that puts a PNG from its standard input into the clipboard: wl-copy on Wayland,
/// xclip on X11. Empty where there is none.
std::vector<std::string> clipboard_command();

/// Gives the file to the command. Throws Error(Output).
void copy_png(const std::filesystem::path& file);

/// Why there is no clipboard for images; empty if there is one.
std::string why_no_clipboard();

}  // namespace tp
