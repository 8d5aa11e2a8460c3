// tinygltf in a namespace of its own, with its code in tinygltf_implementation.cpp: Debian's
// libdraco brings a copy of another version, and a program that loads both libraries would mix them
// up. Files and images are no business of its here.
#pragma once

#define TINYGLTF_NO_FS
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#define tinygltf teapath_tinygltf
#include <tiny_gltf.h>
#undef tinygltf

namespace tinygltf = teapath_tinygltf;
