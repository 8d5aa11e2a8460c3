// Property rows of things of the document: one or several at once, and every change is an edit of
// the document. A row shows the value of the active thing, says "mixed" where the others differ,
// and an edit goes to all of them; of vectors only the components that were edited. What the scene
// may not hold is refused, with the reason as a notice.
#pragma once

#include "../context.h"
#include "../widgets.h"

#include <teapath/editor/refusal.h>
#include <teapath/editor/scene_edits.h>
#include <teapath/scene/texture_uses.h>

#include <fmt/format.h>

#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace tp {

/// Says once why an edit is refused, however often a drag asks for it.
void say_refusal(PanelContext& c, const std::string& why);

// A value as numbers.
template <class Number>
requires std::is_arithmetic_v<Number>
constexpr int component_count(const Number&) {
    return 1;
}
constexpr int component_count(const Double2&) {
    return 2;
}
constexpr int component_count(const Double3&) {
    return 3;
}
constexpr int component_count(const Double4&) {
    return 4;
}
template <class Value>
double component(const Value& value, int i) {
    if constexpr (std::is_arithmetic_v<Value>)
        return i == 0 ? static_cast<double>(value) : 0;
    else
        return value[i];
}
template <class Value>
void set_component(Value& value, int i, double x) {
    if constexpr (std::is_arithmetic_v<Value>)
        value = static_cast<Value>(x);
    else
        value[i] = x;
}

template <class Thing>
class PropertyRows {
public:
    /// The i-th of the things in a scene that is being edited; null if it is gone.
    using Reach = std::function<Thing*(Scene&, size_t)>;

    /// `what` names the things for the history, `key` tells them from others for merging.
    /// `things` are those of the document's snapshot, the active one last, at least one.
    PropertyRows(PanelContext& c, std::string what, std::string key,
                 std::vector<const Thing*> things, Reach reach, Thing standard = {})
        : c_(c),
          what_(std::move(what)),
          key_(std::move(key)),
          snapshot_(c.document.snapshot()),
          things_(std::move(things)),
          reach_(std::move(reach)),
          standard_(std::move(standard)) {}

    const Thing& active() const { return *things_.back(); }
    const Thing& standard() const { return standard_; }
    size_t count() const { return things_.size(); }
    const std::vector<const Thing*>& things() const { return things_; }

    /// True if `get` gives the same for all.
    template <class Get>
    bool is_same(const Get& get) const {
        for (const Thing* thing : things_)
            if (!(get(*thing) == get(active()))) return false;
        return true;
    }

    /// Rows by kind of value. `get` gives the value of a thing by reference, const or not:
    /// [](auto& m) -> auto& { return m.fuzz; }
    template <class Get>
    void number(ui::NumberRow r, const Get& get) {
        using Value = std::remove_cvref_t<decltype(get(active()))>;
        r.whole = std::is_integral_v<Value>;
        r.single = std::is_same_v<Value, float>;
        if (r.whole) r.decimals = 0;
        double values[4] = {}, standards[4] = {};
        const int n = component_count(get(active()));
        unsigned mixed = 0;
        for (int i = 0; i < n; ++i) {
            values[i] = component(get(active()), i);
            standards[i] = component(get(std::as_const(standard_)), i);
            for (const Thing* thing : things_)
                if (component(get(*thing), i) != values[i]) mixed |= 1u << i;
        }
        const unsigned changed = ui::row(r, values, standards, n, mixed);
        if (changed == 0) return;
        apply(r.name, true, [&](Thing& thing) {
            for (int i = 0; i < n; ++i)
                if ((changed >> i & 1) != 0) set_component(get(thing), i, values[i]);
        });
    }

    template <class Get>
    void toggle(const char* name, const char* help, const Get& get) {
        bool value = get(active());
        const bool standard = get(std::as_const(standard_));
        if (ui::row(name, value, help, &standard, !is_same(get)))
            apply(name, false, [&](Thing& thing) { get(thing) = value; });
    }

    template <class Get>
    void color(const char* name, const char* help, const Get& get) {
        Double3 value = get(active());
        const Double3 standard = get(std::as_const(standard_));
        if (ui::row_color(name, value, help, &standard, !is_same(get)))
            apply(name, true, [&](Thing& thing) { get(thing) = value; });
    }

    template <class Get>
    void choice(const char* name, const char* help, const Get& get) {
        auto value = get(active());
        const auto standard = get(std::as_const(standard_));
        if (ui::row(name, value, help, &standard, !is_same(get)))
            apply(name, false, [&](Thing& thing) { get(thing) = value; });
    }

    /// Changes all the things by one edit; false if it was refused. Merged edits of one name that
    /// follow each other are one step.
    bool apply(const char* name, bool merges, const std::function<void(Thing&)>& change) {
        std::vector<Thing> changed;
        changed.reserve(things_.size());
        for (const Thing* thing : things_)
            change(changed.emplace_back(*thing));
        if (const std::string why = refusal(changed); !why.empty()) {
            say_refusal(c_, why);
            return false;
        }
        c_.document.edit(fmt::format("{} of {}", name, what_),
                         merges ? fmt::format("{} {}", key_, name) : std::string(),
                         [&](Scene& s) { each(s, change); });
        return true;
    }

    /// Changes the things in a scene that is being edited for another reason too.
    void each(Scene& scene, const std::function<void(Thing&)>& change) const {
        for (size_t i = 0; i < things_.size(); ++i)
            if (Thing* thing = reach_(scene, i)) change(*thing);
    }

    PanelContext& context() const { return c_; }

private:
    PanelContext& c_;
    std::string what_, key_;
    ScenePtr snapshot_;  // keeps the things alive through the edits of this frame
    std::vector<const Thing*> things_;
    Reach reach_;
    Thing standard_;
};

}  // namespace tp
