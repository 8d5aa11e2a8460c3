// Inspector of textures.
#include "../dialogs/dialogs.h"
#include "inspector.h"
#include "texture_slots.h"

#include <teapath/scene/enum_tables.h>

#include <icons_font_awesome_6.h>

#include <algorithm>

namespace tp {
namespace {

PropertyRows<Texture> property_rows(PanelContext& c, const std::vector<SceneItem>& items) {
    std::vector<const Texture*> things;
    std::vector<TextureId> ids;
    for (const SceneItem item : items)
        if (const Texture* t = find(c.document.scene(), TextureId{item.id})) {
            things.push_back(t);
            ids.push_back(t->id);
        }
    Texture standard;
    standard.kind = things.back()->kind;
    const std::string what = ids.size() == 1 ? texture_name(c.document.scene(), ids[0])
                                             : fmt::format("{} textures", ids.size());
    return PropertyRows<Texture>(
        c, what, fmt::format("texture {}", ids.back().value), std::move(things),
        [ids](Scene& s, size_t i) { return find_texture(s, ids[i]); }, standard);
}

void checker_rows(PropertyRows<Texture>& rows) {
    slot(
        rows, {.name = "Even", .help = "Colour of the even cells"},
        [](auto& t) -> auto& { return t.even; }, rows.active().id);
    slot(
        rows, {.name = "Odd", .help = "Colour of the odd cells"},
        [](auto& t) -> auto& { return t.odd; }, rows.active().id);
    rows.choice(
        "Cells in", "Cells on the surface, or blocks of space",
        [](auto& t) -> auto& { return t.mode; });
    if (rows.active().mode == CheckerMode::Uv)
        rows.number(
            {.name = "Cells",
             .help = "Cells along u and v over the whole surface",
             .speed = 0.05,
             .decimals = 0},
            [](auto& t) -> auto& { return t.cells; });
    else
        rows.number(
            {.name = "Frequency",
             .help = "Radians for each scene unit; the books have 10",
             .speed = 0.02,
             .relative = true},
            [](auto& t) -> auto& { return t.frequency; });
}

void triplanar_rows(PropertyRows<Texture>& rows) {
    rows.choice(
        "Space", "Moves with the object or stays in the world; a unit of it is one image",
        [](auto& t) -> auto& { return t.space; });
    rows.number(
        {.name = "Sharpness",
         .help = "How suddenly one side gives way to the next",
         .speed = 0.01,
         .low = 0.1,
         .high = 64,
         .relative = true},
        [](auto& t) -> auto& { return t.sharpness; });
}

void image_rows(PropertyRows<Texture>& rows) {
    const Texture& active = rows.active();
    row_image(rows.context(), "File", "Opens another image", active.file, item_of(active.id));
    if (active.file.image)
        ui::row_text("Size", fmt::format("{} x {}, {} channels", active.file.image->width,
                                         active.file.image->height, active.file.image->channels));
    rows.choice(
        "Beyond", "What lies outside of the image's edges",
        [](auto& t) -> auto& { return t.wrap; });
    rows.choice(
        "Beyond in v", "The same above and below the image",
        [](auto& t) -> auto& { return t.wrap_v; });
    rows.choice(
        "Filter", "Between pixels", [](auto& t) -> auto& { return t.filter; });
    rows.choice(
        "Values are", "Automatic: sRGB for 8 and 16 bits, linear for float",
        [](auto& t) -> auto& { return t.color_space; });
    rows.choice(
        "Projection", "By texture coordinates, or from three sides at once, which needs none",
        [](auto& t) -> auto& { return t.projection; });
    if (rows.active().projection == TextureProjection::Triplanar) triplanar_rows(rows);
    rows.number(
        {.name = "Repeat",
         .help = "Multiplies the texture coordinates",
         .speed = 0.01,
         .relative = true},
        [](auto& t) -> auto& { return t.repeat; });
    rows.number(
        {.name = "Rotation",
         .help = "Turns the texture coordinates after the repetition",
         .speed = 0.5,
         .decimals = 1,
         .unit = "\xc2\xb0"},
        [](auto& t) -> auto& { return t.uv_rotation; });
    rows.number(
        {.name = "Offset", .help = "Added to the texture coordinates last", .speed = 0.003},
        [](auto& t) -> auto& { return t.uv_offset; });
    rows.number(
        {.name = "UV set",
         .help = "Which texture coordinates of a mesh",
         .speed = 0.05,
         .low = 0,
         .high = kUvSets - 1},
        [](auto& t) -> auto& { return t.uv_set; });
    rows.color(
        "Tint", "Multiplies the colours of the image", [](auto& t) -> auto& { return t.tint; });
}

}  // namespace

void row_image(PanelContext& c, const char* name, const char* help, const ImageFile& file,
               SceneItem owner) {
    ui::begin_row(name, help);
    const float button =
        ImGui::CalcTextSize("Open\xe2\x80\xa6").x + ImGui::GetStyle().FramePadding.x * 2;
    const float space = std::max(1.0f, ImGui::GetContentRegionAvail().x - button - ui::px(8));
    ImGui::AlignTextToFramePadding();
    const std::string text = file.path.empty() ? "None"
                             : file.image      ? file.path
                                               : file.path + " (missing)";
    const float left = ImGui::GetCursorPosX();
    // The end of a path tells more than its beginning.
    const size_t slash = text.find_last_of('/');
    const std::string shown = slash == std::string::npos ? text : text.substr(slash + 1);
    ImGui::TextUnformatted(ui::fitted(shown, space).c_str());
    ui::tooltip(text.c_str());
    ImGui::SameLine();
    ImGui::SetCursorPosX(left + space + ui::px(8));
    if (ImGui::Button("Open\xe2\x80\xa6")) ask_for_image(c, owner, file.path);
    ui::tooltip("PNG, JPEG, TGA, BMP, HDR, EXR; a file may also be dropped here");
}

void texture_inspector(PanelContext& c, const std::vector<SceneItem>& items) {
    const ScenePtr scene = c.document.snapshot();
    PropertyRows<Texture> rows = property_rows(c, items);
    const float size = ImGui::GetFrameHeight() * 3;
    draw_thumbnail(c, rows.active(), size);
    ImGui::SameLine();
    ImGui::BeginGroup();
    inspector_header(c, items, ICON_FA_IMAGE, "Texture");
    ImGui::EndGroup();
    if (!ui::begin_rows("texture")) return;
    rows.choice(
        "Kind", "What the texture is", [](auto& t) -> auto& { return t.kind; });
    if (rows.is_same([](auto& t) -> auto& { return t.kind; })) {
        switch (rows.active().kind) {
            case TextureKind::Constant:
                rows.color(
                    "Colour", "Everywhere the same", [](auto& t) -> auto& { return t.color; });
                break;
            case TextureKind::Checker: checker_rows(rows); break;
            case TextureKind::Image: image_rows(rows); break;
            case TextureKind::Noise:
            case TextureKind::Marble:
            case TextureKind::Wood:
            case TextureKind::Brick: pattern_rows(rows); break;
        }
    }
    ui::end_rows();
}

}  // namespace tp
