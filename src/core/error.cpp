#include <teapath/core/error.h>

#include <utility>

namespace tp {
namespace {

std::string join(const std::string& what, const std::string& where, const std::string& remedy) {
    std::string text = where.empty() ? what : where + ": " + what;
    if (!remedy.empty()) text += " (" + remedy + ")";
    return text;
}

}  // namespace

Error::Error(ErrorKind kind, std::string what, std::string where, std::string remedy)
    : std::runtime_error(join(what, where, remedy)),
      kind_(kind),
      where_(std::move(where)),
      remedy_(std::move(remedy)) {}

}  // namespace tp
