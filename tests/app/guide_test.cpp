// Pictures of the window in its states, to look at and for docs/guide; no check of its own, so it
// is left out unless it is asked for:
//   teapath_window_tests -tc="guide*" --no-skip --screenshots FOLDER [--size 1920x1080]
//                        [--scale 2] [--light] [--samples 64] [--model FILE] [--pictures a,b]
#include "dialogs/dialogs.h"
#include "layouts.h"
#include "window_test.h"

#include <teapath/core/log.h>
#include <teapath/io/scene_file.h>

#include <doctest/doctest.h>
#include <imgui_internal.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <thread>

using namespace tp;
using namespace tp::test;

namespace {

class Guide {
public:
    explicit Guide(const Scene& scene)
        : t_(scene, window_test_options().width, window_test_options().height) {
        Preferences& p = t_.app->ui.preferences;
        p.dark_theme = !window_test_options().is_light;
        p.interface_scale = window_test_options().scale;
        t_.app->ui.reset_layout = true;
        settle();
    }

    WindowTest& window() { return t_; }
    PanelContext context() { return t_.context(); }

    /// Waits for the picture, and saves that of the window.
    void save(const char* name) {
        if (!is_wanted(name)) return;
        settle();
        // The renderer has the newest scene by then.
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
        t_.frames_until(
            [&] {
                const ViewportState& v = t_.app->ui.viewport;
                return t_.app->status.is_done && t_.app->status.is_resting &&
                       !t_.app->status.is_preview && t_.app->texture.width() == v.width &&
                       t_.app->texture.height() == v.height && t_.app->previews.is_complete();
            },
            600);
        settle();
        t_.screenshot(name);
    }

    void act(const char* id) {
        PanelContext c = context();
        run_action(id, c);
        settle();
    }

    void select(const std::vector<std::string>& objects) {
        std::vector<SceneItem> items;
        for (const std::string& name : objects)
            for (const Object& o : t_.scene().objects)
                if (o.name == name) items.push_back(item_of(o.id));
        t_.app->document.select_items(items);
    }

    void select_material(const std::string& name) {
        for (const Material& m : t_.scene().materials)
            if (m.name == name) t_.app->document.select(item_of(m.id));
    }

    /// Toasts go, menus and lists are where they are after a while.
    void settle() {
        t_.frames(12);
        t_.app->ui.toasts.clear();
    }

private:
    static bool is_wanted(const std::string& name) {
        const std::string& list = window_test_options().pictures;
        return list.empty() || ("," + list + ",").find("," + name + ",") != std::string::npos;
    }

    WindowTest t_;
};

Scene showcase() {
    Scene scene = load_scene(shipped_scene("showcase"));
    scene.render.samples = window_test_options().samples;
    return scene;
}

void give_textured_surface(Document& document) {
    document.edit("Principled", "", [](Scene& s) {
        for (Material& m : s.materials.edit())
            if (m.name == "earth") {
                m.kind = MaterialKind::Principled;
                m.name = "varnished globe";
                m.roughness.value = 0.35;
            }
    });
}

}  // namespace

TEST_CASE("guide: pictures of the window" * doctest::skip()) {
    Guide guide(showcase());
    Document& document = guide.window().app->document;
    UiState& ui = guide.window().app->ui;
    guide.save("welcome");
    ui.preferences.seen_welcome = true;
    guide.save("start");

    guide.select({"gold"});
    guide.act("tool.move");
    guide.save("selected");
    guide.select({"gold", "jade", "dice"});
    guide.save("several");
    guide.act("tool.select");
    give_textured_surface(document);
    guide.select_material("varnished globe");
    guide.save("material");
    document.select_items({});

    log_warning("globe.png has 16 bits a channel; 8 are kept");
    log_line(
        LogLevel::Error,
        "a scene: /objects/3/material: there is no material \"glas\"; did you mean \"glass\"?");
    PanelContext c = guide.context();
    c.toast("Saved showcase.json");
    guide.save("console");
    choose_layout(c, "Inspect");
    guide.save("inspect");
    choose_layout(c, "Render");
    guide.save("render");
    choose_layout(c, "Edit");
    guide.settle();

    guide.act("edit.settings");
    guide.save("settings");
    ui.dialogs.show_settings = false;
    guide.act("file.export");
    guide.save("export");
    ui.dialogs.show_export = false;
    guide.act("help.keys");
    guide.save("keys");
    ui.dialogs.show_keys = false;
    ui.preferences.native_dialogs = false;
    guide.act("file.open");
    guide.save("open");
}

TEST_CASE("guide: a model" * doctest::skip()) {
    if (window_test_options().model.empty()) return;
    Guide guide(showcase());
    guide.window().app->ui.preferences.seen_welcome = true;
    PanelContext c = guide.context();
    const size_t before = c.document.scene().models.size();
    open_model(c, window_test_options().model);
    REQUIRE(guide.window().frames_until([&] { return c.document.scene().models.size() > before; }));
    guide.save("model");
    c.document.select_items({});
    for (const Object& object : c.document.scene().objects)
        if (object.part.model) c.document.select(object.id, true);
    guide.act("camera.frame_selection");
    guide.save("model_objects");
}
