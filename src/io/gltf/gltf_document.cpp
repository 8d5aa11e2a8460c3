#include "gltf_document.h"

#include "data_uri.h"
#include "gltf_container.h"

#include <teapath/core/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <climits>
#include <exception>
#include <utility>

namespace tp {
namespace {

std::string text_of(const Json& object, const char* key) {
    const auto found = object.find(key);
    return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

// A number from 0 upwards; `absent` if it is missing.
uint64_t count_of(const Json& object, const char* key, uint64_t absent, const std::string& where) {
    const auto found = object.find(key);
    if (found == object.end()) return absent;
    const bool is_whole =
        found->is_number_unsigned() ||
        (found->is_number_float() && found->get<double>() >= 0 && found->get<double>() < 1e15);
    if (!is_whole)
        throw Error(ErrorKind::Input, fmt::format("{} is not a number from 0 upwards", key), where,
                    "export the model again");
    return found->is_number_unsigned() ? found->get<uint64_t>()
                                       : static_cast<uint64_t>(found->get<double>());
}

// Takes a list out of the root; each element is an object.
Json take_list(Json& root, const char* key, const std::string& name) {
    const auto found = root.find(key);
    if (found == root.end()) return Json::array();
    Json list = std::move(*found);
    root.erase(key);
    if (!list.is_array())
        throw Error(ErrorKind::Input, fmt::format("{} is not a list", key), name,
                    "export the model again");
    for (size_t i = 0; i < list.size(); ++i)
        if (!list[i].is_object())
            throw Error(ErrorKind::Input, "this is not an object",
                        fmt::format("{}: {}[{}]", name, key, i), "export the model again");
    return list;
}

bool is_fallback(const Json& buffer) {
    const auto extensions = buffer.find("extensions");
    return extensions != buffer.end() && extensions->is_object() &&
           extensions->contains("EXT_meshopt_compression");
}

class Opener {
public:
    Opener(std::string bytes, const ModelSource& source)
        : source_(source), file_(std::make_shared<const std::string>(std::move(bytes))) {
        document_.source = &source;
    }

    GltfDocument open() {
        const GltfContainer container = open_container(*file_, source_.name);
        if (container.json.find_first_not_of(" \t\r\n") == std::string_view::npos)
            throw Error(ErrorKind::Input, "the file is empty", source_.name,
                        "export the model again");
        Json root = parse_json(container.json, source_.name);
        if (!root.is_object())
            throw Error(ErrorKind::Input, "this is not a glTF file", source_.name,
                        "its JSON must be an object");
        check_version(root);
        const Json buffers = take_list(root, "buffers", source_.name);
        for (size_t i = 0; i < buffers.size(); ++i)
            add_buffer(buffers[i], i, container);
        const Json images = take_list(root, "images", source_.name);
        for (size_t i = 0; i < images.size(); ++i)
            add_image(images[i], i);
        document_.animations = take_list(root, "animations", source_.name);
        const size_t views = give_views_to_indices(root);
        parse_rest(root);
        document_.model.bufferViews.resize(std::min(views, document_.model.bufferViews.size()));
        for (const size_t i : without_view_)
            document_.model.accessors[i].bufferView = -1;
        return std::move(document_);
    }

private:
    void check_version(const Json& root) {
        const auto asset = root.find("asset");
        const std::string version =
            asset != root.end() && asset->is_object() ? text_of(*asset, "version") : "";
        if (!version.starts_with("2"))
            throw Error(ErrorKind::Input,
                        version.empty() ? std::string("this is not a glTF 2.0 file")
                                        : fmt::format("this is glTF {}", version),
                        source_.name, "export the model as glTF 2.0");
    }

    void add_buffer(const Json& buffer, size_t index, const GltfContainer& container) {
        const std::string where = document_.place("buffers", index);
        const uint64_t length = count_of(buffer, "byteLength", 0, where);
        const std::string uri = text_of(buffer, "uri");
        std::string_view bytes;
        if (uri.empty()) {
            if (is_fallback(buffer)) return document_.buffers.push_back({});
            if (index != 0 || !container.binary)
                throw Error(ErrorKind::Input, "the buffer has no data", where,
                            "export the model again");
            document_.bytes.push_back(file_);
            bytes = *container.binary;
        } else {
            document_.bytes.push_back(std::make_shared<const std::string>(
                is_data_uri(uri)
                    ? decode_data_uri(uri, where).bytes
                    : read_beside(source_, percent_decoded(uri), "a buffer (.bin)", where)));
            bytes = *document_.bytes.back();
        }
        if (bytes.size() < length)
            throw Error(ErrorKind::Input,
                        fmt::format("the buffer has {} bytes of {}", bytes.size(), length), where,
                        "it may be cut short: copy or export it again");
        document_.buffers.push_back(bytes.substr(0, length));
    }

    void add_image(const Json& image, size_t index) {
        const std::string where = document_.place("images", index);
        GltfImage added;
        added.name = text_of(image, "name");
        added.type = text_of(image, "mimeType");
        const std::string uri = text_of(image, "uri");
        if (is_data_uri(uri)) {
            DataUri data = decode_data_uri(uri, where);
            added.bytes = std::make_shared<const std::string>(std::move(data.bytes));
            added.type = data.type;
        } else if (!uri.empty()) {
            added.uri = percent_decoded(uri);
            path_beside(source_, added.uri, where);
        } else {
            const uint64_t view = count_of(image, "bufferView", INT_MAX, where);
            added.view = static_cast<int>(std::min<uint64_t>(view, INT_MAX));
        }
        document_.images.push_back(std::move(added));
    }

    // tinygltf refuses indices without a buffer view, though sparse and compressed ones have none:
    // they get one behind the others, which is taken away again. Returns how many there were.
    size_t give_views_to_indices(Json& root) {
        const auto views = root.find("bufferViews"), accessors = root.find("accessors");
        size_t count = views != root.end() && views->is_array() ? views->size() : 0;
        if (accessors == root.end() || !accessors->is_array()) return count;
        for (size_t i = 0; i < accessors->size(); ++i) {
            Json& accessor = (*accessors)[i];
            if (!accessor.is_object() || accessor.contains("bufferView")) continue;
            accessor["bufferView"] = count;
            without_view_.push_back(i);
        }
        const Json none = {{"buffer", 0}, {"byteLength", 1}};
        if (views == root.end())
            root["bufferViews"] = Json::array({none});
        else if (views->is_array())
            views->push_back(none);
        return count;
    }

    void parse_rest(const Json& root) {
        const std::string text = root.dump(-1, ' ', false, Json::error_handler_t::replace);
        if (text.size() > INT_MAX)
            throw Error(ErrorKind::Input, "the JSON of the file is larger than 2 GiB", source_.name,
                        "export the model with its data in a buffer");
        tinygltf::TinyGLTF reader;
        std::string errors, warnings;
        bool is_read = false;
        try {
            is_read = reader.LoadASCIIFromString(&document_.model, &errors, &warnings, text.data(),
                                                 static_cast<unsigned>(text.size()), "",
                                                 tinygltf::NO_REQUIRE);
        } catch (const std::exception& error) {
            errors = error.what();
        }
        if (is_read) return;
        errors = errors.substr(0, errors.find('\n'));
        throw Error(ErrorKind::Input,
                    fmt::format("this is not glTF as it should be ({})",
                                errors.empty() ? "unknown reason" : errors),
                    source_.name, "export the model again");
    }

    const ModelSource& source_;
    std::shared_ptr<const std::string> file_;
    GltfDocument document_;
    std::vector<size_t> without_view_;  // accessors
};

}  // namespace

std::string GltfDocument::place(const char* list, size_t index) const {
    return fmt::format("{}: {}[{}]", source->name, list, index);
}

GltfDocument parse_gltf(std::string bytes, const ModelSource& source) {
    return Opener(std::move(bytes), source).open();
}

std::string_view bytes_of_view(const GltfDocument& document, int view, const std::string& where) {
    const auto& views = document.model.bufferViews;
    const auto index = static_cast<size_t>(view);
    if (view < 0 || index >= views.size())
        throw Error(ErrorKind::Input, fmt::format("there is no buffer view {}", view), where,
                    "export the model again");
    if (index < document.decoded.size() && !document.decoded[index].empty())
        return document.decoded[index];
    const tinygltf::BufferView& v = views[index];
    if (v.buffer < 0 || static_cast<size_t>(v.buffer) >= document.buffers.size())
        throw Error(ErrorKind::Input, fmt::format("there is no buffer {}", v.buffer),
                    document.place("bufferViews", index), "export the model again");
    const std::string_view buffer = document.buffers[static_cast<size_t>(v.buffer)];
    if (v.byteOffset > buffer.size() || v.byteLength > buffer.size() - v.byteOffset)
        throw Error(ErrorKind::Input,
                    fmt::format("the view reaches beyond the {} bytes of buffer {}", buffer.size(),
                                v.buffer),
                    document.place("bufferViews", index), "export the model again");
    return buffer.substr(v.byteOffset, v.byteLength);
}

}  // namespace tp
