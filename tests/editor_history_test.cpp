// Undo and redo over everything: a random walk of edits of every kind, back to the start and forth
// to the end; the bound of the history.
#include <teapath/editor/document.h>
#include <teapath/editor/scene_edits.h>
#include <teapath/scene/enum_tables.h>

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <functional>
#include <memory>
#include <random>

using namespace tp;

namespace {

using Random = std::mt19937_64;

double number(Random& random, double low = -4, double high = 4) {
    return std::uniform_real_distribution<double>(low, high)(random);
}
Double3 triple(Random& random, double low = -4, double high = 4) {
    return {number(random, low, high), number(random, low, high), number(random, low, high)};
}
size_t below(Random& random, size_t count) {
    return std::uniform_int_distribution<size_t>(0, count - 1)(random);
}
template <class Enum>
Enum any(Random& random) {
    return EnumTable<Enum>::rows[below(random, EnumTable<Enum>::rows.size())].value;
}
template <class T>
T* one_of(std::vector<T>& things, Random& random) {
    return things.empty() ? nullptr : &things[below(random, things.size())];
}

std::shared_ptr<const Image> picture(Random& random, int size = 4) {
    auto image = std::make_shared<Image>();
    image->width = image->height = size;
    image->channels = 3;
    image->bytes.assign(3 * static_cast<size_t>(size) * static_cast<size_t>(size),
                        static_cast<std::byte>(below(random, 256)));
    return image;
}

// One for each kind of thing that a user can change in a scene.
const std::vector<std::pair<const char*, std::function<void(Scene&, Random&)>>>& changes() {
    static const std::vector<std::pair<const char*, std::function<void(Scene&, Random&)>>> table = {
        {"name of the scene",
         [](Scene& s, Random& r) { s.name = fmt::format("scene {}", below(r, 9)); }},
        {"description",
         [](Scene& s, Random& r) { s.description = std::string(below(r, 99), 'x'); }},
        {"add an object",
         [](Scene& s, Random& r) {
             add_object(s, shape_kinds()[below(r, shape_kinds().size())], triple(r), 1);
         }},
        {"duplicate an object",
         [](Scene& s, Random& r) {
             if (const Object* o = one_of(s.objects.edit(), r)) duplicate_objects(s, {o->id});
         }},
        {"delete an object",
         [](Scene& s, Random& r) {
             if (const Object* o = one_of(s.objects.edit(), r)) delete_objects(s, {o->id});
         }},
        {"move an object",
         [](Scene& s, Random& r) {
             if (Object* o = one_of(s.objects.edit(), r)) o->transform.translation = triple(r);
         }},
        {"turn an object",
         [](Scene& s, Random& r) {
             if (Object* o = one_of(s.objects.edit(), r)) o->transform.rotation = triple(r, 0, 360);
         }},
        {"scale an object",
         [](Scene& s, Random& r) {
             if (Object* o = one_of(s.objects.edit(), r)) o->transform.scale = triple(r, 0.1, 3);
         }},
        {"shape of an object",
         [](Scene& s, Random& r) {
             if (Object* o = one_of(s.objects.edit(), r))
                 o->shape = shape_kinds()[below(r, shape_kinds().size())].shape;
         }},
        {"rename, hide, turn inside out",
         [](Scene& s, Random& r) {
             Object* o = one_of(s.objects.edit(), r);
             if (!o) return;
             o->name = fmt::format("thing {}", below(r, 1000));
             o->visible = below(r, 2) == 0;
             o->inside_out = below(r, 2) == 0;
         }},
        {"give an object a material",
         [](Scene& s, Random& r) {
             Object* o = one_of(s.objects.edit(), r);
             const Material* m = one_of(s.materials.edit(), r);
             if (o && m) o->material = m->id;
         }},
        {"add a material", [](Scene& s, Random& r) { add_material(s, any<MaterialKind>(r)); }},
        {"kind of a material",
         [](Scene& s, Random& r) {
             if (Material* m = one_of(s.materials.edit(), r)) m->kind = any<MaterialKind>(r);
         }},
        {"numbers of a material",
         [](Scene& s, Random& r) {
             Material* m = one_of(s.materials.edit(), r);
             if (!m) return;
             m->color.color = triple(r, 0, 1);
             m->fuzz = number(r, 0, 1);
             m->ior = number(r, 1, 2);
             m->strength = number(r, 0, 10);
             m->opacity = number(r, 0, 1);
         }},
        {"texture of a material",
         [](Scene& s, Random& r) {
             Material* m = one_of(s.materials.edit(), r);
             if (m) m->color.texture = add_texture(s, any<TextureKind>(r));
         }},
        {"image of a texture",
         [](Scene& s, Random& r) {
             Texture* t = one_of(s.textures.edit(), r);
             if (!t) return;
             t->kind = TextureKind::Image;
             t->file = {fmt::format("image_{}.png", below(r, 1000)), picture(r)};
         }},
        {"numbers of a texture",
         [](Scene& s, Random& r) {
             Texture* t = one_of(s.textures.edit(), r);
             if (!t) return;
             t->wrap = any<WrapMode>(r);
             t->filter = any<FilterMode>(r);
             t->frequency = number(r, 1, 20);
             t->cells = {number(r, 1, 9), number(r, 1, 9)};
             t->pattern = any<NoisePattern>(r);
             t->scale = triple(r, 1, 9);
             t->seed = static_cast<int>(below(r, 100));
         }},
        {"background",
         [](Scene& s, Random& r) {
             s.background.kind = any<BackgroundKind>(r);
             s.background.top = triple(r, 0, 1);
             s.background.strength = number(r, 0, 3);
             s.background.file = {fmt::format("sky_{}.hdr", below(r, 1000)), picture(r)};
         }},
        {"add a camera and look through it",
         [](Scene& s, Random& r) {
             Camera camera = active_camera(s);
             for (const Camera& c : s.cameras)
                 camera.id.value = std::max(camera.id.value, c.id.value);
             ++camera.id.value;
             camera.look_from = triple(r);
             s.cameras.push_back(camera);
             s.active_camera = camera.id;
         }},
        {"look through another camera",
         [](Scene& s, Random& r) { s.active_camera = one_of(s.cameras, r)->id; }},
        {"camera jump",
         [](Scene& s, Random& r) {
             const CameraId id = active_camera(s).id;
             find_camera(s, id)->look_from = triple(r);
         }},
        {"lens",
         [](Scene& s, Random& r) {
             Camera* c = one_of(s.cameras, r);
             c->aperture = number(r, 0, 1);
             c->vertical_fov = number(r, 10, 90);
         }},
        {"render settings",
         [](Scene& s, Random& r) {
             s.render.width = 1 + static_cast<int>(below(r, 4000));
             s.render.samples = 1 + static_cast<int>(below(r, 4000));
             s.render.path.max_depth = 1 + static_cast<int>(below(r, 60));
             s.render.path.seed = below(r, 99);
             s.render.path.sampler = any<SamplerKind>(r);
             s.render.path.integrator = any<IntegratorKind>(r);
         }},
        {"display",
         [](Scene& s, Random& r) {
             s.display.exposure = static_cast<float>(number(r));
             s.display.curve = any<ToneCurve>(r);
         }},
        {"generator",
         [](Scene& s, Random& r) {
             Generator g;
             for (const Generator& other : s.generators)
                 g.id.value = std::max(g.id.value, other.id.value);
             ++g.id.value;
             g.grid.columns = g.grid.rows = 1 + static_cast<int>(below(r, 3));
             s.generators.edit().push_back(g);
         }},
        {"generators become objects", [](Scene& s, Random&) { realize_generators(s); }},
    };
    return table;
}

// A random step: an edit, sometimes part of a drag.
void edit_at_random(Document& document, Random& random) {
    const auto& [label, change] = changes()[below(random, changes().size())];
    const bool drags = below(random, 4) == 0;
    document.edit(label, drags ? label : "",
                  [&, &change = change](Scene& s) { change(s, random); });
    if (below(random, 3) == 0) document.end_merge();
}

}  // namespace

