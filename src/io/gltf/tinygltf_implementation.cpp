// The code of tinygltf, in this one place.
#include <fstream>  // which it forgets

#define TINYGLTF_IMPLEMENTATION
#include "tinygltf.h"
