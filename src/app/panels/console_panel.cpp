// The log: levels, filter, search, copy. What is shown is found anew only where lines came, or
// where filter or levels changed.
#include "../theme.h"
#include "../widgets.h"
#include "panels.h"

#include <fmt/format.h>
#include <icons_font_awesome_6.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

namespace tp {
namespace {

constexpr size_t kMaxLines = 4096;

struct Level {
    LogLevel level;
    const char* name;
    const char* icon;
    const char* help;
};
constexpr Level kLevels[] = {
    {LogLevel::Debug, "debug", ICON_FA_BUG, "Details for finding mistakes"},
    {LogLevel::Info, "info", ICON_FA_CIRCLE_INFO, "What the program does"},
    {LogLevel::Warning, "warning", ICON_FA_TRIANGLE_EXCLAMATION, "What may be wrong"},
    {LogLevel::Error, "error", ICON_FA_CIRCLE_XMARK, "What went wrong"}};

ImVec4 color_of(LogLevel level) {
    switch (level) {
        case LogLevel::Error: return to_color(theme().error);
        case LogLevel::Warning: return to_color(theme().warning);
        case LogLevel::Debug: return to_color(theme().dim);
        case LogLevel::Info: break;
    }
    return to_color(theme().text);
}

std::string text_of(const LogLine& line) {
    return fmt::format("{}  {:7}  {}", line.time, kLevels[static_cast<size_t>(line.level)].name,
                       line.text);
}

// The lines that are shown, and what they were found with.
struct Shown {
    ImGuiTextFilter filter;
    std::string filter_text, search;
    std::array<bool, 4> levels{};
    uint64_t last = 0, cleared = 0;
    std::vector<const LogLine*> lines;
    std::vector<size_t> found;  // of the search, positions in `lines`
};

void take_new_lines(ConsoleState& console) {
    for (LogLine& line : log_lines_after(console.lines.empty() ? 0 : console.lines.back().serial))
        console.lines.push_back(std::move(line));
    while (console.lines.size() > kMaxLines)
        console.lines.pop_front();
}

void set_filter(ImGuiTextFilter& filter, const std::string& text) {
    const size_t length = text.copy(filter.InputBuf, sizeof filter.InputBuf - 1);
    filter.InputBuf[length] = 0;
    filter.Build();
}

void update(Shown& shown, const ConsoleState& console) {
    const uint64_t last = console.lines.empty() ? 0 : console.lines.back().serial;
    if (shown.last == last && shown.cleared == console.cleared && shown.levels == console.shows &&
        shown.filter_text == console.filter && shown.search == console.search)
        return;
    if (shown.filter_text != console.filter) set_filter(shown.filter, console.filter);
    shown.filter_text = console.filter;
    shown.search = console.search;
    shown.levels = console.shows;
    shown.last = last;
    shown.cleared = console.cleared;
    shown.lines.clear();
    shown.found.clear();
    std::string lower_search = console.search;
    std::transform(lower_search.begin(), lower_search.end(), lower_search.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    for (const LogLine& line : console.lines) {
        if (line.serial <= console.cleared || !console.shows[static_cast<size_t>(line.level)])
            continue;
        const std::string text = text_of(line);
        if (!shown.filter.PassFilter(text.c_str())) continue;
        if (!lower_search.empty() && contains_text(text, lower_search))
            shown.found.push_back(shown.lines.size());
        shown.lines.push_back(&line);
    }
}

void level_toggles(ConsoleState& console) {
    for (const Level& level : kLevels) {
        bool& is_on = console.shows[static_cast<size_t>(level.level)];
        ImGui::PushStyleColor(ImGuiCol_Text, is_on ? color_of(level.level) : to_color(theme().dim));
        ImGui::PushStyleColor(ImGuiCol_Button,
                              is_on ? to_color(theme().field) : ImVec4(0, 0, 0, 0));
        const std::string id = fmt::format("{}###{}", level.icon, level.name);
        if (ImGui::Button(id.c_str(), {ImGui::GetFrameHeight() * 1.2f, 0})) {
            is_on = !is_on;
            // Details are only written where somebody reads them.
            if (level.level == LogLevel::Debug)
                set_log_level(is_on ? LogLevel::Debug : LogLevel::Info);
        }
        ImGui::PopStyleColor(2);
        ui::tooltip(fmt::format("{}: {}", level.name, level.help).c_str());
        ImGui::SameLine(0, ui::px(2));
    }
}

// Goes to the next or the last line that was found; -1 to none, then 0 to the newest.
void step(ConsoleState& console, const Shown& shown, int direction) {
    if (shown.found.empty()) return;
    const auto serial = [&](size_t i) { return shown.lines[shown.found[i]]->serial; };
    size_t at = shown.found.size() - 1;
    for (size_t i = 0; i < shown.found.size(); ++i)
        if (serial(i) == console.found)
            at = (i + shown.found.size() + static_cast<size_t>(direction)) % shown.found.size();
    console.found = serial(at);
}

// Returns true where the view is to jump to the line that the search is at.
bool search_field(ConsoleState& console, const Shown& shown, float width) {
    bool jumps = false;
    ImGui::SetNextItemWidth(std::max(1.0f, width));
    if (ImGui::InputTextWithHint(
            "##search", ICON_FA_MAGNIFYING_GLASS "  Search", &console.search,
            ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_EscapeClearsAll)) {
        step(console, shown, ImGui::GetIO().KeyShift ? 1 : -1);
        ImGui::SetKeyboardFocusHere(-1);
        jumps = true;
    }
    ui::tooltip("Enter goes to the line before, Shift+Enter to the next one");
    if (console.search.empty()) return jumps;
    ImGui::SameLine(0, ui::px(2));
    if (ui::icon_button(ICON_FA_CHEVRON_UP "##before", "The line before", !shown.found.empty()))
        step(console, shown, -1), jumps = true;
    ImGui::SameLine(0, 0);
    if (ui::icon_button(ICON_FA_CHEVRON_DOWN "##after", "The next line", !shown.found.empty()))
        step(console, shown, 1), jumps = true;
    return jumps;
}

void copy_lines(const Shown& shown) {
    std::string text;
    for (const LogLine* line : shown.lines)
        text += text_of(*line) + "\n";
    ImGui::SetClipboardText(text.c_str());
}

void draw_line(const LogLine& line, bool is_found, bool is_at) {
    const std::string text = text_of(line);
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 high{low.x + std::max(ImGui::GetContentRegionAvail().x, 1.0f),
                      low.y + ImGui::GetTextLineHeightWithSpacing()};
    if (is_at || is_found)
        ImGui::GetWindowDrawList()->AddRectFilled(
            low, high, ImGui::GetColorU32(to_color(theme().selected, is_at ? 1.0f : 0.4f)));
    ImGui::PushStyleColor(ImGuiCol_Text, color_of(line.level));
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopStyleColor();
    if (ImGui::BeginPopupContextItem(fmt::format("line {}", line.serial).c_str())) {
        if (ImGui::MenuItem("Copy line")) ImGui::SetClipboardText(text.c_str());
        ImGui::EndPopup();
    }
}

void draw_lines(ConsoleState& console, const Shown& shown, bool jumps) {
    if (!ImGui::BeginChild("lines", {0, 0}, ImGuiChildFlags_None,
                           ImGuiWindowFlags_HorizontalScrollbar)) {
        ImGui::EndChild();
        return;
    }
    ImGui::PushFont(monospaced_font(), 0);
    const bool was_at_end = ImGui::GetScrollY() >= ImGui::GetScrollMaxY();
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(shown.lines.size()));
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            const LogLine& line = *shown.lines[static_cast<size_t>(i)];
            const bool is_found =
                std::binary_search(shown.found.begin(), shown.found.end(), static_cast<size_t>(i));
            draw_line(line, is_found, is_found && line.serial == console.found);
        }
    ImGui::PopFont();
    if (jumps) {
        for (const size_t i : shown.found)
            if (shown.lines[i]->serial == console.found)
                ImGui::SetScrollFromPosY(ImGui::GetCursorStartPos().y - ImGui::GetScrollY() +
                                         static_cast<float>(i) *
                                             ImGui::GetTextLineHeightWithSpacing());
    } else if (was_at_end) {
        ImGui::SetScrollHereY(1);
    }
    ImGui::EndChild();
}

}  // namespace

