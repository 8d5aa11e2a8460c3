#include "layout_file.h"

#include <teapath/core/error.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <fstream>

namespace tp {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr size_t kMaxName = 60;

// Letters, digits and what is harmless in a file's name as they are, other bytes as %hh.
std::string encoded(const std::string& name) {
    std::string text;
    for (const char c : name) {
        const auto byte = static_cast<unsigned char>(c);
        if (std::isalnum(byte) || c == ' ' || c == '-' || c == '_')
            text += c;
        else
            text += fmt::format("%{:02x}", byte);
    }
    return text;
}

fs::path file_of(const fs::path& folder, const std::string& name) {
    return folder / (encoded(name) + ".json");
}

Layout read(const fs::path& file) {
    std::ifstream in(file);
    if (!in) throw Error(ErrorKind::Input, "there is no such layout", file.string());
    const Json json = Json::parse(in, nullptr, false);
    try {
        return {json.at("name").get<std::string>(),
                json.at("closed_panels").get<std::vector<std::string>>(),
                json.at("places").get<std::string>()};
    } catch (const Json::exception&) {
        throw Error(ErrorKind::Input, "this is no layout", file.string(), "delete it");
    }
}

}  // namespace

std::string why_no_layout_name(std::string_view name) {
    if (name.find_first_not_of(' ') == name.npos) return "a name is needed";
    if (name.size() > kMaxName) return "the name is too long";
    for (const char* built_in : {"Edit", "Render", "Inspect"})
        if (name == built_in) return "this name is taken";
    return "";
}

std::vector<std::string> layout_names(const fs::path& folder) {
    std::vector<std::string> names;
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
        if (entry.path().extension() != ".json") continue;
        try {
            names.push_back(read(entry.path()).name);
        } catch (const Error&) {
            // Another program's file.
        }
    }
    std::sort(names.begin(), names.end());
    return names;
}

Layout load_layout(const fs::path& folder, const std::string& name) {
    return read(file_of(folder, name));
}

void save_layout(const fs::path& folder, const Layout& layout) {
    std::error_code error;
    fs::create_directories(folder, error);
    const fs::path file = file_of(folder, layout.name);
    const Json json = {
        {"name", layout.name}, {"closed_panels", layout.closed_panels}, {"places", layout.places}};
    fs::path part = file;
    part += ".part";
    {
        std::ofstream out(part);
        out << json.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
        if (!out.flush()) error = std::make_error_code(std::errc::io_error);
    }
    if (!error) fs::rename(part, file, error);
    if (error)
        throw Error(ErrorKind::Output, "the layout cannot be written: " + error.message(),
                    file.string());
}

void delete_layout(const fs::path& folder, const std::string& name) {
    std::error_code error;
    if (!fs::remove(file_of(folder, name), error))
        throw Error(ErrorKind::Output, "the layout cannot be deleted",
                    file_of(folder, name).string());
}

}  // namespace tp
