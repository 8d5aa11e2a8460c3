// Model files that a scene names, each read once: whole for its entries under "models", and in
// parts for meshes and images by a path such as "car.glb#mesh/3".
#pragma once

#include <teapath/io/model_file.h>
#include <teapath/scene/scene.h>

#include <filesystem>
#include <map>
#include <memory>
#include <string>

namespace tp {

class ModelCache {
public:
    /// Paths start at `folder`; `name` begins what is logged. Models of `known` are taken from it.
    ModelCache(std::string folder, std::string name, const Scene* known = nullptr,
               ModelReadOptions options = {});

    /// The content of the file; null, with a warning, if it cannot be read.
    std::shared_ptr<const ModelContent> content(const std::string& path);

    /// The part of a model that the path names behind `#`; null, with a warning, if there is none.
    std::shared_ptr<const Mesh> mesh(const std::string& path);
    std::shared_ptr<const Image> image(const std::string& path);

private:
    std::string folder_, name_;
    ModelReadOptions options_;
    std::map<std::string, std::shared_ptr<const ModelContent>> contents_;
};

/// Reads a model file as scenes hold it: its lights are objects. Logs what it does not support.
std::shared_ptr<const ModelContent> read_content(const std::filesystem::path& file,
                                                 const ModelReadOptions& options);

/// True if the path names a part of a model file.
bool names_part(const std::string& path);

}  // namespace tp
