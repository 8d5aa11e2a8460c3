// Inspector of textures, and the slots that hold them.
#include "../dialogs/dialogs.h"
#include "../preview/previews.h"
#include "inspector.h"

#include <teapath/scene/enum_tables.h>

#include <icons_font_awesome_6.h>

#include <algorithm>

namespace tp {
namespace {

std::string texture_name(const Scene& scene, TextureId id) {
    return item_name(scene, item_of(id));
}

void menu_of_textures(PanelContext& c, TexturedColor& value, TextureId not_this,
                      TexturedColorChange& change) {
    if (!ImGui::BeginPopup("textures")) return;
    const auto choose = [&](TextureId id) {
        change.texture |= value.texture != id;
        value.texture = id;
    };
    if (ImGui::MenuItem("No texture", nullptr, !value.texture)) choose({});
    const ScenePtr scene = c.document.snapshot();
    if (!scene->textures.empty()) ImGui::Separator();
    for (const Texture& t : scene->textures) {
        ImGui::PushID(static_cast<int>(t.id.value));
        if (t.id != not_this &&
            ImGui::MenuItem(texture_name(*scene, t.id).c_str(), nullptr, value.texture == t.id))
            choose(t.id);
        ImGui::PopID();
    }
    ImGui::Separator();
    if (ImGui::MenuItem(ICON_FA_CHESS_BOARD "  New checker"))
        change.new_texture = TextureKind::Checker;
    if (ImGui::MenuItem(ICON_FA_IMAGE "  New image")) change.new_texture = TextureKind::Image;
    if (ImGui::MenuItem(ICON_FA_DROPLET "  New constant"))
        change.new_texture = TextureKind::Constant;
    ImGui::EndPopup();
}

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
    const Texture standard;
    textured_color(
        rows, "Even", "Colour of the even cells", standard.even,
        [](auto& t) -> auto& { return t.even; }, rows.active().id);
    textured_color(
        rows, "Odd", "Colour of the odd cells", standard.odd,
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
        "Filter", "Between pixels", [](auto& t) -> auto& { return t.filter; });
    rows.choice(
        "Values are", "Automatic: sRGB for 8 and 16 bits, linear for float",
        [](auto& t) -> auto& { return t.color_space; });
    rows.number(
        {.name = "Repeat",
         .help = "Multiplies the texture coordinates",
         .speed = 0.01,
         .relative = true},
        [](auto& t) -> auto& { return t.repeat; });
}

// A small picture of the texture: cells and colours are drawn, an image is its thumbnail.
void draw_thumbnail(PanelContext& c, const Texture& t, float size) {
    const ImVec2 low = ImGui::GetCursorScreenPos(), high{low.x + size, low.y + size};
    const uint64_t picture =
        t.kind == TextureKind::Image && c.ui.previews ? c.ui.previews->image(t.file.image) : 0;
    if (picture) {
        ImGui::Image(static_cast<ImTextureID>(picture), {size, size});
        return;
    }
    ImGui::Dummy({size, size});
    ImDrawList* draw = ImGui::GetWindowDrawList();
    const auto fill = [&](ImVec2 a, ImVec2 b, const Double3& color) {
        draw->AddRectFilled(a, b, ImGui::GetColorU32(ui::swatch_color(color)));
    };
    if (t.kind == TextureKind::Constant) fill(low, high, t.color);
    if (t.kind == TextureKind::Image) fill(low, high, {0, 1, 1});  // as it is rendered
    if (t.kind != TextureKind::Checker) return;
    const float cell = size / 4;
    for (int i = 0; i < 16; ++i) {
        const ImVec2 a{low.x + cell * static_cast<float>(i % 4),
                       low.y + cell * static_cast<float>(i / 4)};
        fill(a, {a.x + cell, a.y + cell}, ((i + i / 4) % 2 == 0 ? t.even : t.odd).color);
    }
}

}  // namespace

TexturedColorChange row_textured_color(PanelContext& c, const char* name, const char* help,
                                       TexturedColor& value, const TexturedColor& standard,
                                       bool mixed, TextureId not_this) {
    TexturedColorChange change;
    const TexturedColor before = value;
    ui::begin_row(name, help, mixed || !(value == standard));
    ImGui::PushID(name);
    const float button = ImGui::GetFrameHeight() + ui::px(2);
    const float width = std::max(1.0f, ImGui::GetContentRegionAvail().x - button);
    const Texture* texture = find(c.document.scene(), value.texture);
    if (texture && !mixed) {
        draw_thumbnail(c, *texture, ImGui::GetFrameHeight());
        ImGui::SameLine(0, ui::px(4));
        const float space = std::max(1.0f, width - ImGui::GetFrameHeight() - ui::px(4));
        const std::string text =
            ui::fitted(texture_name(c.document.scene(), value.texture), space - ui::px(16));
        if (ImGui::Button((text + "###texture").c_str(), {space, 0}))
            c.document.select(item_of(value.texture));
        ui::tooltip("Shows the texture here");
    } else {
        change.color = ui::color_field(name, value.color, help, mixed, width);
        if (change.color) value.texture = {};
    }
    ImGui::SameLine(0, ui::px(2));
    if (ui::icon_button(ICON_FA_ELLIPSIS_VERTICAL "##slot", "A texture in place of the colour"))
        ImGui::OpenPopup("textures");
    menu_of_textures(c, value, not_this, change);
    ImGui::PopID();
    const ui::RowEnd end = ui::end_row(ui::color_text(value.color), true);
    if (end.paste && ui::take_color(*end.paste, value.color)) change.color = true;
    if (end.reset) value = standard;
    change.texture |= value.texture != before.texture;
    change.color |= value.color != before.color;
    return change;
}

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
        }
    }
    ui::end_rows();
}

}  // namespace tp
