// The browser for files, drawn where the desktop has no dialog of its own. Works by keyboard:
// arrows and Enter in the list, Backspace for the folder above, Escape to give up; so Dear ImGui's
// own way with these keys is off in it.
#include "../theme.h"
#include "file_dialog.h"

#include <fmt/format.h>
#include <icons_font_awesome_6.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

namespace tp {
namespace {

namespace fs = std::filesystem;

void go_to(FileDialog& d, const fs::path& folder) {
    std::error_code ignored;
    fs::path target = fs::weakly_canonical(folder, ignored);
    if (target.empty()) target = folder;
    d.folder = target;
    d.path_text = target.string();
    if (!d.question.saves) d.name.clear();
    d.is_stale = true;
    d.cursor = -1;
}

void refresh(FileDialog& d) {
    if (d.path_text.empty()) go_to(d, d.folder);
    const FileFilter all;
    const FileFilter& filter = d.question.filters.empty() ? all : d.question.filters[d.filter];
    d.entries = list_folder(d.folder, filter, d.shows_hidden, d.error);
    sort_entries(d.entries, d.order, d.descending);
    d.is_stale = false;
}

void draw_path(FileDialog& d) {
    if (ImGui::Button(ICON_FA_ARROW_UP "##up")) go_to(d, d.folder.parent_path());
    ImGui::SetItemTooltip("The folder above (Backspace)");
    ImGui::SameLine();
    if (ImGui::Button(ICON_FA_HOUSE "##home")) go_to(d, typed_path("~", d.folder));
    ImGui::SetItemTooltip("Home");
    ImGui::SameLine();
    if (ImGui::Button(d.shows_hidden ? ICON_FA_EYE "##hidden" : ICON_FA_EYE_SLASH "##hidden")) {
        d.shows_hidden = !d.shows_hidden;
        d.is_stale = true;
    }
    ImGui::SetItemTooltip("Files that begin with a dot");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1);
    if (ImGui::InputText("##folder", &d.path_text,
                         ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_ElideLeft))
        go_to(d, typed_path(d.path_text, d.folder));
}

// What a click on the button or Enter does: into a folder, or done with a file.
bool accept(FileDialog& d, fs::path& chosen) {
    if (d.name.empty()) return false;
    fs::path file = typed_path(d.name, d.folder);
    std::error_code ignored;
    if (fs::is_directory(file, ignored)) {
        go_to(d, file);
        d.name.clear();
        return false;
    }
    if (!d.question.saves) {
        if (!fs::exists(file, ignored)) {
            d.error = fmt::format("There is no file {}", file.filename().string());
            return false;
        }
    } else {
        if (!file.has_extension()) file += d.question.extension;
        if (fs::exists(file, ignored) && !d.asks_to_replace) {
            d.asks_to_replace = true;
            return false;
        }
    }
    chosen = file;
    return true;
}

// Arrows, Enter and Backspace where no text is typed. True when a file is chosen.
bool keys(FileDialog& d, fs::path& chosen) {
    const int count = static_cast<int>(d.entries.size());
    const auto pressed = [](ImGuiKey key) { return ImGui::IsKeyPressed(key); };
    int step = 0;
    if (pressed(ImGuiKey_DownArrow)) step = 1;
    if (pressed(ImGuiKey_UpArrow)) step = -1;
    if (pressed(ImGuiKey_PageDown)) step = 10;
    if (pressed(ImGuiKey_PageUp)) step = -10;
    if (step != 0 && count > 0) {
        d.cursor = std::clamp(d.cursor + step, 0, count - 1);
        d.name = d.entries[static_cast<size_t>(d.cursor)].name;
        d.asks_to_replace = false;
    }
    if (ImGui::IsAnyItemActive()) return false;
    if (pressed(ImGuiKey_Backspace)) go_to(d, d.folder.parent_path());
    return (pressed(ImGuiKey_Enter) || pressed(ImGuiKey_KeypadEnter)) && accept(d, chosen);
}

bool draw_list(FileDialog& d, fs::path& chosen, float height) {
    bool done = false;
    const ImGuiTableFlags flags = ImGuiTableFlags_ScrollY | ImGuiTableFlags_Sortable |
                                  ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersOuter;
    if (!ImGui::BeginTable("files", 3, flags, ImVec2(0, height))) return false;
    const float font = ImGui::GetFontSize();
    ImGui::TableSetupScrollFreeze(0, 1);
    ImGui::TableSetupColumn("Name", ImGuiTableColumnFlags_WidthStretch);
    ImGui::TableSetupColumn("Size", ImGuiTableColumnFlags_WidthFixed, font * 5);
    ImGui::TableSetupColumn("Changed", ImGuiTableColumnFlags_WidthFixed, font * 9);
    ImGui::TableHeadersRow();
    if (ImGuiTableSortSpecs* specs = ImGui::TableGetSortSpecs();
        specs && specs->SpecsDirty && specs->SpecsCount > 0) {
        d.order = static_cast<FolderOrder>(specs->Specs[0].ColumnIndex);
        d.descending = specs->Specs[0].SortDirection == ImGuiSortDirection_Descending;
        sort_entries(d.entries, d.order, d.descending);
        specs->SpecsDirty = false;
    }
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(d.entries.size()));
    if (d.cursor >= 0) clipper.IncludeItemByIndex(d.cursor);
    const bool by_key =
        ImGui::IsKeyPressed(ImGuiKey_DownArrow) || ImGui::IsKeyPressed(ImGuiKey_UpArrow) ||
        ImGui::IsKeyPressed(ImGuiKey_PageDown) || ImGui::IsKeyPressed(ImGuiKey_PageUp);
    std::string opened;
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            const FolderEntry& entry = d.entries[static_cast<size_t>(i)];
            ImGui::TableNextRow();
            ImGui::TableNextColumn();
            const std::string label = fmt::format(
                "{}  {}##{}", entry.is_folder ? ICON_FA_FOLDER : ICON_FA_FILE, entry.name, i);
            const ImGuiSelectableFlags row = ImGuiSelectableFlags_SpanAllColumns |
                                             ImGuiSelectableFlags_AllowDoubleClick |
                                             ImGuiSelectableFlags_NoAutoClosePopups;
            if (ImGui::Selectable(label.c_str(), i == d.cursor, row)) {
                d.cursor = i;
                d.name = entry.name;
                d.asks_to_replace = false;
                if (ImGui::IsMouseDoubleClicked(0)) opened = entry.name;
            }
            if (by_key && i == d.cursor) ImGui::SetScrollHereY();
            ImGui::TableNextColumn();
            if (!entry.is_folder) ImGui::TextUnformatted(bytes_text(entry.bytes).c_str());
            ImGui::TableNextColumn();
            ImGui::TextDisabled("%s", time_text(entry.time).c_str());
        }
    ImGui::EndTable();
    if (!opened.empty()) {
        d.name = opened;
        done = accept(d, chosen);
    }
    return done;
}

