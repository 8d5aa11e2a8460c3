"""Triangle meshes as PLY files: reading those of the reference scenes, writing them for Teapath.

In memory v = 0 is the top row of an image; in a PLY file, as Teapath reads it, v = 0 is the bottom."""
import struct


def read_ply(path):
    """The reference scenes' own kind of file: binary, float vertices, faces of three corners."""
    with open(path, "rb") as file:
        data = file.read()
    head, body = data.split(b"end_header\n", 1)
    counts, columns, element = {}, [], None
    for line in head.decode().split("\n"):
        words = line.split()
        if words[:1] == ["element"]:
            element = words[1]
            counts[element] = int(words[2])
        elif words[:1] == ["property"] and element == "vertex":
            columns.append(words[2])
    row = struct.Struct("<%df" % len(columns))
    vertices = [dict(zip(columns, row.unpack_from(body, i * row.size))) for i in range(counts["vertex"])]
    face = struct.Struct("<B3i")
    start = row.size * counts["vertex"]
    mesh = {"positions": [[v["x"], v["y"], v["z"]] for v in vertices],
            "indices": [face.unpack_from(body, start + i * face.size)[1:] for i in range(counts["face"])]}
    if "nx" in columns:
        mesh["normals"] = [[v["nx"], v["ny"], v["nz"]] for v in vertices]
    if "u" in columns:
        mesh["uvs"] = [[v["u"], v["v"]] for v in vertices]
    return mesh


def write_ply(path, mesh):
    lists = [(mesh["positions"], ["x", "y", "z"])]
    if "normals" in mesh:
        lists.append((mesh["normals"], ["nx", "ny", "nz"]))
    if "uvs" in mesh:
        lists.append(([[u, 1 - v] for u, v in mesh["uvs"]], ["u", "v"]))
    names = [name for _, part in lists for name in part]
    head = ["ply", "format binary_little_endian 1.0", "element vertex %d" % len(mesh["positions"])]
    head += ["property float " + name for name in names]
    head += ["element face %d" % len(mesh["indices"]), "property list uchar int vertex_indices", "end_header", ""]
    with open(path, "wb") as file:
        file.write("\n".join(head).encode())
        for vertex in zip(*[values for values, _ in lists]):
            file.write(struct.pack("<%df" % len(names), *[x for part in vertex for x in part]))
        for corners in mesh["indices"]:
            file.write(struct.pack("<B3i", 3, *corners))
