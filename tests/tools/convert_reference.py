#!/usr/bin/env python3
"""Turns a reference scene (format "teapath-reference-scene") into a scene of Teapath.

  convert_reference.py IN.json OUT.json

Textures are referred to by their absolute path; meshes become PLY files beside OUT.json. What Teapath cannot yet express is named on stderr,
one line a part; then nothing is written and the exit code is 3.
"""
import json
import math
import os
import sys

from ply_file import read_ply, write_ply


class Unsupported(Exception):
    """A part of the scene that Teapath cannot express."""


def convert_camera(camera):
    return {"look_from": camera["look_from"], "look_at": camera["look_at"], "up": camera["up"],
            "vertical_fov": camera["vertical_fov"], "aperture": 2 * camera["aperture_radius"],
            "focus_distance": camera["focus_distance"]}


def convert_environment(environment, folder):
    if environment is None:
        return {"type": "constant", "color": 0}
    kind = environment["type"]
    if kind == "gradient":
        return {"type": "gradient", "bottom": environment["bottom"], "top": environment["top"]}
    if kind == "constant":
        return {"type": "constant", "color": environment["radiance"]}
    if kind == "image":
        return {"type": "image", "file": os.path.join(folder, "scenes", environment["file"]), "color_space": "linear"}
    raise Unsupported("environment of type " + kind)


def convert_texture(texture, folder):
    if texture["type"] == "checker":
        return {"type": "checker", "cells": texture["cells"], "even": texture["even"], "odd": texture["odd"]}
    if texture["type"] in ("image", "bitmap"):
        return {"type": "image", "file": os.path.join(folder, "scenes", texture["file"]), "repeat": texture.get("repeat", [1, 1])}
    raise Unsupported("texture of type " + texture["type"])


def convert_facets(material):
    alpha = material.get("alpha", 0)
    return {"roughness": math.sqrt(alpha), "masking": material["masking"], "compensation": False} if alpha > 0 else {}


def convert_material(material, emission):
    kind = material["type"]
    if kind == "lambert":
        if emission and material["albedo"] == [0, 0, 0]:
            return {"type": "diffuse_light", "emission": emission, "side": "front"}
        result = {"type": "lambertian", "color": material["albedo"]}
    elif kind == "mirror":
        result = {"type": "metal", "color": material["reflectance"], "fuzz": 0}
    elif kind == "dielectric":
        result = {"type": "dielectric", "ior": material["interior_ior"], "exterior_ior": material.get("exterior_ior", 1)}
        result.update(convert_facets(material))
    elif kind == "conductor":
        result = {"type": "conductor", "metal": "custom", "eta": material["eta"], "k": material["k"]}
        result.update(convert_facets(material))
    elif kind == "metallic_roughness":
        result = {"type": "principled", "color": material["base_color"], "metallic": material["metallic"],
                  "roughness": material["roughness"], "compensation": False}
    else:
        raise Unsupported("material of type " + kind)
    if emission:
        result.update({"emission": emission, "side": "front"})
    return result


def convert_mesh(mesh, folder, output, number):
    """The shape; its triangles go to a file beside the output."""
    triangles = read_ply(os.path.join(folder, "scenes", mesh["file"])) if "file" in mesh else mesh
    path = "%s_%d.ply" % (os.path.splitext(output)[0], number)
    write_ply(path, triangles)
    return {"type": "mesh", "file": os.path.basename(path), "smooth": mesh.get("smooth", "normals" in mesh)}


def convert_transform(mesh):
    scale = mesh.get("scale", 1)
    return {"translate": mesh.get("translate", [0, 0, 0]), "scale": scale if isinstance(scale, list) else [scale] * 3}


def convert_shape(shape, folder, output, number):
    kind = shape["type"]
    if shape.get("medium_inside") or shape.get("medium_outside"):
        raise Unsupported("media")
    if kind == "sphere":
        radius = -shape["radius"] if shape.get("inside_out") else shape["radius"]
        return {"type": "sphere", "center": shape["center"], "radius": radius}
    if kind == "rectangle":
        return {"type": "rectangle", "corner": shape["corner"], "edge_u": shape["edge_u"], "edge_v": shape["edge_v"]}
    if kind == "box":
        return {"type": "box", "low": shape["min"], "high": shape["max"]}
    if kind == "mesh":
        return convert_mesh(shape, folder, output, number)
    raise Unsupported("shape of type " + kind)


def convert(scene, folder, output):
    """The Teapath scene of a reference scene whose files lie below `folder`; raises Unsupported."""
    missing = []

    def attempt(function, *arguments):
        try:
            return function(*arguments)
        except Unsupported as part:
            missing.append(str(part))
            return None

    if scene.get("media"):
        missing.append("media")
    result = {
        "teapath": 1,
        "name": scene["name"],
        "description": scene.get("about", ""),
        "camera": convert_camera(scene["camera"]),
        "render": {"width": scene["film"]["width"], "height": scene["film"]["height"], "max_depth": scene["max_depth"]},
        "background": attempt(convert_environment, scene.get("environment"), folder),
        "textures": {name: attempt(convert_texture, t, folder) for name, t in scene.get("textures", {}).items()},
        "materials": {},
        "objects": [],
    }
    for number, shape in enumerate(scene["shapes"]):
        emission = shape.get("emission")
        name = shape["material"] + (" emitting %s" % emission if emission else "")
        if name not in result["materials"]:
            result["materials"][name] = attempt(convert_material, scene["materials"][shape["material"]], emission)
        item = {"shape": attempt(convert_shape, shape, folder, output, number), "material": name}
        if shape["type"] == "mesh":
            item["transform"] = convert_transform(shape)
        result["objects"].append(item)
    if missing:
        raise Unsupported("\n".join(sorted(set(missing))))
    return result


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    with open(sys.argv[1]) as file:
        scene = json.load(file)
    folder = os.path.dirname(os.path.dirname(os.path.abspath(sys.argv[1])))
    try:
        converted = convert(scene, folder, sys.argv[2])
    except Unsupported as parts:
        for part in str(parts).split("\n"):
            print("%s: not yet: %s" % (sys.argv[1], part), file=sys.stderr)
        sys.exit(3)
    with open(sys.argv[2], "w") as file:
        json.dump(converted, file, indent=1)


if __name__ == "__main__":
    main()
