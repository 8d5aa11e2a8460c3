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
find_package(draco REQUIRED)

# stb: headers only, each implementation compiled once, in io.
find_path(STB_INCLUDE_DIR stb/stb_image.h REQUIRED)
add_library(teapath_stb INTERFACE)
target_include_directories(teapath_stb SYSTEM INTERFACE ${STB_INCLUDE_DIR})

# tinygltf: its header only; src/io/gltf/tinygltf.h says why.
get_target_property(TINYGLTF_INCLUDE_DIR TinyGLTF::TinyGLTF INTERFACE_INCLUDE_DIRECTORIES)
add_library(teapath_tinygltf INTERFACE)
target_include_directories(teapath_tinygltf SYSTEM INTERFACE ${TINYGLTF_INCLUDE_DIR})

# libwebp: no CMake package.
find_path(WEBP_INCLUDE_DIR webp/decode.h REQUIRED)
find_library(WEBP_LIBRARY webp REQUIRED)
add_library(teapath_webp INTERFACE)
target_include_directories(teapath_webp SYSTEM INTERFACE ${WEBP_INCLUDE_DIR})
target_link_libraries(teapath_webp INTERFACE ${WEBP_LIBRARY})

if(TEAPATH_TESTS)
    find_package(doctest REQUIRED)
endif()
