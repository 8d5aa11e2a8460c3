// Every key of a scene file, once: reader, writer, the list of keys and the tests all walk these
// functions. A visitor `v` is called with the key and the field; v.kind reads or writes the key
// that tells a union's member. A new setting is one line here, one in the schema and one in
// docs/scene_format.md.
#pragma once

#include <teapath/scene/enum_tables.h>
#include <teapath/scene/scene.h>

namespace tp {

template <class V>
void camera_fields(V& v, Camera& c) {
    v("name", c.name);
    v("look_from", c.look_from);
    v("look_at", c.look_at);
    v("up", c.up);
    v("projection", c.projection);
    v("vertical_fov", c.vertical_fov);
    v("film_height", c.film_height);
    v("shift", c.shift);
    v("aperture", c.aperture);
    v("blades", c.blades);
    v("blade_rotation", c.blade_rotation);
    v("focus_distance", c.focus_distance);
    v("near_clip", c.near_clip);
    v("far_clip", c.far_clip);
}

template <class V>
void noise_fields(V& v, Texture& t) {
    v("space", t.space);
    v("scale", t.scale);
    v("octaves", t.octaves);
    v("lacunarity", t.lacunarity);
    v("gain", t.gain);
    v("seed", t.seed);
    v("tea_rounds", t.tea_rounds);
}

template <class V>
void texture_fields(V& v, Texture& t) {
    v.kind("type", t.kind);
    switch (t.kind) {
        case TextureKind::Constant: v.color("color", t.color); break;
        case TextureKind::Checker:
            v("even", t.even);
            v("odd", t.odd);
            v("mode", t.mode);
            v("cells", t.cells);
            v("frequency", t.frequency);
            break;
        case TextureKind::Image:
            v.image("file", t.file);
            v("wrap", t.wrap);
            v("wrap_v", t.wrap_v);
            v("filter", t.filter);
            v("color_space", t.color_space);
            v("uv_set", t.uv_set);
            v("repeat", t.repeat);
            v("uv_rotation", t.uv_rotation);
            v("uv_offset", t.uv_offset);
            v.color("tint", t.tint);
            v("projection", t.projection);
            v("space", t.space);
            v("sharpness", t.sharpness);
            break;
        case TextureKind::Noise:
            v("low", t.low);
            v("high", t.high);
            v("pattern", t.pattern);
            v("contrast", t.contrast);
            noise_fields(v, t);
            break;
        case TextureKind::Marble:
            v("stone", t.stone);
            v("vein", t.vein);
            v("axis", t.axis);
            v("distortion", t.distortion);
            v("vein_power", t.vein_power);
            noise_fields(v, t);
            break;
        case TextureKind::Wood:
            v("early", t.early);
            v("late", t.late);
            v("axis", t.axis);
            v("distortion", t.distortion);
            v("grain", t.grain);
            noise_fields(v, t);
            break;
        case TextureKind::Brick:
            v("brick", t.brick);
            v("mortar", t.mortar);
            v("brick_size", t.brick_size);
            v("mortar_width", t.mortar_width);
            v("mortar_blend", t.mortar_blend);
            v("row_offset", t.row_offset);
            v("variation", t.variation);
            v("space", t.space);
            v("seed", t.seed);
            v("tea_rounds", t.tea_rounds);
            break;
    }
}

template <class V>
void principled_fields(V& v, PrincipledSurface& s) {
    v("metallic", s.metallic);
    v("roughness", s.roughness);
    v("specular", s.specular);
    v("specular_color", s.specular_color);
    v("anisotropy", s.anisotropy);
    v("anisotropy_rotation", s.anisotropy_rotation);
    v("transmission", s.transmission);
    v("thin", s.thin);
    v.color("attenuation_color", s.attenuation_color);
    v("attenuation_distance", s.attenuation_distance);
    v("dispersion", s.dispersion);
    v("diffuse_transmission", s.diffuse_transmission);
    v("diffuse_transmission_color", s.diffuse_transmission_color);
    v("coat", s.coat);
    v("coat_roughness", s.coat_roughness);
    v.texture("coat_normal", s.coat_normal);
    v("coat_normal_scale", s.coat_normal_scale);
    v("sheen_color", s.sheen_color);
    v("sheen_roughness", s.sheen_roughness);
    v("iridescence", s.iridescence);
    v("iridescence_ior", s.iridescence_ior);
    v("iridescence_thickness_low", s.iridescence_thickness_low);
    v("iridescence_thickness", s.iridescence_thickness);
    v.texture("normal", s.normal);
    v("normal_scale", s.normal_scale);
    v.texture("bump", s.bump);
    v("bump_scale", s.bump_scale);
    v("compensation", s.compensation);
}

/// What a material starts from before its fields are read: glass is clear, metals have no tint, the
/// rest is mid-grey.
inline Material default_material(MaterialKind kind) {
    Material m;
    m.kind = kind;
    if (kind == MaterialKind::Dielectric || kind == MaterialKind::Conductor)
        m.color.color = {1, 1, 1};
    return m;
}

template <class V>
void material_fields(V& v, Material& m) {
    v.kind("type", m.kind);
    v.start_from(m, default_material(m.kind));
    if (m.kind != MaterialKind::DiffuseLight) v("color", m.color);
    if (m.kind == MaterialKind::Metal) v("fuzz", m.fuzz);
    if (m.kind == MaterialKind::Dielectric) {
        v("ior", m.ior);
        v("exterior_ior", m.exterior_ior);
        v("fresnel", m.fresnel);
    }
    if (m.kind == MaterialKind::Conductor) {
        v("metal", m.metal);
        v("eta", m.eta);
        v("k", m.k);
    }
    if (m.kind == MaterialKind::Dielectric || m.kind == MaterialKind::Conductor) {
        v("roughness", m.roughness);
        v("masking", m.masking);
        v("compensation", m.surface.compensation);
    }
    if (m.kind == MaterialKind::Principled) {
        v("ior", m.ior);
        principled_fields(v, m.surface);
    }
    if (m.kind == MaterialKind::DiffuseLight)
        v("emission", m.emission);
    else
        v.glow("emission", m.emits, m.emission);
    v("strength", m.strength);
    v("side", m.side);
    v("spot_angle", m.spot_angle);
    v("spot_blend", m.spot_blend);
    v("alpha", m.alpha);
    v("alpha_cutoff", m.alpha_cutoff);
    v("opacity", m.opacity);
    v.color("pass_through", m.pass_through);
}

template <class V>
void shape_fields(V& v, SphereShape& s) {
    v("center", s.center);
    v("radius", s.radius);
}
template <class V, class Rect>
void axis_rect_fields(V& v, Rect& r) {
    v("low", r.low);
    v("high", r.high);
    v("k", r.k);
}
template <class V>
void shape_fields(V& v, XyRectShape& r) {
    axis_rect_fields(v, r);
}
template <class V>
void shape_fields(V& v, XzRectShape& r) {
    axis_rect_fields(v, r);
}
template <class V>
void shape_fields(V& v, YzRectShape& r) {
    axis_rect_fields(v, r);
}
template <class V>
void shape_fields(V& v, RectangleShape& r) {
    v("corner", r.corner);
    v("edge_u", r.edge_u);
    v("edge_v", r.edge_v);
}
template <class V>
void shape_fields(V& v, BoxShape& b) {
    v("low", b.low);
    v("high", b.high);
}
template <class V>
void shape_fields(V& v, DiskShape& d) {
    v("center", d.center);
    v("normal", d.normal);
    v("radius", d.radius);
}
template <class V>
void shape_fields(V& v, TriangleShape& t) {
    v("a", t.a);
    v("b", t.b);
    v("c", t.c);
}

template <class V>
void shape_fields(V& v, MeshShape& m) {
    v.mesh("file", m.file);
    v("smooth", m.smooth);
    v.matrix("placement", m.placement);
}

template <class V>
void transform_fields(V& v, Transform& t) {
    v("translate", t.translation);
    v("rotate", t.rotation);
    v("scale", t.scale);
}

template <class V>
void object_fields(V& v, Object& o) {
    v("name", o.name);
    v.shape("shape", o.shape);
    v.object("transform", o.transform, [](auto& w, Transform& t) { transform_fields(w, t); });
    v("material", o.material);
    v("inside_out", o.inside_out);
    v("visible", o.visible);
    v("camera_visible", o.camera_visible);
    v("casts_shadows", o.casts_shadows);
    v("reflection_visible", o.reflection_visible);
}

template <class V>
void model_fields(V& v, Model& m) {
    v("name", m.name);
    v.required("file", m.path,
               "the path of a model (.gltf, .glb, .obj), relative to the scene file");
    v.object("transform", m.transform, [](auto& w, Transform& t) { transform_fields(w, t); });
    v("animation", m.animation);
    v.changes("objects");
    v.changes("materials");
    v.changes("textures");
}

template <class V>
void generator_fields(V& v, Generator& g) {
    v.constant("type", "sphere_grid");
    v("name", g.name);
    v("columns", g.grid.columns);
    v("rows", g.grid.rows);
    v("spacing", g.grid.spacing);
    v("center", g.grid.center);
    v("ground", g.grid.ground);
    v("radius", g.grid.radius);
    v("jitter", g.grid.jitter);
    v("lambertian", g.grid.lambertian);
    v("metal", g.grid.metal);
    v("ior", g.grid.ior);
    v("thesis_colors", g.grid.thesis_colors);
    v("keep_clear", g.grid.keep_clear);
    v("seed", g.grid.seed);
}

template <class V>
void sky_fields(V& v, Sky& s) {
    v("sun_by", s.sun_by);
    v("sun_elevation", s.sun_elevation);
    v("sun_azimuth", s.sun_azimuth);
    v("latitude", s.latitude);
    v("longitude", s.longitude);
    v("day", s.day);
    v("hour", s.hour);
    v("sun_size", s.sun_size);
    v("sun_strength", s.sun_strength);
    v("haze", s.haze);
    v.color("ground", s.ground);
}

template <class V>
void background_fields(V& v, Background& b) {
    v.kind("type", b.kind);
    switch (b.kind) {
        case BackgroundKind::Gradient:
            v.color("bottom", b.bottom);
            v.color("top", b.top);
            break;
        case BackgroundKind::Constant: v.color("color", b.color); break;
        case BackgroundKind::Image:
            v.image("file", b.file);
            v("color_space", b.color_space);
            v("rotation", b.rotation);
            v.color("tint", b.tint);
            break;
        case BackgroundKind::Sky:
            sky_fields(v, b.sky);
            v.color("tint", b.tint);
            break;
    }
    v("strength", b.strength);
    v("backdrop", b.backdrop);
    v.color("backdrop_color", b.backdrop_color);
    v.optional_image("backdrop_file", b.backdrop_file);
}

template <class V>
void render_fields(V& v, RenderSettings& r) {
    v("width", r.width);
    v("height", r.height);
    v("samples", r.samples);
    v("seconds", r.seconds);
    v("time", r.time);
    v("denoise", r.denoise);
    v("denoise_strength", r.denoise_strength);
    v("integrator", r.path.integrator);
    v("max_depth", r.path.max_depth);
    v("roulette_depth", r.path.roulette_depth);
    v("light_sampling", r.path.light_sampling);
    v("light_choice", r.path.light_rule);
    v("clamp_direct", r.path.clamp_direct);
    v("clamp_indirect", r.path.clamp_indirect);
    v("terminator_fix", r.path.terminator_fix);
    v("scatter", r.path.scatter);
    v("sampler", r.path.sampler);
    v("tea_rounds", r.path.tea_rounds);
    v("key_rounds", r.path.key_rounds);
    v("seed", r.path.seed);
}

template <class V>
void display_fields(V& v, DisplaySettings& d) {
    v("exposure", d.exposure);
    v("exposure_by", d.rule);
    v("ev", d.ev);
    v("f_number", d.f_number);
    v("shutter", d.shutter);
    v("iso", d.iso);
    v("tone_curve", d.curve);
}

template <class V>
void scene_fields(V& v, Scene& s) {
    v.schema("$schema", s.origin.schema);
    v.constant("teapath", 1);
    v("name", s.name);
    v("description", s.description);
    v.cameras(s);
    v.object("render", s.render, [](auto& w, RenderSettings& r) { render_fields(w, r); });
    v.object("display", s.display, [](auto& w, DisplaySettings& d) { display_fields(w, d); });
    v.object("background", s.background, [](auto& w, Background& b) { background_fields(w, b); });
    v.models("models", s);
    v.named("textures", s.textures.edit());
    v.named("materials", s.materials.edit());
    v.list("objects", s.objects.edit(), [](auto& w, Object& o) { object_fields(w, o); });
    v.model_changes();
    v.list("generate", s.generators.edit(), [](auto& w, Generator& g) { generator_fields(w, g); });
}

}  // namespace tp
