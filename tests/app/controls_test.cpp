// Every control of the options and of the inspector, at its limits and beyond: the scene stays one
// that can be saved and rendered, and undo leads back to the start.
#include "window_test.h"

#include <teapath/editor/scene_edits.h>
#include <teapath/io/scene_file.h>
#include <teapath/scene/enum_tables.h>
#include <teapath/scene/validate.h>

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

using namespace tp;
using namespace tp::test;

namespace {

// One object of each shape, one material of each kind, and textures.
Scene scene_of_everything() {
    Scene scene = small_scene();
    scene.objects.edit().resize(1);
    for (const ShapeKind& kind : shape_kinds()) {
        const auto x = static_cast<double>(scene.objects.size()) - 4;
        add_object(scene, kind, {x, 0.5, 0}, 0.6);
    }
    for (const auto& row : EnumTable<MaterialKind>::rows)
        add_material(scene, row.value);
    for (const auto& row : EnumTable<TextureKind>::rows)
        if (row.value != TextureKind::Image) add_texture(scene, row.value);
    return scene;
}

// What is wrong with the scene, for people; empty if all is well.
std::string problems_of(const Scene& scene) {
    std::string text;
    for (const Problem& problem : validate(scene))
        if (problem.fatal) text += fmt::format("{}: {}; ", problem.where, problem.what);
    if (!text.empty()) return text;
    try {
        const std::string saved = scene_text(scene);
        if (scene_text(parse_scene(saved, ".", "test")) != saved)
            text = "it is another once saved and read";
    } catch (const std::exception& error) {
        text = error.what();
    }
    return text;
}

bool is_number_or_text(const ImGuiTestItemInfo& item) {
    return (item.StatusFlags & ImGuiItemStatusFlags_Inputable) != 0;
}

bool is_disabled(const ImGuiTestItemInfo& item) {
    return (item.ItemFlags & ImGuiItemFlags_Disabled) != 0;
}

struct Exerciser {
    WindowTest& t;
    ImGuiTestContext* ctx;
    int controls = 0;
    std::map<ImGuiID, int> seen = {};  // what two selections have in common is tried twice at most

    void check(const std::string& what) {
        ctx->Yield();
        INFO(what);
        CHECK(problems_of(t.scene()) == "");
        // A backend that this machine has not is a message, and the host goes on.
        if (t.app->ui.used_session.backend != BackendKind::Cuda) CHECK(t.app->status.error == "");
    }

    // Types values at and beyond the limits into a field.
    void type_values(const ImGuiTestItemInfo& item, const std::string& name) {
        for (const char* value : {"-1e30", "1e30", "0", "nan", "%n%s"}) {
            if (!ctx->ItemExists(item.ID)) return;
            ctx->ItemInputValue(item.ID, value);
            check(fmt::format("{} = {}", name, value));
        }
    }

    // Every control of a window as it is now; those that an edit brings are for the next call.
    void exercise(const char* window) {
        ImGuiTestItemList items;
        ctx->GatherItems(&items, window, -1);
        for (const ImGuiTestItemInfo& item : items) {
            if (ctx->IsError()) return;
            if (item.ID == 0 || is_disabled(item) || !ctx->ItemExists(item.ID) ||
                ++seen[item.ID] > 2)
                continue;
            const std::string name = fmt::format("{}: {}", window, item.DebugLabel);
            if (is_number_or_text(item)) {
                type_values(item, name);
            } else if (item.StatusFlags & ImGuiItemStatusFlags_Checkable) {
                ctx->ItemClick(item.ID);
                check(name);
                if (ctx->ItemExists(item.ID)) ctx->ItemClick(item.ID);
                check(name);
            } else {
                press_or_choose_each(item, name);
            }
            ++controls;
        }
    }

    // A button, or every choice of a combo. A heading is left as it was.
    void press_or_choose_each(const ImGuiTestItemInfo& combo, const std::string& name) {
        const auto is_open = [&] { return ctx->UiContext->OpenPopupStack.Size > 0; };
        ctx->ItemClick(combo.ID);
        ctx->Yield();
        if (!is_open()) {
            if (combo.StatusFlags & ImGuiItemStatusFlags_Openable) ctx->ItemClick(combo.ID);
            return check(name);
        }
        ImGuiTestItemList choices;
        ctx->GatherItems(&choices, "//$FOCUSED", -1);
        ctx->PopupCloseAll();
        for (const ImGuiTestItemInfo& choice : choices) {
            if (ctx->IsError() || !ctx->ItemExists(combo.ID)) break;
            ctx->ItemClick(combo.ID);
            if (choice.ID != 0 && ctx->ItemExists(choice.ID)) ctx->ItemClick(choice.ID);
            ctx->PopupCloseAll();
            check(fmt::format("{}, {}", name, choice.DebugLabel));
        }
    }
};

// The scene with the camera of another, which undo leaves where it was flown to.
Scene with_camera_of(Scene scene, const Scene& other) {
    scene.cameras = other.cameras;
    return scene;
}

void undo_everything(WindowTest& t) {
    while (t.app->document.can_undo())
        t.app->document.undo();
}

}  // namespace

TEST_CASE("controls: the options at their limits, and back by undo") {
    WindowTest t;
    const Scene start = t.scene();
    t.run([&](ImGuiTestContext* ctx) {
        Exerciser e{t, ctx};
        e.exercise("//Options");
        MESSAGE(e.controls << " controls");
        CHECK(e.controls > 15);
    });
    CHECK(t.app->document.can_undo());
    undo_everything(t);
    CHECK(t.scene() == start);
}

TEST_CASE("controls: the inspector of every shape and material at its limits, and back by undo") {
    WindowTest t(scene_of_everything());
    const Scene start = t.scene();
    t.run([&](ImGuiTestContext* ctx) {
        Exerciser e{t, ctx};
        for (const Object& object : start.objects) {
            t.app->document.select(object.id);
            ctx->Yield(2);
            e.exercise("//Inspector");
        }
        for (const Material& material : start.materials) {
            t.app->document.select(item_of(material.id));
            ctx->Yield(2);
            e.exercise("//Inspector");
        }
        MESSAGE(e.controls << " controls");
        CHECK(e.controls > 50);
    });
    undo_everything(t);
    CHECK(t.scene() == with_camera_of(start, t.scene()));
}
