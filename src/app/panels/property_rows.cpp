#include "property_rows.h"

#include <imgui.h>

namespace tp {
namespace {

struct LastRefusal {
    std::string last;
    double until = 0;  // that it is not said again, seconds of ImGui's clock
};

}  // namespace

void say_refusal(PanelContext& c, const std::string& why) {
    auto& [last, until] = c.ui.local.get<LastRefusal>();
    const double now = ImGui::GetTime();
    if (why != last || now > until) c.toast(why, true);
    last = why;
    until = now + 3;
}

}  // namespace tp
