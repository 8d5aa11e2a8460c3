// The page of the settings on which every action gets its keys.
#pragma once

#include "../context.h"

namespace tp {

/// Draws the page: a click on a key waits for the new one, Esc leaves it as it is.
void draw_key_settings(PanelContext& c);

}  // namespace tp
