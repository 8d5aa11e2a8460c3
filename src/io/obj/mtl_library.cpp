#include "mtl_library.h"

#include <sstream>
#include <string_view>
#include <vector>

namespace tp {
namespace {

std::string_view trimmed(std::string_view text) {
    const size_t first = text.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

// The library's defaults do not tell what a file says from what it leaves out.
std::map<std::string, std::set<std::string>> words_of(std::string_view text) {
    std::map<std::string, std::set<std::string>> words;
    std::set<std::string>* of_material = nullptr;
    while (!text.empty()) {
        const size_t stop = text.find_first_of("\r\n");
        const std::string_view line = trimmed(text.substr(0, stop));
        text.remove_prefix(stop == std::string_view::npos ? text.size() : stop + 1);
        const size_t length = line.find_first_of(" \t");
        if (length == std::string_view::npos || line[0] == '#') continue;
        const std::string_view word = line.substr(0, length);
        if (word == "newmtl") {
            of_material = &words[std::string(trimmed(line.substr(length)))];
        } else if (of_material) {
            of_material->emplace(word);
        }
    }
    return words;
}

}  // namespace

void read_mtl(const std::string& text, std::map<std::string, MtlMaterial>& materials) {
    std::istringstream stream(text);
    std::map<std::string, int> index;
    std::vector<tinyobj::material_t> read;
    std::string warnings, errors;
    tinyobj::LoadMtl(&index, &read, &stream, &warnings, &errors);
    const auto words = words_of(text);
    for (tinyobj::material_t& values : read) {
        const std::string name(trimmed(values.name));
        const auto said = words.find(name);
        materials.try_emplace(
            name, MtlMaterial{std::move(values),
                              said == words.end() ? std::set<std::string>() : said->second});
    }
}

}  // namespace tp
