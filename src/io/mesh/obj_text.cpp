#include "obj_text.h"

#include "mesh_finish.h"
#include "text_scanner.h"

#include <teapath/core/color.h>
#include <teapath/core/error.h>

#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include <algorithm>
#include <istream>
#include <map>
#include <streambuf>
#include <utility>

namespace tp {
namespace {

// A stream over bytes in memory, without a copy.
class MemoryBuffer : public std::streambuf {
public:
    explicit MemoryBuffer(std::string_view bytes) {
        char* start = const_cast<char*>(bytes.data());  // a stream that only reads
        setg(start, start, start + bytes.size());
    }
};

std::string_view trimmed(std::string_view text) {
    const size_t first = text.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

class Builder {
public:
    Builder(const std::string& name, const std::function<void()>& tick)
        : name_(name), tick_(tick) {}

    ObjText text;

    void vertex(float x, float y, float z) {
        check_count(text.positions.size(), "vertices");
        text.positions.emplace_back(x, y, z);
        tick();
    }
    void normal(float x, float y, float z) {
        check_count(text.normals.size(), "normals");
        text.normals.emplace_back(x, y, z);
    }
    void uv(float u, float v) {
        check_count(text.uvs.size(), "texture coordinates");
        text.uvs.emplace_back(u, 1 - v);
    }
    void face(const tinyobj::index_t* indices, int count) {
        ++face_;
        tick();
        if (count < 3) return;
        if (!part_) part_ = &part();
        for (int i = 0; i < count; ++i)
            part_->corners.push_back(
                {index(indices[i].vertex_index, text.positions.size(), "vertices", true),
                 index(indices[i].texcoord_index, text.uvs.size(), "texture coordinates", false),
                 index(indices[i].normal_index, text.normals.size(), "normals", false)});
        part_->sizes.push_back(static_cast<uint32_t>(count));
    }
    void use_material(std::string_view material) {
        material_ = trimmed(material);
        part_ = nullptr;
    }
    void begin_group(std::string group) {
        group_ = std::move(group);
        part_ = nullptr;
    }
    void begin_object(std::string_view object) {
        object_ = trimmed(object);
        group_.clear();
        part_ = nullptr;
    }

private:
    void tick() {
        if (tick_ && ++ticks_ % kObjTick == 0) tick_();
    }

    void check_count(size_t count, const char* what) const {
        if (count >= kMaxMeshCount)
            throw Error(ErrorKind::Input, fmt::format("there are too many {}", what), name_,
                        "at most 2,147,483,648");
    }

    // From 1, or from the end where negative; 0 means none.
    uint32_t index(int64_t value, size_t count, const char* what, bool needed) const {
        if (value == 0 && !needed) return kNoIndex;
        const auto size = static_cast<int64_t>(count);
        const int64_t position = value > 0 ? value - 1 : size + value;
        if (value == 0 || position < 0 || position >= size)
            throw Error(ErrorKind::Input,
                        fmt::format("index {} is not one of the {} {}", value, count, what),
                        fmt::format("{}: face {}", name_, face_), "export the mesh again");
        return static_cast<uint32_t>(position);
    }

    // The part of the group and material that are on: a new one, or one that is continued.
    ObjPart& part() {
        const bool both = !object_.empty() && !group_.empty();
        const std::string group = fmt::format("{}{}{}", object_, both ? "/" : "", group_);
        const auto [entry, is_new] = part_of_.try_emplace({group, material_}, text.parts.size());
        if (is_new) text.parts.push_back({group, material_, {}, {}});
        return text.parts[entry->second];
    }

    const std::string& name_;
    const std::function<void()>& tick_;
    uint64_t ticks_ = 0, face_ = 0;
    std::string object_, group_, material_;
    std::map<std::pair<std::string, std::string>, size_t> part_of_;
    ObjPart* part_ = nullptr;  // null: to be looked up
};

Builder& builder(void* user) {
    return *static_cast<Builder*>(user);
}

tinyobj::callback_t callbacks() {
    tinyobj::callback_t c;
    c.vertex_cb = [](void* user, float x, float y, float z, float) {
        builder(user).vertex(x, y, z);
    };
    c.normal_cb = [](void* user, float x, float y, float z) { builder(user).normal(x, y, z); };
    c.texcoord_cb = [](void* user, float x, float y, float) { builder(user).uv(x, y); };
    c.index_cb = [](void* user, tinyobj::index_t* indices, int count) {
        builder(user).face(indices, count);
    };
    c.usemtl_cb = [](void* user, const char* material, int) {
        builder(user).use_material(material);
    };
    c.group_cb = [](void* user, const char** names, int count) {
        std::string group;
        for (int i = 0; i < count; ++i)
            group += fmt::format("{}{}", i ? " " : "", trimmed(names[i]));
        builder(user).begin_group(std::move(group));
    };
    c.object_cb = [](void* user, const char* object) { builder(user).begin_object(object); };
    return c;
}

// Calls `f` with the rest of each line that begins with one of these letters and a space, in order,
// until it answers false.
template <class F>
void for_lines(std::string_view bytes, std::string_view letters, F&& f) {
    for (size_t at = 0; at < bytes.size();) {
        size_t stop = bytes.find('\n', at);
        if (stop == std::string_view::npos) stop = bytes.size();
        const std::string_view line = bytes.substr(at, stop - at);
        if (line.size() > 1 && letters.find(line[0]) != letters.npos &&
            (line[1] == ' ' || line[1] == '\t'))
            if (!f(line.substr(2))) return;
        at = stop + 1;
    }
}

// Colours behind the places, sRGB as painting programs write them: the library has no callback for
// them. Looked for only where the first vertex has six numbers.
std::vector<Float4> colors_of(std::string_view bytes, size_t count) {
    std::vector<Float4> colors;
    for_lines(bytes, "v", [&](std::string_view line) {
        TextScanner numbers(line);
        double values[6];
        for (double& value : values) {
            const std::optional<double> number = numbers.number();
            if (!number) {
                colors.clear();
                return false;
            }
            value = *number;
        }
        if (colors.empty()) colors.reserve(count);
        const auto decoded = [&](int i) {
            return linear_from_srgb(static_cast<float>(std::clamp(values[i], 0.0, 1.0)));
        };
        colors.emplace_back(decoded(3), decoded(4), decoded(5), 1);
        return true;
    });
    if (colors.size() != count) colors.clear();
    return colors;
}

std::vector<std::string> libraries_of(std::string_view bytes) {
    constexpr std::string_view command = "mtllib";
    std::vector<std::string> libraries;
    for (size_t at = bytes.find(command); at != bytes.npos; at = bytes.find(command, at + 1)) {
        const size_t start = at + command.size();
        if ((at > 0 && bytes[at - 1] != '\n') || start >= bytes.size() ||
            (bytes[start] != ' ' && bytes[start] != '\t'))
            continue;
        const std::string_view rest = bytes.substr(start);
        libraries.emplace_back(trimmed(rest.substr(0, rest.find_first_of("\r\n"))));
    }
    return libraries;
}

// A backslash at its end continues a line, which the library does not know.
std::string joined_lines(std::string_view bytes) {
    std::string text;
    text.reserve(bytes.size());
    for (size_t i = 0; i < bytes.size(); ++i) {
        if (bytes[i] == '\\') {
            const size_t next = bytes.find_first_not_of('\r', i + 1);
            if (next != std::string_view::npos && bytes[next] == '\n') {
                text += ' ';
                i = next;
                continue;
            }
        }
        text += bytes[i];
    }
    return text;
}

}  // namespace

ObjText parse_obj(std::string_view bytes, const std::string& name,
                  const std::function<void()>& tick) {
    std::string joined;
    if (bytes.find("\\\n") != std::string_view::npos ||
        bytes.find("\\\r\n") != std::string_view::npos)
        bytes = joined = joined_lines(bytes);
    Builder building(name, tick);
    MemoryBuffer buffer(bytes);
    std::istream stream(&buffer);
    tinyobj::LoadObjWithCallback(stream, callbacks(), &building, nullptr, nullptr, nullptr);

    ObjText text = std::move(building.text);
    text.colors = colors_of(bytes, text.positions.size());
    text.libraries = libraries_of(bytes);
    for_lines(bytes, "lp", [&](std::string_view) { return ++text.lines_and_points > 0; });
    return text;
}

}  // namespace tp
