// The one exception that users see.
#pragma once

#include <stdexcept>
#include <string>

namespace tp {

/// What kind of thing failed; decides the exit code of a command.
enum class ErrorKind { Usage = 2, Input = 3, Device = 4, Output = 5 };

/// A failure that a user can understand: what failed, where (file and JSON path, or device call),
/// and how to mend it. Caught in three places: opening a file, drawing a frame, main.
class Error : public std::runtime_error {
public:
    Error(ErrorKind kind, std::string what, std::string where = {}, std::string remedy = {});

    ErrorKind kind() const { return kind_; }
    const std::string& where() const { return where_; }
    const std::string& remedy() const { return remedy_; }
    /// The exit code of the command that ends with this error.
    int exit_code() const { return static_cast<int>(kind_); }

private:
    ErrorKind kind_;
    std::string where_;
    std::string remedy_;
};

}  // namespace tp
