// A random user: clicks, drags, keys, typing, wheel, files dropped, sizes, minimising. It ends
// without a crash, an error of OpenGL or of the renderer, and undo leads back to the start. The
// seed is printed and makes the same steps again; `--steps` and `--seed` choose them.
#include "window_test.h"

#include <teapath/io/scene_file.h>
#include <teapath/scene/validate.h>

#include <GLFW/glfw3.h>
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cstdio>
#include <fstream>
#include <random>
#include <string>
#include <vector>

using namespace tp;
using namespace tp::test;

namespace {

constexpr int kSteps = 1500;

class RandomUser {
public:
    RandomUser(WindowTest& test, ImGuiTestContext* context, uint64_t seed)
        : t_(test), ctx_(context), random_(seed) {}

    // One thing that a user may do. Returns it in words.
    std::string step() {
        switch (pick(0, 19)) {
            case 0:
            case 1:
            case 2:
            case 3:
            case 4: return use_item();
            case 5:
            case 6: return click_anywhere();
            case 7:
            case 8: return drag_anywhere();
            case 9:
            case 10: return use_key();
            case 11:
            case 12: return fly();
            case 13: return turn_wheel();
            case 14: return type_text();
            case 15: return use_action();
            case 16: return drop_file();
            case 17: return resize();
            case 18: return minimise();
            default: return move_panel();
        }
    }

    // Scenes are dropped seldom, for one that opens ends the history; the others often.
    void set_files(std::vector<std::filesystem::path> scenes,
                   std::vector<std::filesystem::path> others) {
        scenes_ = std::move(scenes);
        others_ = std::move(others);
    }

private:
    int pick(int low, int high) { return std::uniform_int_distribution(low, high)(random_); }
    template <class T>
    const T& one_of(const std::vector<T>& list) {
        return list[static_cast<size_t>(pick(0, static_cast<int>(list.size()) - 1))];
    }
    ImVec2 somewhere() {
        const ImVec2 size = ImGui::GetMainViewport()->Size;
        return {static_cast<float>(pick(0, std::max(1, static_cast<int>(size.x)))),
                static_cast<float>(pick(0, std::max(1, static_cast<int>(size.y))))};
    }
    ImGuiKeyChord modifier() {
        const int which = pick(0, 9);
        return which == 0   ? ImGuiMod_Ctrl
               : which == 1 ? ImGuiMod_Shift
               : which == 2 ? ImGuiMod_Alt
                            : 0;
    }
    void with(ImGuiKeyChord modifiers, const std::function<void()>& work) {
        if (modifiers) ctx_->KeyDown(modifiers);
        work();
        if (modifiers) ctx_->KeyUp(modifiers);
    }

    std::vector<ImGuiTestItemInfo> items_in_sight() {
        std::vector<ImGuiID> windows;
        for (const ImGuiWindow* w : ImGui::GetCurrentContext()->Windows)
            if (w->Active && !w->Hidden && !w->SkipItems) windows.push_back(w->ID);
        std::vector<ImGuiTestItemInfo> found;
        if (windows.empty()) return found;
        ImGuiTestItemList items;
        ctx_->GatherItems(&items, one_of(windows), -1);
        for (const ImGuiTestItemInfo& item : items)
            if (item.RectClipped.GetWidth() >= 1 && item.RectClipped.GetHeight() >= 1)
                found.push_back(item);
        return found;
    }

    // A widget in sight: a click, a double click, or a value typed.
    std::string use_item() {
        std::vector<ImGuiTestItemInfo> items;
        for (int tries = 0; tries < 3 && items.empty(); ++tries)
            items = items_in_sight();
        if (items.empty()) return "no item in sight";
        const ImGuiTestItemInfo item = one_of(items);
        ctx_->MouseMoveToPos(item.RectClipped.GetCenter());
        if (item.StatusFlags & ImGuiItemStatusFlags_Inputable && pick(0, 2) == 0) {
            with(ImGuiMod_Ctrl, [&] { ctx_->MouseClick(0); });
            ctx_->KeyPress(ImGuiMod_Ctrl | ImGuiKey_A);
            ctx_->KeyChars(one_of(texts_).c_str());
            ctx_->KeyPress(pick(0, 4) ? ImGuiKey_Enter : ImGuiKey_Escape);
            return fmt::format("a value for {}", item.DebugLabel);
        }
        if (pick(0, 5) == 0)
            ctx_->MouseDoubleClick(0);
        else
            with(modifier(), [&] { ctx_->MouseClick(pick(0, 7) ? 0 : 1); });
        return fmt::format("click on {}", item.DebugLabel);
    }

