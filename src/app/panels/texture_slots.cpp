#include "texture_slots.h"

#include "../preview/previews.h"
#include "../widget_number.h"

#include <teapath/editor/number_text.h>
#include <teapath/scene/enum_tables.h>

#include <icons_font_awesome_6.h>

#include <algorithm>

namespace tp {
namespace {

void channel_items(TextureChannel& channel, SlotChange& change) {
    ImGui::SeparatorText("Channel");
    for (const auto& row : EnumTable<TextureChannel>::rows)
        if (ImGui::MenuItem(std::string(row.label).c_str(), nullptr, channel == row.value)) {
            change.texture |= channel != row.value;
            channel = row.value;
        }
}

void menu_of_textures(PanelContext& c, TextureId& value, TextureId not_this, SlotChange& change,
                      TextureChannel* channel) {
    if (!ImGui::BeginPopup("textures")) return;
    const auto choose = [&](TextureId id) {
        change.texture |= value != id;
        value = id;
    };
    if (ImGui::MenuItem("No texture", nullptr, !value)) choose({});
    const ScenePtr scene = c.document.snapshot();
    if (!scene->textures.empty()) ImGui::Separator();
    for (const Texture& t : scene->textures) {
        ImGui::PushID(static_cast<int>(t.id.value));
        const bool fits = !not_this || (t.id != not_this && !holds(*scene, t.id, not_this));
        if (fits && ImGui::MenuItem(texture_name(*scene, t.id).c_str(), nullptr, value == t.id))
            choose(t.id);
        ImGui::PopID();
    }
    ImGui::Separator();
    for (const TextureKind kind :
         {TextureKind::Checker, TextureKind::Image, TextureKind::Noise, TextureKind::Marble,
          TextureKind::Wood, TextureKind::Brick, TextureKind::Constant})
        if (ImGui::MenuItem(fmt::format("{}  New {}", texture_icon(kind), enum_name(kind)).c_str()))
            change.new_texture = kind;
    if (value && channel) channel_items(*channel, change);
    ImGui::EndPopup();
}

// The button that opens the menu ends every row; what is left of it is the field's.
float field_width() {
    const float button = ImGui::GetFrameHeight() + ui::px(2);
    return std::max(1.0f, ImGui::GetContentRegionAvail().x - button);
}

void menu_button(PanelContext& c, TextureId& value, TextureId not_this, SlotChange& change,
                 TextureChannel* channel = nullptr) {
    ImGui::SameLine(0, ui::px(2));
    if (ui::icon_button(ICON_FA_ELLIPSIS_VERTICAL "##slot", "Chooses a texture"))
        ImGui::OpenPopup("textures");
    menu_of_textures(c, value, not_this, change, channel);
}

// A picture and the name, which shows the texture in the inspector.
void texture_button(PanelContext& c, const Texture& texture, float width) {
    draw_thumbnail(c, texture, ImGui::GetFrameHeight());
    ImGui::SameLine(0, ui::px(4));
    const float space = std::max(1.0f, width - ImGui::GetFrameHeight() - ui::px(4));
    const std::string text =
        ui::fitted(texture_name(c.document.scene(), texture.id), space - ui::px(16));
    if (ImGui::Button((text + "###texture").c_str(), {space, 0}))
        c.document.select(item_of(texture.id));
    ui::tooltip("Shows the texture here");
}

}  // namespace

std::string texture_name(const Scene& scene, TextureId id) {
    return item_name(scene, item_of(id));
}

const char* texture_icon(TextureKind kind) {
    switch (kind) {
        case TextureKind::Checker: return ICON_FA_CHESS_BOARD;
        case TextureKind::Image: return ICON_FA_IMAGE;
        case TextureKind::Noise: return ICON_FA_CLOUD;
        case TextureKind::Marble: return ICON_FA_WATER;
        case TextureKind::Wood: return ICON_FA_TREE;
        case TextureKind::Brick: return ICON_FA_BORDER_ALL;
        case TextureKind::Constant: break;
    }
    return ICON_FA_DROPLET;
}

void draw_thumbnail(PanelContext& c, const Texture& t, float size) {
    const ImVec2 low = ImGui::GetCursorScreenPos(), high{low.x + size, low.y + size};
    const uint64_t picture =
        c.ui.previews ? c.ui.previews->texture(c.document.scene(), t) : uint64_t{0};
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
    if (t.kind == TextureKind::Image) fill(low, high, {0, 1, 1});    // as it is rendered
    if (is_blend(t.kind)) fill(low, high, pair_of(t).first->color);  // until it is rendered
    if (t.kind != TextureKind::Checker) return;
    const float cell = size / 4;
    for (int i = 0; i < 16; ++i) {
        const ImVec2 a{low.x + cell * static_cast<float>(i % 4),
                       low.y + cell * static_cast<float>(i / 4)};
        fill(a, {a.x + cell, a.y + cell}, ((i + i / 4) % 2 == 0 ? t.even : t.odd).color);
    }
}

SlotChange row_slot(PanelContext& c, const ui::NumberRow& r, TexturedColor& value,
                    const TexturedColor& standard, bool mixed, TextureId not_this) {
    SlotChange change;
    const TexturedColor before = value;
    ui::begin_row(r.name, r.help, mixed || !(value == standard));
    ImGui::PushID(r.name);
    const Texture* texture = find(c.document.scene(), value.texture);
    if (texture && !mixed) {
        texture_button(c, *texture, field_width());
    } else {
        change.value = ui::color_field(r.name, value.color, r.help, mixed, field_width());
        if (change.value) value.texture = {};
    }
    menu_button(c, value.texture, not_this, change);
    ImGui::PopID();
    const ui::RowEnd end = ui::end_row(ui::color_text(value.color), true);
    if (end.paste && ui::take_color(*end.paste, value.color)) change.value = true;
    if (end.reset) value = standard;
    change.texture |= value.texture != before.texture;
    change.value |= value.color != before.color;
    return change;
}

SlotChange row_slot(PanelContext& c, const ui::NumberRow& r, TexturedNumber& value,
                    const TexturedNumber& standard, bool mixed, TextureId not_this) {
    SlotChange change;
    change.is_data = true;
    const TexturedNumber before = value;
    ui::begin_row(r.name, r.help, mixed || !(value == standard));
    ImGui::PushID(r.name);
    const Texture* texture = find(c.document.scene(), value.texture);
    const float width = field_width();
    const bool is_textured = texture && !mixed;
    if (is_textured) {
        texture_button(c, *texture, std::floor(width * 0.6f));
        ImGui::SameLine(0, ui::px(2));
    }
    ImGui::SetNextItemWidth(is_textured ? width - std::floor(width * 0.6f) - ui::px(2) : width);
    change.value = ui::number_field((std::string("##") + r.name).c_str(), r, value.value, mixed);
    ui::tooltip(is_textured ? "Multiplies what the texture says" : r.help);
    menu_button(c, value.texture, not_this, change, &value.channel);
    ImGui::PopID();
    const ui::RowEnd end = ui::end_row(exact_number(value.value), true);
    if (end.paste)
        if (const std::vector<double> numbers = numbers_of(*end.paste); numbers.size() == 1)
            value.value = std::clamp(numbers[0], r.low, r.high);
    if (end.reset) value = standard;
    change.texture |= value.texture != before.texture;
    change.value |= value.value != before.value;
    return change;
}

SlotChange row_slot(PanelContext& c, const ui::NumberRow& r, TextureId& value,
                    const TextureId& standard, bool mixed, TextureId not_this) {
    SlotChange change;
    change.is_data = true;
    const TextureId before = value;
    ui::begin_row(r.name, r.help, mixed || value != standard);
    ImGui::PushID(r.name);
    const Texture* texture = find(c.document.scene(), value);
    if (texture && !mixed) {
        texture_button(c, *texture, field_width());
    } else if (ImGui::Button(mixed ? "mixed###none" : "None###none", {field_width(), 0})) {
        ImGui::OpenPopup("textures");
    }
    menu_button(c, value, not_this, change);
    ImGui::PopID();
    if (ui::end_row({}, true).reset) value = standard;
    change.texture |= value != before;
    return change;
}

}  // namespace tp