// Name, kind of file and the buttons. True when the question is over.
bool draw_foot(FileDialog& d, fs::path& chosen) {
    bool done = false, over = false;
    const float font = ImGui::GetFontSize();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("Name");
    ImGui::SameLine(font * 4);
    ImGui::SetNextItemWidth(-font * 15);
    if (ImGui::InputText("##name", &d.name)) d.asks_to_replace = false;
    done |= ImGui::IsItemDeactivated() &&
            (ImGui::IsKeyPressed(ImGuiKey_Enter) || ImGui::IsKeyPressed(ImGuiKey_KeypadEnter));
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1);
    const auto& filters = d.question.filters;
    if (!filters.empty() && ImGui::BeginCombo("##filter", filters[d.filter].name.c_str())) {
        for (size_t i = 0; i < filters.size(); ++i)
            if (ImGui::Selectable(filters[i].label().c_str(), i == d.filter)) {
                d.filter = i;
                d.is_stale = true;
            }
        ImGui::EndCombo();
    }
    const std::string words =
        d.asks_to_replace ? fmt::format("{} is there already.", d.name) : d.error;
    ImGui::AlignTextToFramePadding();
    ImGui::TextColored(ImGui::GetStyleColorVec4(ImGuiCol_PlotHistogram), "%s", words.c_str());
    const std::string text = d.asks_to_replace ? "Replace" : d.question.accept;
    const float width = font * 6;
    ImGui::SameLine(ImGui::GetContentRegionMax().x - 2 * width - ImGui::GetStyle().ItemSpacing.x);
    ImGui::BeginDisabled(d.name.empty());
    done |= ImGui::Button((text + "###accept").c_str(), ImVec2(width, 0));
    ImGui::EndDisabled();
    ImGui::SameLine();
    over = ImGui::Button("Cancel", ImVec2(width, 0));
    if (done && accept(d, chosen)) over = true;
    return over;
}

}  // namespace

bool draw_file_browser(FileDialog& d, fs::path& chosen) {
    const std::string title = d.question.title + "###file browser";
    if (!d.was_opened) {
        ImGui::OpenPopup(title.c_str());
        d.was_opened = true;
    }
    if (d.is_stale) refresh(d);
    const float font = ImGui::GetFontSize();
    const ImVec2 screen = ImGui::GetMainViewport()->WorkSize;
    ImGui::SetNextWindowSize(
        ImVec2(std::min(font * 46, screen.x * 0.95f), std::min(font * 30, screen.y * 0.9f)),
        ImGuiCond_Appearing);
    ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Appearing,
                            ImVec2(0.5f, 0.5f));
    bool is_open = true;
    if (!ImGui::BeginPopupModal(title.c_str(), &is_open,
                                ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNavInputs))
        return true;
    bool over = !is_open;
    draw_path(d);
    const float foot = 2 * ImGui::GetFrameHeightWithSpacing() + ImGui::GetStyle().ItemSpacing.y;
    over |= draw_list(d, chosen, -foot);
    over |= draw_foot(d, chosen);
    over |= keys(d, chosen);
    over |= ImGui::IsKeyPressed(ImGuiKey_Escape) && !ImGui::IsAnyItemActive();
    if (over) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
    return over;
}

}  // namespace tp
