// The table of keys, from the action table and what the user made of it, in columns.
#include "../key_table.h"
#include "dialogs.h"

#include <imgui.h>

#include <algorithm>

namespace tp {
namespace {

constexpr size_t kMostColumns = 3;

struct Group {
    std::string name;
    std::vector<KeyRow> rows;
};

std::vector<Group> grouped(const std::vector<KeyRow>& rows) {
    std::vector<Group> groups;
    for (const KeyRow& row : rows) {
        if (groups.empty() || groups.back().name != row.group) groups.push_back({row.group, {}});
        groups.back().rows.push_back(row);
    }
    return groups;
}

using Column = std::vector<Group>;

// The groups in their order in as many columns as this height takes.
std::vector<Column> columns_of_height(const std::vector<Group>& groups, size_t height) {
    std::vector<Column> columns(1);
    size_t used = 0;
    for (const Group& g : groups) {
        const size_t lines = g.rows.size() + 2;
        if (used > 0 && used + lines > height) {
            columns.emplace_back();
            used = 0;
        }
        used += lines;
        columns.back().push_back(g);
    }
    return columns;
}

// The lowest columns that hold the groups, at most so many.
std::vector<Column> lowest_columns(const std::vector<Group>& groups, size_t most) {
    size_t height = 1;
    while (columns_of_height(groups, height).size() > most)
        ++height;
    return columns_of_height(groups, height);
}

void draw_group(const Group& group, float key_width) {
    ImGui::TextDisabled("%s", group.name.c_str());
    for (const KeyRow& row : group.rows) {
        const float start = ImGui::GetCursorPosX();
        ImGui::TextUnformatted(row.keys.c_str());
        ImGui::SetItemTooltip("%s", row.help.c_str());
        ImGui::SameLine();
        ImGui::SetCursorPosX(start + key_width);
        ImGui::TextUnformatted(row.label.c_str());
        ImGui::SetItemTooltip("%s", row.help.c_str());
    }
    ImGui::Dummy({0, ImGui::GetFontSize() * 0.5f});
}

void draw_columns(const std::vector<Column>& columns) {
    const float gap = ImGui::GetFontSize();
    ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {gap, 2});
    if (ImGui::BeginTable("keys", static_cast<int>(columns.size()),
                          ImGuiTableFlags_SizingFixedFit)) {
        ImGui::TableNextRow();
        for (const Column& column : columns) {
            ImGui::TableNextColumn();
            float key_width = 0;
            for (const Group& g : column)
                for (const KeyRow& row : g.rows)
                    key_width = std::max(key_width, ImGui::CalcTextSize(row.keys.c_str()).x);
            for (const Group& g : column)
                draw_group(g, key_width + gap);
        }
        ImGui::EndTable();
    }
    ImGui::PopStyleVar();
}

}  // namespace

void draw_keys_window(PanelContext& c) {
    if (!c.ui.dialogs.show_keys) return;
    // Never larger than the window; what does not fit is scrolled.
    const ImGuiViewport* main = ImGui::GetMainViewport();
    ImGui::SetNextWindowSizeConstraints({0, 0}, {main->WorkSize.x - 16, main->WorkSize.y - 16});
    ImGui::SetNextWindowPos(main->GetWorkCenter(), ImGuiCond_Appearing, {0.5f, 0.5f});
    if (ImGui::Begin("Keys", &c.ui.dialogs.show_keys,
                     ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoDocking |
                         ImGuiWindowFlags_HorizontalScrollbar | ImGuiWindowFlags_NoSavedSettings)) {
        const float column_width = 18 * ImGui::GetFontSize();
        const auto room = static_cast<size_t>(std::max(1.0f, main->WorkSize.x / column_width));
        draw_columns(lowest_columns(grouped(key_table(c.ui.keys)), std::min(room, kMostColumns)));
        ImGui::Separator();
        if (ImGui::Button("Change keys\xe2\x80\xa6")) c.ui.dialogs.show_settings = true;
        if (ImGui::IsWindowFocused() && ImGui::IsKeyPressed(ImGuiKey_Escape, false))
            c.ui.dialogs.show_keys = false;
    }
    ImGui::End();
}

}  // namespace tp
