// Figures of the render and of the interface.
#include "../widgets.h"
#include "panels.h"

#include <fmt/format.h>
#include <imgui.h>
#include <implot.h>

#include <algorithm>

namespace tp {
namespace {

void draw_frame_graph(const MetricsState& metrics) {
    const int count = static_cast<int>(std::min(metrics.frames, MetricsState::kFrames));
    const int offset = metrics.frames > MetricsState::kFrames
                           ? static_cast<int>(metrics.frames % MetricsState::kFrames)
                           : 0;
    ImPlot::PushStyleColor(ImPlotCol_FrameBg, ImVec4(0, 0, 0, 0));
    if (ImPlot::BeginPlot("##frames", ImVec2(-1, 96),
                          ImPlotFlags_NoMouseText | ImPlotFlags_NoInputs | ImPlotFlags_NoMenus)) {
        ImPlot::SetupAxes(nullptr, "ms", ImPlotAxisFlags_NoTickLabels | ImPlotAxisFlags_NoGridLines,
                          ImPlotAxisFlags_None);
        ImPlot::SetupAxesLimits(0, 240, 0, 40, ImPlotCond_Always);
        ImPlot::SetupLegend(ImPlotLocation_NorthEast, ImPlotLegendFlags_Horizontal);
        ImPlotSpec spec;
        spec.Offset = offset;
        ImPlot::PlotLine("interface", metrics.interface_ms.data(), count, 1, 0, spec);
        ImPlot::PlotLine("trace", metrics.trace_ms.data(), count, 1, 0, spec);
        ImPlot::EndPlot();
    }
    ImPlot::PopStyleColor();
}

std::string time_left(const PanelContext& c) {
    const double left = static_cast<double>(c.document.scene().render.samples - c.status.samples) *
                        c.status.width * c.status.height;
    if (c.status.is_done) return "done";
    if (c.status.samples_per_second <= 0) return "";
    const auto seconds = static_cast<int64_t>(left / c.status.samples_per_second);
    return fmt::format("{}:{:02}", seconds / 60, seconds % 60);
}

}  // namespace

void draw_metrics(PanelContext& c) {
    if (begin_panel(c, "Metrics")) {
        const RenderStatus& s = c.status;
        const float frame_ms = ImGui::GetIO().DeltaTime * 1e3f;
        draw_frame_graph(c.ui.metrics);
        const std::vector<std::pair<const char*, std::string>> lines = {
            {"Frames", fmt::format("{:.0f} fps, {:.1f} ms", ImGui::GetIO().Framerate, frame_ms)},
            {"Trace", fmt::format("{:.1f} ms a step", s.step_ms)},
            {"Display", fmt::format("{:.1f} ms tone curve, {:.1f} ms to the texture", s.display_ms,
                                    c.ui.metrics.show_ms)},
            {"Last change", fmt::format("{:.1f} ms", s.sync_ms)},
            {"Samples", fmt::format("{} of {}, {:.1f} M a second", s.samples,
                                    c.document.scene().render.samples, s.samples_per_second / 1e6)},
            {"Time left", time_left(c)},
            {"Picture", fmt::format("{} x {}", s.width, s.height)},
            {"Memory", fmt::format("{:.1f} MiB of scene and film",
                                   static_cast<double>(s.memory_bytes) / 1048576)},
            {"Scene", fmt::format("{} hittables, {} lights, tree of {} levels, cost {:.1f}",
                                  s.hittables, s.lights, s.bvh.depth, s.bvh.sah_cost)},
            {"Renderer", s.backend},
            {"Window", c.window.gl_name()},
            {"Build", TEAPATH_BUILD_TYPE}};
        if (ui::begin_rows("metrics")) {
            for (const auto& [name, text] : lines)
                ui::row_text(name, text);
            if (s.invalid_samples > 0)
                ui::row_text("Left out",
                             fmt::format("{} samples that were not finite", s.invalid_samples));
            ui::end_rows();
        }
        if (ImGui::Button("Copy as text")) {
            std::string text;
            for (const auto& [name, value] : lines)
                text += fmt::format("{}: {}\n", name, value);
            ImGui::SetClipboardText(text.c_str());
        }
    }
    ImGui::End();
}

}  // namespace tp
