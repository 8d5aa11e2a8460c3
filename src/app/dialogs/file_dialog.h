// The state of an open question for a file: the native dialog that runs, or the browser's folder.
#pragma once

#include "file_question.h"

#include <memory>
#include <string>
#include <vector>

namespace pfd {
class open_file;
class save_file;
}  // namespace pfd

namespace tp {

struct FileDialog {
    FileQuestion question;
    std::shared_ptr<pfd::open_file> native_open;
    std::shared_ptr<pfd::save_file> native_save;
    bool is_native() const { return native_open || native_save; }

    // The browser's.
    std::filesystem::path folder;
    std::string name;       // what is typed or picked, from the folder on
    std::string path_text;  // of the folder, while it is typed
    size_t filter = 0;
    bool shows_hidden = false;
    FolderOrder order = FolderOrder::Name;
    bool descending = false;
    std::vector<FolderEntry> entries;
    std::string error;
    int cursor = -1;  // the entry that keys are at
    bool is_stale = true;
    bool asks_to_replace = false;
    bool was_opened = false;
};

}  // namespace tp
