// The log, filtered.
#include "../theme.h"
#include "../widgets.h"
#include "panels.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

namespace tp {
namespace {

ImVec4 color_of(LogLevel level) {
    switch (level) {
        case LogLevel::Error: return {1.0f, 0.5f, 0.45f, 1};
        case LogLevel::Warning: return {0.91f, 0.64f, 0.24f, 1};
        case LogLevel::Debug: return ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled);
        case LogLevel::Info: break;
    }
    return ImGui::GetStyleColorVec4(ImGuiCol_Text);
}

const char* name_of(LogLevel level) {
    switch (level) {
        case LogLevel::Error: return "error";
        case LogLevel::Warning: return "warning";
        case LogLevel::Debug: return "debug";
        case LogLevel::Info: break;
    }
    return "info";
}

std::string text_of(const LogLine& line) {
    return fmt::format("{}  {:7}  {}", line.time, name_of(line.level), line.text);
}

}  // namespace

void draw_console(PanelContext& c) {
    constexpr size_t kMaxLines = 4096;
    for (LogLine& line :
         log_lines_after(c.ui.console.lines.empty() ? 0 : c.ui.console.lines.back().serial))
        c.ui.console.lines.push_back(std::move(line));
    if (c.ui.console.lines.size() > kMaxLines)
        c.ui.console.lines.erase(c.ui.console.lines.begin(), c.ui.console.lines.end() - kMaxLines);

    if (begin_panel(c, "Console")) {
        static ImGuiTextFilter filter;
        ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - ImGui::GetFontSize() * 9);
        if (ImGui::InputTextWithHint("##filter", "Filter: word, -without, a,b",
                                     &c.ui.console.filter)) {
            c.ui.console.filter.copy(filter.InputBuf, sizeof filter.InputBuf - 1);
            filter.InputBuf[std::min(c.ui.console.filter.size(), sizeof filter.InputBuf - 1)] = 0;
            filter.Build();
        }
        ui::tooltip(
            "Words that a line must have; -word leaves lines out; a comma between means or");
        ImGui::SameLine();
        const bool copy = ImGui::Button("Copy");
        ImGui::SameLine();
        if (ImGui::Button("Clear") && !c.ui.console.lines.empty())
            c.ui.console.cleared = c.ui.console.lines.back().serial;

        std::vector<const LogLine*> shown;
        for (const LogLine& line : c.ui.console.lines)
            if (line.serial > c.ui.console.cleared && filter.PassFilter(text_of(line).c_str()))
                shown.push_back(&line);
        if (copy) {
            std::string text;
            for (const LogLine* line : shown)
                text += text_of(*line) + "\n";
            ImGui::SetClipboardText(text.c_str());
        }
        if (ImGui::BeginChild("lines", ImVec2(0, 0), ImGuiChildFlags_None,
                              ImGuiWindowFlags_HorizontalScrollbar)) {
            ImGui::PushFont(monospaced_font());
            ImGuiListClipper clipper;
            clipper.Begin(static_cast<int>(shown.size()));
            while (clipper.Step())
                for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
                    const LogLine& line = *shown[static_cast<size_t>(i)];
                    ImGui::TextColored(color_of(line.level), "%s", text_of(line).c_str());
                }
            ImGui::PopFont();
            if (ImGui::GetScrollY() >= ImGui::GetScrollMaxY()) ImGui::SetScrollHereY(1);
        }
        ImGui::EndChild();
    }
    ImGui::End();
}

}  // namespace tp
