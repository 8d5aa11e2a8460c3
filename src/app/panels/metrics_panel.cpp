// Figures of the render and of the interface.
#include "../figures.h"
#include "../gpu_sensor.h"
#include "../theme.h"
#include "../widgets.h"
#include "panels.h"
#include "render_figures.h"

#include <teapath/device/devices.h>

#include <fmt/format.h>
#include <icons_font_awesome_6.h>
#include <imgui.h>
#include <implot.h>

#include <algorithm>
#include <optional>

namespace tp {
namespace {

using Ring = std::array<float, MetricsState::kFrames>;

// A name and what is said of it, in the groups of the table.
struct Figure {
    const char* name;
    std::string text;
    bool starts_group = false;
};

std::span<const float> taken(const MetricsState& metrics, const Ring& ring) {
    return {ring.data(), std::min(metrics.frames, MetricsState::kFrames)};
}

// What the graph shows, in the theme's colours of lines.
struct Line {
    const char* name;
    const Ring* ring;
};
std::array<Line, 4> lines_of(const MetricsState& m) {
    return {{{"trace", &m.trace_ms},
             {"display", &m.display_ms},
             {"screen", &m.show_ms_of_frame},
             {"interface", &m.interface_ms}}};
}

// A round limit above the slowest frames, with room; it moves in steps, not with each frame. A step
// of the host may take many frames: it leaves the graph at the top.
double graph_limit(const MetricsState& metrics) {
    const double most = static_cast<double>(quantile(taken(metrics, metrics.frame_ms), 0.98));
    for (const double limit : {20.0, 40.0, 80.0, 160.0, 400.0, 1000.0})
        if (most * 1.15 < limit) return limit;
    return most * 1.2;
}

void draw_frame_graph(const MetricsState& metrics, float height) {
    const int count = static_cast<int>(std::min(metrics.frames, MetricsState::kFrames));
    const int offset = metrics.frames > MetricsState::kFrames
                           ? static_cast<int>(metrics.frames % MetricsState::kFrames)
                           : 0;
    ImPlot::PushStyleColor(ImPlotCol_FrameBg, ImVec4(0, 0, 0, 0));
    ImPlot::PushStyleColor(ImPlotCol_PlotBg, to_color(theme().window));
    ImPlot::PushStyleColor(ImPlotCol_PlotBorder, to_color(theme().line));
    ImPlot::PushStyleColor(ImPlotCol_AxisGrid, to_color(theme().line));
    ImPlot::PushStyleVar(ImPlotStyleVar_PlotPadding, ImVec2(4, 8));
    if (ImPlot::BeginPlot("##frames", ImVec2(-1, height),
                          ImPlotFlags_NoMouseText | ImPlotFlags_NoInputs | ImPlotFlags_NoMenus |
                              ImPlotFlags_NoLegend)) {
        ImPlot::SetupAxes(nullptr, nullptr,
                          ImPlotAxisFlags_NoTickLabels | ImPlotAxisFlags_NoGridLines |
                              ImPlotAxisFlags_NoTickMarks,
                          ImPlotAxisFlags_NoTickMarks);
        ImPlot::SetupAxisFormat(ImAxis_Y1, "%g ms");
        ImPlot::SetupAxesLimits(0, MetricsState::kFrames, 0, graph_limit(metrics),
                                ImPlotCond_Always);
        ImPlotSpec spec;
        spec.Offset = offset;
        spec.LineWeight = 1.5f;
        const auto lines = lines_of(metrics);
        for (size_t i = 0; i < lines.size(); ++i) {
            spec.LineColor = to_color(theme().graph[i]);
            ImPlot::PlotLine(lines[i].name, lines[i].ring->data(), count, 1, 0, spec);
        }
        ImPlot::EndPlot();
    }
    ImPlot::PopStyleVar();
    ImPlot::PopStyleColor(4);
}

// Below the graph: names with the colours of their lines, as many as there is room for.
void draw_legend(const MetricsState& metrics, float width) {
    const float size = std::floor(ImGui::GetFontSize() * 0.6f), start = ImGui::GetCursorPosX();
    const auto lines = lines_of(metrics);
    for (size_t i = 0; i < lines.size(); ++i) {
        const float needed = size + ui::px(4) + ImGui::CalcTextSize(lines[i].name).x;
        if (ImGui::GetCursorPosX() - start + needed > width) break;
        const ImVec2 low = ImGui::GetCursorScreenPos();
        const float y = low.y + std::floor((ImGui::GetFrameHeight() - size) / 2);
        ImGui::GetWindowDrawList()->AddRectFilled({low.x, y}, {low.x + size, y + size},
                                                  ImGui::GetColorU32(to_color(theme().graph[i])),
                                                  2);
        ImGui::SetCursorPosX(ImGui::GetCursorPosX() + size + ui::px(4));
        ImGui::AlignTextToFramePadding();
        ImGui::TextDisabled("%s", lines[i].name);
        ImGui::SameLine(0, ui::px(12));
    }
}

// The card that renders, if one does.
const DeviceInfo* rendering_card(const PanelContext& c) {
    static const DeviceList list = cuda_devices();
    if (c.status.backend.starts_with("host") || c.status.backend.empty()) return nullptr;
    for (const DeviceInfo& device : list.devices)
        if (device.index == c.ui.session.device) return &device;
    return nullptr;
}

std::string card_text(const PanelContext& c) {
    const DeviceInfo* card = rendering_card(c);
    if (!card) return "none in use";
    std::optional<GpuSensor>& sensor = c.ui.local.get<std::optional<GpuSensor>>();
    if (!sensor) sensor.emplace(card->uuid, card->index);
    std::string text = card->name;
    const std::optional<GpuReading> reading = sensor->reading();
    if (!reading) return text;
    text += fmt::format(
        ", {} \xc2\xb0"
        "C",
        reading->temperature);
    if (reading->power > 0) text += fmt::format(", {:.0f} W", reading->power);
    if (reading->busy_percent >= 0) text += fmt::format(", {}% busy", reading->busy_percent);
    return text;
}

struct ShownFigures {
    std::vector<Figure> figures;
    double next = 0;  // when they are taken anew, seconds of ImGui's clock
};

std::vector<Figure> figures_of(const PanelContext& c) {
    const RenderStatus& s = c.status;
    const MetricsState& m = c.ui.metrics;
    const auto frames = taken(m, m.frame_ms), interface = taken(m, m.interface_ms);
    const float median = quantile(frames, 0.5), worst = quantile(frames, 0.99);
    std::vector<Figure> figures = {
        {"Frames", fmt::format("{:.0f} fps, {:.1f} ms (99%: {:.1f})",
                               static_cast<double>(ImGui::GetIO().Framerate),
                               static_cast<double>(median), static_cast<double>(worst))},
        {"Interface",
         fmt::format("{:.1f} ms (99%: {:.1f})", static_cast<double>(quantile(interface, 0.5)),
                     static_cast<double>(quantile(interface, 0.99)))},
        {"Trace", fmt::format("{:.1f} ms a step", s.step_ms)},
        {"Display", fmt::format("{:.1f} ms tone curve", s.display_ms)},
        {"To the screen", fmt::format("{:.1f} ms", m.show_ms)},
        {"Last change", fmt::format("{:.1f} ms", s.sync_ms)},
        {"Samples", fmt::format("{} of {}", s.samples, c.document.scene().render.samples), true},
        {"Rate", count_text(s.samples_per_second) + "samples/s"},
        {"Rays", count_text(s.rays_per_second) + "rays/s"},
        {"Time left", time_left_text(c)},
        {"Picture", fmt::format("{} \xc3\x97 {}", s.width, s.height)},
        {"Objects", fmt::format("{} hittables, {} lights", s.hittables, s.lights), true},
        {"Tree", fmt::format("{} levels, {} leaves, cost {:.1f}", s.bvh.depth, s.bvh.leaf_count,
                             s.bvh.sah_cost)},
        {"Tree built in", fmt::format("{:.1f} ms", s.bvh.build_seconds * 1e3)},
        {"Scene and film", memory_text(s.memory_bytes), true},
        {"Program", memory_text(process_memory())},
        {"Renderer", s.backend},
        {"Card", card_text(c)},
        {"Window", c.window.gl_name()},
        {"Build", TEAPATH_BUILD_TYPE}};
    if (s.invalid_samples > 0)
        figures.push_back(
            {"Left out", fmt::format("{} samples that were not finite", s.invalid_samples)});
    return figures;
}

std::string as_text(const std::vector<Figure>& figures) {
    std::string text;
    for (const Figure& f : figures)
        text += fmt::format("{}: {}\n", f.name, f.text);
    return text;
}

void draw_table(const std::vector<Figure>& figures) {
    if (!ImGui::BeginTable("figures", 2, ImGuiTableFlags_None)) return;
    ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthFixed, ImGui::GetFontSize() * 6.5f);
    ImGui::TableSetupColumn("text");
    for (const Figure& f : figures) {
        if (f.starts_group) {
            ImGui::TableNextRow(ImGuiTableRowFlags_None, ImGui::GetFontSize() * 0.4f);
            ImGui::TableNextColumn();
        }
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::TextDisabled("%s", f.name);
        ImGui::TableNextColumn();
        ui::fitted_text(f.text, ImGui::GetContentRegionAvail().x);
    }
    ImGui::EndTable();
}

}  // namespace

