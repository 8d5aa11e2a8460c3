// The colours of the interface, as numbers: no ImGui, so that tests can measure their contrast.
#pragma once

#include <cmath>
#include <cstdint>

namespace tp {

struct Rgb {
    uint8_t r, g, b;
};

/// Greys are neutral, for colours are judged beside them. One accent, amber as tea: selection, the
/// active tool and progress only.
struct Palette {
    Rgb window;         // behind the panels, title bars
    Rgb panel;          // of a panel
    Rgb field;          // what can be edited or pressed
    Rgb hover, active;  // the same under the pointer, and held
    Rgb line;           // between groups
    Rgb text, dim;      // what is read first, and second
    Rgb accent;         // of marks and frames
    Rgb accent_text;    // the accent where it is text
    Rgb selected;       // behind a selected row
    Rgb warning, error;
    Rgb axis[3];  // x, y, z
    Rgb graph[4];
};

inline constexpr Palette kDarkPalette = {
    .window = {30, 30, 32},
    .panel = {40, 40, 43},
    .field = {54, 54, 58},
    .hover = {66, 66, 70},
    .active = {80, 80, 85},
    .line = {60, 60, 64},
    .text = {222, 222, 222},
    .dim = {166, 166, 168},
    .accent = {232, 163, 61},
    .accent_text = {240, 176, 84},
    .selected = {92, 71, 40},
    .warning = {240, 176, 84},
    .error = {255, 138, 120},
    .axis = {{226, 92, 92}, {122, 184, 76}, {86, 140, 232}},
    .graph = {{232, 163, 61}, {110, 168, 224}, {136, 196, 110}, {196, 140, 216}}};

inline constexpr Palette kLightPalette = {
    .window = {208, 208, 210},
    .panel = {230, 230, 232},
    .field = {247, 247, 248},
    .hover = {255, 255, 255},
    .active = {214, 214, 216},
    .line = {194, 194, 196},
    .text = {28, 28, 30},
    .dim = {84, 84, 88},
    .accent = {205, 130, 20},
    .accent_text = {122, 70, 0},
    .selected = {246, 208, 146},
    .warning = {122, 70, 0},
    .error = {168, 24, 12},
    .axis = {{196, 50, 50}, {70, 130, 30}, {40, 90, 190}},
    .graph = {{196, 118, 10}, {30, 104, 178}, {66, 130, 40}, {134, 68, 160}}};

/// Relative luminance and contrast ratio as WCAG 2.1 defines them.
inline double relative_luminance(Rgb c) {
    const auto linear = [](uint8_t code) {
        const double x = code / 255.0;
        return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(c.r) + 0.7152 * linear(c.g) + 0.0722 * linear(c.b);
}
inline double contrast_ratio(Rgb a, Rgb b) {
    const double x = relative_luminance(a), y = relative_luminance(b);
    return (std::fmax(x, y) + 0.05) / (std::fmin(x, y) + 0.05);
}

}  // namespace tp
