#include "property_rows.h"

#include <imgui.h>

namespace tp {

void say_refusal(PanelContext& c, const std::string& why) {
    static std::string last;
    static double until = 0;
    const double now = ImGui::GetTime();
    if (why != last || now > until) c.toast(why, true);
    last = why;
    until = now + 3;
}

}  // namespace tp
