# Finds each library that Teapath uses. They come from Debian packages (see scripts/packages.txt);
# version ranges are accepted, nothing is copied here.

find_package(Threads REQUIRED)
find_package(glm REQUIRED)
find_package(fmt REQUIRED)
find_package(spdlog REQUIRED)
find_package(nlohmann_json 3.10 REQUIRED)
find_package(CLI11 REQUIRED)
find_package(OpenEXR CONFIG REQUIRED)
find_package(tinyobjloader REQUIRED)
find_package(TinyGLTF REQUIRED)
find_package(meshoptimizer REQUIRED)

# stb: headers only, each implementation compiled once, in io.
find_path(STB_INCLUDE_DIR stb/stb_image.h REQUIRED)
add_library(teapath_stb INTERFACE)
target_include_directories(teapath_stb SYSTEM INTERFACE ${STB_INCLUDE_DIR})

if(TEAPATH_TESTS)
    find_package(doctest REQUIRED)
endif()