TEST_CASE("history: a random walk leads back to the first scene, and forth to the last") {
    for (uint64_t seed = 0; seed < 20; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        Document document;
        const Scene first = document.scene();
        for (int step = 0; step < 200; ++step)
            edit_at_random(document, random);
        const Scene last = document.scene();
        const size_t steps = document.history().size();
        while (document.can_undo())
            document.undo();
        CHECK(document.scene() == first);
        CHECK(!document.is_modified());
        CHECK(document.history().size() == steps);
        while (document.can_redo())
            document.redo();
        CHECK(document.scene() == last);
        document.go_to(0);
        CHECK(document.scene() == first);
        document.go_to(steps - 1);
        CHECK(document.scene() == last);
    }
}

TEST_CASE("history: every step of a walk among edits, undos and redos is the scene of then") {
    Random random(7);
    Document document;
    std::vector<Scene> scenes = {document.scene()};  // what each step should be
    size_t at = 0;
    for (int step = 0; step < 600; ++step) {
        const size_t choice = below(random, 5);
        if (choice == 0 && at > 0) {
            document.undo();
            --at;
        } else if (choice == 1 && at + 1 < scenes.size()) {
            document.redo();
            ++at;
        } else if (scenes.size() < 250) {
            const size_t before = document.history_position();
            const auto& [label, change] = changes()[below(random, changes().size())];
            document.edit(label, "", [&, &change = change](Scene& s) { change(s, random); });
            if (document.history_position() != before) {
                scenes.resize(++at);
                scenes.push_back(document.scene());
            }
        }
        REQUIRE(document.history_position() == at);
        REQUIRE(document.scene() == scenes[at]);
        REQUIRE(document.is_modified() == (scenes[at] != scenes[0]));
    }
}

