// Fonts and colours of the interface.
#pragma once

struct ImFont;

namespace tp {

/// Loads the fonts for this scale of the interface; the built-in one where a file is missing.
void load_fonts(float scale);
/// The monospaced font of the console.
ImFont* monospaced_font();

void apply_theme(bool dark, float scale);

}  // namespace tp
