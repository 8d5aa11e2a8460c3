// Fonts and colours of the interface.
#pragma once

struct ImFont;

namespace tp {

/// Loads the fonts for this scale of the interface; the built-in one where a file is missing.
void load_fonts(float scale);
/// The monospaced font of the console.
ImFont* monospaced_font();

void apply_dark_theme(float scale);
void apply_light_theme(float scale);

}  // namespace tp
