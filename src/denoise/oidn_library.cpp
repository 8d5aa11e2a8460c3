#include "oidn_library.h"

#include <teapath/denoise/denoiser.h>

#include <dlfcn.h>
#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <vector>

namespace tp {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFile = "libOpenImageDenoise.so.2";

std::vector<std::string> places() {
    if (const char* named = std::getenv(kDenoiserVariable); named && *named) {
        std::error_code error;
        return {fs::is_directory(named, error) ? (fs::path(named) / kFile).string() : named};
    }
    std::vector<std::string> list;
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    if (!error) {
        list.push_back((program.parent_path() / kFile).string());
        list.push_back((program.parent_path().parent_path() / "lib" / kFile).string());
    }
    list.push_back((fs::path(TEAPATH_DENOISER_FOLDER) / kFile).string());
    list.emplace_back(kFile);
    return list;
}

void* open_library(std::string& why) {
    for (const std::string& place : places()) {
        if (void* library = dlopen(place.c_str(), RTLD_NOW | RTLD_LOCAL)) return library;
        const char* error = dlerror();
        // What is there and does not open is worth telling.
        std::error_code ignored;
        if (why.empty() && error && fs::exists(place, ignored)) why = error;
    }
    if (why.empty()) why = fmt::format("{} is not there", kFile);
    return nullptr;
}

template <class Function>
bool find(void* library, const char* name, Function& function, std::string& why) {
    function = reinterpret_cast<Function>(dlsym(library, name));
    if (!function && why.empty()) why = fmt::format("the library has no {}", name);
    return function != nullptr;
}

std::optional<OidnLibrary> load(std::string& why) {
    void* library = open_library(why);
    if (!library) return std::nullopt;
    OidnLibrary l{};
    const bool whole = find(library, "oidnNewDevice", l.new_device, why) &&
                       find(library, "oidnCommitDevice", l.commit_device, why) &&
                       find(library, "oidnReleaseDevice", l.release_device, why) &&
                       find(library, "oidnGetDeviceError", l.device_error, why) &&
                       find(library, "oidnGetDeviceInt", l.device_int, why) &&
                       find(library, "oidnNewBuffer", l.new_buffer, why) &&
                       find(library, "oidnWriteBuffer", l.write_buffer, why) &&
                       find(library, "oidnReadBuffer", l.read_buffer, why) &&
                       find(library, "oidnReleaseBuffer", l.release_buffer, why) &&
                       find(library, "oidnNewFilter", l.new_filter, why) &&
                       find(library, "oidnSetFilterImage", l.set_image, why) &&
                       find(library, "oidnSetFilterBool", l.set_bool, why) &&
                       find(library, "oidnSetFilterInt", l.set_int, why) &&
                       find(library, "oidnCommitFilter", l.commit_filter, why) &&
                       find(library, "oidnExecuteFilter", l.execute_filter, why) &&
                       find(library, "oidnReleaseFilter", l.release_filter, why);
    if (!whole) return std::nullopt;
    return l;
}

}  // namespace

const OidnLibrary* oidn_library(std::string& why) {
    // It stays open until the program ends: its threads may outlive whoever used it.
    static std::string reason;
    static const std::optional<OidnLibrary> library = load(reason);
    why = reason;
    return library ? &*library : nullptr;
}

}  // namespace tp
