// The time line below the picture: play, scrub, loop, frames a second. Moving the time is no step
// of the history; the renderer's thread poses what moves.
#include "../widgets.h"
#include "viewport_parts.h"

#include <teapath/scene/pose.h>

#include <fmt/format.h>
#include <icons_font_awesome_6.h>

#include <algorithm>
#include <cmath>

namespace tp {
namespace {

double step_before(double seconds, double frames_per_second) {
    return std::floor(seconds * frames_per_second + 1e-6) / frames_per_second;
}

// From the end it begins anew.
void start_playing(PanelContext& c, double length) {
    TimelineState& t = c.ui.timeline;
    t.is_playing = true;
    t.position = c.document.scene().render.time;
    if (t.position >= step_before(length, static_cast<double>(t.frames_per_second))) t.position = 0;
}

void play_on(PanelContext& c, double length) {
    TimelineState& t = c.ui.timeline;
    t.position += static_cast<double>(ImGui::GetIO().DeltaTime);
    if (t.position >= length) {
        t.is_playing = t.loops;
        t.position = t.loops ? std::fmod(t.position, length) : length;
    }
    c.document.set_time(step_before(t.position, static_cast<double>(t.frames_per_second)));
}

void draw_play_button(PanelContext& c, double length) {
    TimelineState& t = c.ui.timeline;
    const char* label = t.is_playing ? ICON_FA_PAUSE "###play" : ICON_FA_PLAY "###play";
    if (ImGui::Button(label, ImVec2(ui::px(28), 0))) {
        if (t.is_playing)
            t.is_playing = false;
        else
            start_playing(c, length);
    }
    ImGui::SetItemTooltip(t.is_playing ? "Hold the animation" : "Play the animation");
}

void draw_scrubber(PanelContext& c, double length, float width) {
    TimelineState& t = c.ui.timeline;
    auto seconds = static_cast<float>(c.document.scene().render.time);
    const auto rate = static_cast<double>(t.frames_per_second);
    const std::string text = fmt::format("%.2f / {:.2f} s   frame {:.0f}", length,
                                         std::floor(static_cast<double>(seconds) * rate + 1e-4));
    ImGui::SetNextItemWidth(width);
    if (ImGui::SliderFloat("##time", &seconds, 0, static_cast<float>(length), text.c_str(),
                           ImGuiSliderFlags_AlwaysClamp)) {
        t.is_playing = false;
        c.document.set_time(
            std::clamp(std::round(static_cast<double>(seconds) * rate) / rate, 0.0, length));
    }
    if (ImGui::IsItemActive()) c.ui.viewport.is_moving = true;
    ImGui::SetItemTooltip("Time of the animation; Ctrl with a click to type it in seconds");
}

}  // namespace

float timeline_height(const PanelContext& c) {
    if (!(animation_length(c.document.scene()) > 0)) return 0;
    return ImGui::GetFrameHeight() + ui::px(8);
}

void draw_timeline(PanelContext& c) {
    TimelineState& t = c.ui.timeline;
    const double length = animation_length(c.document.scene());
    if (!(length > 0)) {
        t.is_playing = false;
        return;
    }
    if (t.is_playing) play_on(c, length);

    const float gap = ui::px(6), rate_width = ui::px(74), loop_width = ui::px(28);
    ImGui::SetCursorPos({ImGui::GetCursorPosX() + gap, ImGui::GetCursorPosY() + ui::px(4)});
    draw_play_button(c, length);
    ImGui::SameLine(0, gap);
    const float rest = ImGui::GetContentRegionAvail().x - rate_width - loop_width - 3 * gap;
    draw_scrubber(c, length, std::max(ui::px(40), rest));
    ImGui::SameLine(0, gap);
    ImGui::SetNextItemWidth(rate_width);
    ImGui::DragFloat("##rate", &t.frames_per_second, 0.25f, 1, 240, "%.4g fps",
                     ImGuiSliderFlags_AlwaysClamp);
    ImGui::SetItemTooltip("Frames a second");
    ImGui::SameLine(0, gap);
    const bool loops = t.loops;
    if (loops) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetColorU32(ImGuiCol_ButtonActive));
    if (ImGui::Button(ICON_FA_REPEAT "###loop", ImVec2(loop_width, 0))) t.loops = !loops;
    if (loops) ImGui::PopStyleColor();
    ImGui::SetItemTooltip(loops ? "It begins anew at its end" : "It stops at its end");
    c.ui.viewport.is_moving |= t.is_playing;
}

std::vector<Object> posed_copies(const PanelContext& c, const std::vector<const Object*>& objects) {
    std::vector<Object> copies;
    copies.reserve(objects.size());
    for (const Object* object : objects)
        copies.push_back(*object);
    if (!(animation_length(c.document.scene()) > 0)) return copies;
    PoseChanges changes(c.document.scene());
    for (Object& object : copies) {
        if (const auto change = changes.of(object); !change)
            object.visible = false;
        else if (*change != DoubleMat4(1))
            move_object(object, *change);
        const Object* shown = c.status.posed ? find(*c.status.posed, object.id) : nullptr;
        if (shown && shown->shape.index() == object.shape.index())
            if (const auto* mesh = std::get_if<MeshShape>(&shown->shape))
                if (auto& own = std::get<MeshShape>(object.shape); own.file == mesh->file)
                    own.file.mesh = mesh->file.mesh;
    }
    return copies;
}

}  // namespace tp
