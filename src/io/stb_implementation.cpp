// The one place where stb is compiled; built without our warnings.
#define STB_IMAGE_IMPLEMENTATION
#define STBI_MAX_DIMENSIONS 65536
#define STBI_NO_STDIO
#include <stb/stb_image.h>

#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>
