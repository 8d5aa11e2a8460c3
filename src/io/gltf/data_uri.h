// URIs as glTF has them: data in base64, or names of files with percent signs.
#pragma once

#include <string>
#include <string_view>

namespace tp {

/// True for "data:…".
bool is_data_uri(std::string_view uri);

/// The bytes of a data URI in base64 and its media type ("image/png"). Throws Error(Input) at
/// `where` if it is not base64.
struct DataUri {
    std::string type, bytes;
};
DataUri decode_data_uri(std::string_view uri, const std::string& where);

/// %20 becomes a space; what is no such code stays.
std::string percent_decoded(std::string_view uri);

}  // namespace tp
