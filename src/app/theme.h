// Fonts and colours of the interface.
#pragma once

#include "palette.h"

struct ImFont;
struct ImVec4;

namespace tp {

/// Loads the fonts for this scale of the interface.
void load_fonts(float scale);
/// The monospaced font of the console.
ImFont* monospaced_font();
/// The font of headings.
ImFont* bold_font();

void apply_theme(bool dark, float scale);

/// The colours of the theme that was applied last.
const Palette& theme();
ImVec4 to_color(Rgb rgb, float alpha = 1);

}  // namespace tp
