// Everything of the action table, run from its menu and by each of its keys.
#include "actions.h"

#include "window_test.h"

#include <doctest/doctest.h>

#include <set>
#include <string>

using namespace tp;
using namespace tp::test;

namespace {

// Two edits, one of them taken back, and a selection: what most actions need to be enabled.
void make_ready(WindowTest& t) {
    Document& document = t.app->document;
    document.edit("First", "", [](Scene& s) { s.name = "first"; });
    document.edit("Second", "", [](Scene& s) { s.name = "second"; });
    document.undo();
    document.selection.clear();
    document.select({2});
}

// Ends what an action has begun: menus, dialogs, pause, closing.
void end_action(WindowTest& t, ImGuiTestContext* ctx) {
    ctx->PopupCloseAll();
    t.app->ui.dialogs = {};
    ctx->Yield(2);
    t.between_frames(ctx, [&] {
        t.app->window.set_should_close(false);
        t.app->document.open(window_test_options().folder / "scene.json");
        if (t.app->ui.paused) t.context().set_paused(false);
    });
    t.app->ui.last_action = "";
}

void focus_picture(ImGuiTestContext* ctx) {
    ctx->WindowFocus("//Viewport");
    ctx->MouseMoveToPos(ctx->WindowInfo("//Viewport").RectFull.GetCenter());
    ctx->Yield(2);
}

}  // namespace

TEST_CASE("actions: each one is in its menu and runs from there") {
    WindowTest t;
    std::set<std::string> ran;
    t.run([&](ImGuiTestContext* ctx) {
        for (const Action& a : actions()) {
            if (!a.run || a.menu[0] == 0) continue;
            INFO(std::string(a.id));
            make_ready(t);
            ctx->Yield();
            const PanelContext context = t.context();
            const bool enabled = is_enabled(a, context);
            if (enabled) {
                t.click_menu(ctx, a);
                REQUIRE_FALSE(ctx->IsError());
                CHECK(std::string(t.app->ui.last_action) == std::string(a.id));
                ran.insert(a.id);
            }
            end_action(t, ctx);
        }
    });
    MESSAGE(ran.size() << " actions ran from menus");
    CHECK(ran.size() > 10);
}

TEST_CASE("actions: each key runs its action") {
    WindowTest t;
    int keys = 0;
    t.run([&](ImGuiTestContext* ctx) {
        for (const Action& a : actions()) {
            for (const int chord : t.app->ui.keys.chords(a.id)) {
                if (!a.run || chord == 0) continue;
                INFO(std::string(a.id), " by ", chord_name(chord));
                focus_picture(ctx);
                make_ready(t);
                ctx->Yield();
                if (is_enabled(a, t.context())) {
                    ctx->KeyPress(chord);
                    CHECK(std::string(t.app->ui.last_action) == std::string(a.id));
                    ++keys;
                }
                end_action(t, ctx);
            }
        }
    });
    MESSAGE(keys << " keys");
    CHECK(keys > 10);
}

TEST_CASE("actions: keys of the picture do nothing where another panel has the focus") {
    WindowTest t;
    t.run([&](ImGuiTestContext* ctx) {
        for (const Action& a : actions()) {
            if (a.scope != ActionScope::Viewport || !a.run) continue;
            for (const int chord : t.app->ui.keys.chords(a.id)) {
                if (chord == 0) continue;
                INFO(std::string(a.id), " by ", chord_name(chord));
                ctx->WindowFocus("//Options");
                make_ready(t);
                ctx->KeyPress(chord);
                CHECK(std::string(t.app->ui.last_action) != std::string(a.id));
                end_action(t, ctx);
            }
        }
    });
}

TEST_CASE("actions: a key that is held acts once") {
    WindowTest t;
    t.run([&](ImGuiTestContext* ctx) {
        focus_picture(ctx);
        const bool before = t.app->ui.paused;
        ctx->KeyDown(ImGuiKey_P);
        ctx->Yield(120);
        CHECK(t.app->ui.paused == !before);
        ctx->KeyUp(ImGuiKey_P);
        CHECK(t.app->ui.paused == !before);
    });
}