    std::string click_anywhere() {
        const ImVec2 at = somewhere();
        ctx_->MouseMoveToPos(at);
        with(modifier(), [&] { ctx_->MouseClick(pick(0, 2)); });
        return fmt::format("click at {} {}", at.x, at.y);
    }

    std::string drag_anywhere() {
        const ImVec2 from = somewhere(), to = somewhere();
        const int button = pick(0, 2);
        ctx_->MouseMoveToPos(from);
        with(modifier(), [&] {
            ctx_->MouseDown(button);
            for (int i = 1; i <= 4; ++i) {
                const float s = static_cast<float>(i) / 4;
                ctx_->MouseMoveToPos({from.x + (to.x - from.x) * s, from.y + (to.y - from.y) * s});
            }
            ctx_->MouseUp(button);
        });
        return fmt::format("drag {} from {} {} to {} {}", button, from.x, from.y, to.x, to.y);
    }

    std::string use_key() {
        std::vector<int> chords = {
            ImGuiKey_Escape,    ImGuiKey_Enter,     ImGuiKey_Tab,        ImGuiKey_UpArrow,
            ImGuiKey_DownArrow, ImGuiKey_LeftArrow, ImGuiKey_RightArrow, ImGuiMod_Alt | ImGuiKey_F4,
            ImGuiKey_Backspace};
        for (const Action& a : actions())
            for (const int chord : t_.app->ui.keys.chords(a.id))
                if (chord != 0) chords.push_back(chord);
        const int chord = one_of(chords);
        ctx_->KeyPress(chord);
        return "key " + chord_name(chord);
    }

    std::string fly() {
        const std::vector<ImGuiKey> keys = {ImGuiKey_W,         ImGuiKey_A,    ImGuiKey_S,
                                            ImGuiKey_D,         ImGuiKey_Q,    ImGuiKey_E,
                                            ImGuiKey_LeftShift, ImGuiKey_Space};
        const ImGuiKey first = one_of(keys), second = one_of(keys);
        ctx_->KeyDown(first);
        if (second != first) ctx_->KeyDown(second);
        ctx_->Yield(pick(1, 8));
        ctx_->KeyUp(first);
        if (second != first) ctx_->KeyUp(second);
        return "flight";
    }

    std::string turn_wheel() {
        ctx_->MouseMoveToPos(somewhere());
        with(modifier(), [&] { ctx_->MouseWheelY(static_cast<float>(pick(-4, 4))); });
        return "wheel";
    }

    std::string type_text() {
        ctx_->KeyChars(one_of(texts_).c_str());
        return "text";
    }

    std::string use_action() {
        std::vector<const char*> ids;
        for (const Action& a : actions())
            if (a.run) ids.push_back(a.id);
        const char* id = one_of(ids);
        if (std::string(id) == "file.new" && pick(0, 9))
            return "no new scene";  // it ends the history
        const Action& a = action(id);
        if (a.menu[0] == 0 || !is_enabled(a, t_.context())) return "a disabled action";
        ctx_->PopupCloseAll();
        const ImGuiTestItemInfo menu = ctx_->ItemInfo(
            fmt::format("//##MainMenuBar/##MenuBar/{}", a.menu).c_str(), ImGuiTestOpFlags_NoError);
        if (menu.ID == 0) return "no menu";
        ctx_->MouseMoveToPos(menu.RectFull.GetCenter());
        ctx_->MouseClick(0);
        ctx_->Yield(2);
        const ImGuiTestItemInfo item =
            ctx_->ItemInfo(fmt::format("//###Menu_00/###{}", id).c_str(), ImGuiTestOpFlags_NoError);
        if (item.ID == 0) return "a menu that did not open";
        ctx_->MouseMoveToPos(item.RectFull.GetCenter());
        ctx_->MouseClick(0);
        return fmt::format("menu {}", id);
    }

    std::string drop_file() {
        const std::filesystem::path file = one_of(pick(0, 9) ? others_ : scenes_);
        t_.between_frames(ctx_, [&] { t_.drop(file); });
        return "drop " + file.string();
    }

