// Material libraries of OBJ files, as their text says; tinyobjloader reads the lines.
#pragma once

#include <tiny_obj_loader.h>

#include <map>
#include <set>
#include <string>

namespace tp {

struct MtlMaterial {
    tinyobj::material_t values;
    std::set<std::string> said;  // first words of its lines: "Kd", "map_Kd", "Pr"
};

/// Adds the materials of a library by name; those that are there already stay.
void read_mtl(const std::string& text, std::map<std::string, MtlMaterial>& materials);

}  // namespace tp