double share_done(const PanelContext& c) {
    const RenderSettings& render = c.document.scene().render;
    const double by_samples = static_cast<double>(c.status.samples) / std::max(1, render.samples);
    const double by_time = render.seconds > 0 ? c.status.seconds / render.seconds : 0;
    return std::clamp(std::max(by_samples, by_time), 0.0, 1.0);
}

std::string time_left_text(const PanelContext& c) {
    const RenderStatus& s = c.status;
    if (s.is_done) return "done";
    if (s.samples_per_second <= 0) return "";
    const double samples =
        static_cast<double>(c.document.scene().render.samples - s.samples) * s.width * s.height;
    double seconds = samples / s.samples_per_second;
    if (const double limit = c.document.scene().render.seconds; limit > 0)
        seconds = std::min(seconds, limit - s.seconds);
    return clock_time(seconds) + " left";
}

void draw_metrics(PanelContext& c) {
    if (begin_panel(c, "Metrics")) {
        // Figures that change with each frame cannot be read.
        auto& [figures, next] = c.ui.local.get<ShownFigures>();
        if (ImGui::GetTime() >= next || figures.empty()) {
            figures = figures_of(c);
            next = ImGui::GetTime() + 0.25;
        }
        const ImVec2 space = ImGui::GetContentRegionAvail();
        const float line = ImGui::GetFontSize();
        // Wide and low: the graph stands beside the table, else above it.
        const bool is_wide = space.x > 40 * line || (space.x > 28 * line && space.y < 14 * line);
        const float share = space.x > 48 * line ? 0.5f : 0.42f;  // of the graph beside the table
        const float height = is_wide ? std::max(4 * line, space.y - 2 * line - ui::px(4))
                                     : std::clamp(space.y * 0.35f, 5 * line, 14 * line);
        if (ImGui::BeginChild(
                "graph",
                {is_wide ? std::floor(space.x * share) : 0, is_wide ? 0 : height + 2 * line},
                ImGuiChildFlags_None, ImGuiWindowFlags_NoScrollbar)) {
            draw_frame_graph(c.ui.metrics, height);
            const float button = ImGui::GetFrameHeight(), width = ImGui::GetContentRegionAvail().x;
            const float left = ImGui::GetCursorPosX();
            draw_legend(c.ui.metrics, width - button - ui::px(8));
            ImGui::SetCursorPosX(left + width - button);
            if (ui::icon_button(ICON_FA_COPY "###Copy as text", "Copy as text"))
                ImGui::SetClipboardText(as_text(figures).c_str());
        }
        ImGui::EndChild();
        if (is_wide) ImGui::SameLine();
        if (ImGui::BeginChild("table")) draw_table(figures);
        ImGui::EndChild();
    }
    ImGui::End();
}

}  // namespace tp