TEST_CASE("history: bounded in steps, and the way back to the start stays") {
    Random random(3);
    Document document;
    const Scene first = document.scene();
    for (int step = 0; step < 1500; ++step) {
        edit_at_random(document, random);
        if (document.scene().objects.size() > 40)
            document.edit("Clear", "", [](Scene& s) {
                s.objects.edit().clear();
                s.generators.edit().clear();
            });
    }
    CHECK(document.history().size() <= HistoryLimit{}.steps);
    while (document.can_undo())
        document.undo();
    CHECK(document.scene() == first);
}

TEST_CASE("history: bounded in memory, images counted once") {
    Random random(5);
    const size_t limit = size_t{8} << 20;
    Document document(HistoryLimit{1000, limit});
    // 3 MiB each, in the history alone once the next one is there.
    for (int step = 0; step < 20; ++step)
        document.edit("Sky", "", [&](Scene& s) {
            s.background.kind = BackgroundKind::Image;
            s.background.file = {fmt::format("{}.png", step), picture(random, 1024)};
        });
    CHECK(document.history_bytes() <= limit);
    CHECK(document.history().size() == 4);  // the first, two in 8 MiB, the present one
    // The same picture in many steps is one.
    for (int step = 0; step < 50; ++step)
        document.edit("Strength", "", [&](Scene& s) { s.background.strength = 1 + step; });
    CHECK(document.history().size() > 50);
    // Many objects count as well.
    document.edit("Grid", "", [](Scene& s) {
        Object o;
        for (uint32_t i = 1; i <= 20000; ++i) {
            o.id.value = 100 + i;
            s.objects.edit().push_back(o);
        }
    });
    for (int step = 0; step < 20; ++step)
        document.edit("Strength", "", [&](Scene& s) { s.background.strength = 100 + step; });
    CHECK(document.history_bytes() <= limit);
    CHECK(document.history().size() >= 3);
    CHECK(document.can_undo());
}

TEST_CASE("history: steps that went over the bound do not lose the camera") {
    Document document(HistoryLimit{5, size_t{1} << 30});
    const Scene first = document.scene();
    for (int step = 1; step <= 12; ++step) {
        document.edit("Jump", "", [&](Scene& s) { s.cameras[0].look_from = Double3(step + 9); });
        document.edit("Name", "", [&](Scene& s) { s.name = fmt::format("{}", step); });
    }
    while (document.can_undo())
        document.undo();
    CHECK(document.scene() == first);
}

TEST_CASE("history: undo of the lens leaves the camera where it has been flown") {
    Document document;
    document.edit("Aperture", "", [](Scene& s) { s.cameras[0].aperture = 0.5; });
    Camera camera = active_camera(document.scene());
    camera.look_from = {9, 9, 9};
    document.fly(camera);
    document.undo();
    CHECK(active_camera(document.scene()).aperture == 0);
    CHECK(active_camera(document.scene()).look_from == Double3(9, 9, 9));
    document.redo();
    CHECK(active_camera(document.scene()).aperture == 0.5);
    CHECK(active_camera(document.scene()).look_from == Double3(9, 9, 9));
}