    std::string resize() {
        const int width = pick(0, 9) ? pick(300, 1500) : pick(0, 3);
        const int height = pick(0, 9) ? pick(200, 900) : pick(0, 3);
        t_.between_frames(ctx_, [&] { t_.resize(width, height); });
        ctx_->Yield(2);
        if (width < 300 || height < 200) t_.between_frames(ctx_, [&] { t_.resize(1280, 720); });
        return fmt::format("size {} x {}", width, height);
    }

    std::string minimise() {
        t_.between_frames(ctx_, [&] { glfwIconifyWindow(t_.glfw()); });
        ctx_->Yield(pick(1, 3));
        t_.between_frames(ctx_, [&] { glfwRestoreWindow(t_.glfw()); });
        return "minimise";
    }

    std::string move_panel() {
        std::vector<ImGuiWindow*> windows;
        for (ImGuiWindow* w : ImGui::GetCurrentContext()->Windows)
            if (w->Active &&
                (w->Flags & (ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove)) == 0 &&
                w->ParentWindow == nullptr)
                windows.push_back(w);
        if (windows.empty() || pick(0, 3) != 0) return click_anywhere();
        const ImRect title = one_of(windows)->TitleBarRect();
        const ImVec2 to = somewhere();
        ctx_->MouseMoveToPos({title.Min.x + 30, title.GetCenter().y});
        ctx_->MouseDown(0);
        ctx_->MouseMoveToPos({title.Min.x + 60, title.GetCenter().y + 40});
        ctx_->MouseMoveToPos(to);
        ctx_->Yield(2);
        ctx_->MouseUp(0);
        return "panel moved";
    }

    WindowTest& t_;
    ImGuiTestContext* ctx_;
    std::mt19937_64 random_;
    std::vector<std::filesystem::path> scenes_;
    std::vector<std::filesystem::path> others_;
    std::vector<std::string> texts_ = {"1",   "0",     "-1",        "0.5",
                                       "1e9", "-1e30", "abc",       "2*pi",
                                       "nan", "%s%n",  "wasdqepcf", "\xc3\xa4\xe2\x82\xac",
                                       "1/0", ""};
};

std::string problems_of(const Scene& scene) {
    std::string text;
    for (const Problem& problem : validate(scene))
        if (problem.fatal) text += fmt::format("{}: {}; ", problem.where, problem.what);
    return text;
}

}  // namespace

TEST_CASE("driver: a random user ends well, and undo leads back to the start") {
    const WindowTestOptions& options = window_test_options();
    const int steps = options.steps > 0 ? options.steps : kSteps;
    const uint64_t seed = options.seed;
    MESSAGE("seed " << seed << ", " << steps << " steps");
    WindowTest t;
    // What is saved by a relative name lands in the temporary folder.
    std::filesystem::current_path(options.folder);
    Scene small = small_scene();
    small.render.path.max_depth = 2;
    const std::filesystem::path broken = options.folder / "broken.json";
    std::ofstream(broken) << R"({"version": 1, "objects": 5})";
    const std::filesystem::path picture = options.folder / "corners.png",
                                model = options.folder / "tetrahedron.obj";
    std::filesystem::copy_file(shipped_scene("").parent_path() / "../assets/textures/corners.png",
                               picture);
    std::ofstream(model) << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
                            "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
    std::string last;
    int done = 0;
    t.run([&](ImGuiTestContext* ctx) {
        RandomUser user(t, ctx, seed);
        // Copies: what a user saves goes to the file that is open.
        const Scene box = load_scene(shipped_scene("cornell_box"));
        user.set_files({write_scene(small, "small.json"), write_scene(box, "box.json")},
                       {broken, picture, model});
        for (; done < steps && !ctx->IsError(); ++done) {
            last = user.step();
            INFO("seed ", seed, ", step ", done, ": ", last);
            REQUIRE(t.gl_errors == 0);
            REQUIRE(problems_of(t.scene()) == "");
            REQUIRE(t.app->status.error == "");
            t.app->window.set_should_close(false);
        }
        INFO("seed ", seed, ", step ", done, ": ", last);
        CHECK_FALSE(ctx->IsError());
    });
    CHECK(done == steps);
    Document& document = t.app->document;
    const Scene start = *document.history().front().scene;
    while (document.can_undo())
        document.undo();
    Scene end = document.scene();
    if (end.cameras.size() == start.cameras.size())
        end.cameras = start.cameras;  // where it was flown to
    CHECK(end == start);
}