void draw_console(PanelContext& c) {
    ConsoleState& console = c.ui.console;
    Shown& shown = c.ui.local.get<Shown>();
    take_new_lines(console);
    if (begin_panel(c, "Console")) {
        update(shown, console);
        level_toggles(console);
        ImGui::SameLine(0, ui::px(8));
        const float buttons =
            ImGui::GetFrameHeight() * (console.search.empty() ? 2.0f : 4.0f) + ui::px(24);
        const float space = std::max(2.0f, ImGui::GetContentRegionAvail().x - buttons);
        ImGui::SetNextItemWidth(space * 0.55f);
        ImGui::InputTextWithHint("##filter", ICON_FA_FILTER "  word, -without", &console.filter,
                                 ImGuiInputTextFlags_EscapeClearsAll);
        ui::tooltip("Shows lines with these words; a comma means or, a minus leaves lines out");
        ImGui::SameLine(0, ui::px(4));
        const bool jumps = search_field(console, shown, space * 0.45f);
        ImGui::SameLine(0, ui::px(4));
        if (ui::icon_button(ICON_FA_COPY "###copy", "Copies the lines that are shown"))
            copy_lines(shown);
        ImGui::SameLine(0, 0);
        if (ui::icon_button(ICON_FA_TRASH_CAN "###clear",
                            "Clears the panel; the log file keeps its lines") &&
            !console.lines.empty())
            console.cleared = console.lines.back().serial;
        update(shown, console);
        draw_lines(console, shown, jumps);
    }
    ImGui::End();
}

}  // namespace tp
