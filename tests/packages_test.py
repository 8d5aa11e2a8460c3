#!/usr/bin/env python3
"""What a build takes from outside: the libraries are those of the product's list, every one has its
Debian package and its line in THIRD_PARTY_NOTICES.md, what comes from PyPI is pinned by hash, and no
file names a package server. Plain Python 3 without packages."""
import os
import re
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))

# CMake package or header: the Debian package that brings it, its name in THIRD_PARTY_NOTICES.md.
LIBRARIES = {
    "glm": ("libglm-dev", "GLM"),
    "stb": ("libstb-dev", "stb_image"),
    "spdlog": ("libspdlog-dev", "spdlog"),
    "fmt": ("libfmt-dev", "fmt"),
    "nlohmann_json": ("nlohmann-json3-dev", "nlohmann/json"),
    "CLI11": ("libcli11-dev", "CLI11"),
    "OpenEXR": ("libopenexr-dev", "OpenEXR"),
    "meshoptimizer": ("libmeshoptimizer-dev", "meshoptimizer"),
    "draco": ("libdraco-dev", "Draco"),
    "webp": ("libwebp-dev", "libwebp"),
    "TinyGLTF": ("libtinygltf-dev", "tinygltf"),
    "tinyobjloader": ("libtinyobjloader-dev", "tinyobjloader"),
    "doctest": ("doctest-dev", "doctest"),
}
BUILD_TOOLS = {"build-essential", "ca-certificates", "ccache", "cmake", "ninja-build", "pkg-config", "python3",
               "python3-venv"}
WINDOW_PACKAGES = {"libegl-dev", "libgl-dev", "libgl1-mesa-dri", "libxcursor-dev", "libxi-dev", "libxinerama-dev",
                   "libxrandr-dev"}
# From PyPI, by list: what may stand in it.
WHEELS = {
    "scripts/cuda_wheels.txt": {"nvidia-cuda-nvcc", "nvidia-cuda-runtime", "nvidia-cuda-cccl", "nvidia-cuda-crt",
                                "nvidia-nvvm"},
    "scripts/denoiser_wheels.txt": {"pyoidn"},
    "scripts/window_dependencies.txt": {"imgui-bundle"},
    "scripts/window_tools.txt": {"scikit-build-core", "packaging", "pathspec", "glad2", "jinja2", "markupsafe"},
    "tests/tools/requirements.txt": {"numpy", "openexr", "flip-evaluator"},
}
# First folder or name of an #include <…> with an extension or a folder, beside the standard library's.
INCLUDES = {"teapath", "glm", "stb", "spdlog", "fmt", "nlohmann", "CLI", "doctest", "cub", "thrust", "cuda", "GLFW",
            "glad", "GL", "draco", "webp"}
INCLUDE_FILES = re.compile(r"(Imf|Imath|Iex|Ilm|half|OpenEXR|Openexr|imgui|ImGui|implot|icons_font|portable_file|"
                           r"cuda|vector_types|math_constants|tiny_obj_loader\.h|tiny_gltf\.h|meshoptimizer\.h)")
SYSTEM_HEADERS = re.compile(r"(sys/|unistd\.h|fcntl\.h|signal\.h|io\.h|termios\.h|dlfcn\.h|pthread\.h|stdio\.h|errno\.h|sched\.h|spawn\.h|stdlib\.h)")
# Written in pieces, so that this file may be looked at as well.
SERVERS = [r"deb\.%s\.org" % "debian", r"archive\.%s\.com" % "ubuntu", r"snapshot\.%s" % "debian",
           r"%s\.org/(simple|project|packages)" % "pypi", r"python%s\.org" % "hosted", r"%s\.nvidia\.com/compute" % "download",
           r"(extra-)?index-%s" % "url", r"find-%s[ =]" % "links"]


def read(path):
    with open(os.path.join(ROOT, path), encoding="utf-8", errors="replace") as file:
        return file.read()


def lines_of(path):
    """A list's lines without comments."""
    return [line for line in (line.split("#")[0].strip() for line in read(path).splitlines()) if line]


def files_of(*folders):
    """Every text file of the repository below these folders, as path from the root."""
    skipped = {".git", "build", ".cache", "__pycache__"}
    found = []
    for folder in folders:
        for root, names, files in os.walk(os.path.join(ROOT, folder)):
            names[:] = [name for name in names if name not in skipped]
            found += [os.path.relpath(os.path.join(root, name), ROOT) for name in files]
    return [path for path in found if not path.endswith((".png", ".jpg", ".exr", ".hdr", ".ttf"))]


class Packages(unittest.TestCase):
    def test_debian_packages_are_those_of_the_product(self):
        packages = lines_of("scripts/packages.txt")
        self.assertEqual(len(packages), len(set(packages)), "a package is listed twice")
        self.assertEqual(set(packages), BUILD_TOOLS | WINDOW_PACKAGES | {debian for debian, _ in LIBRARIES.values()})

    def test_cmake_finds_the_libraries_of_the_list_and_no_others(self):
        cmake = "\n".join(lines_of("third_party/dependencies.cmake"))
        found = set(re.findall(r"find_package\((\w+)", cmake)) - {"Threads"}
        found |= {header.split("/")[0] for header in re.findall(r"find_path\(\w+ (\S+)", cmake)}
        self.assertEqual(found, set(LIBRARIES))

    def test_no_release_of_a_distribution_is_demanded(self):
        cmake = read("third_party/dependencies.cmake")
        self.assertNotIn("EXACT", cmake)
        self.assertFalse([line for line in lines_of("scripts/packages.txt") if re.search(r"[=<>~]", line)])

    def test_libraries_have_their_notice(self):
        notices = read("THIRD_PARTY_NOTICES.md")
        for _, name in LIBRARIES.values():
            self.assertIn(name, notices)
        for name in ("CUDA Toolkit", "Thrust", "GLFW", "glad", "Dear ImGui", "ImGuizmo", "ImPlot",
                     "Open Image Denoise", "FLIP", "NumPy"):
            self.assertIn(name, notices)

    def test_packages_from_pypi_are_those_of_the_list_and_pinned(self):
        for path, allowed in WHEELS.items():
            for line in lines_of(path):
                name, *rest = re.split(r"[=\s]+", line)
                self.assertIn(name.lower(), allowed, path)
                self.assertRegex(line, r"^[\w.-]+==[\w.]+( --hash=sha256:[0-9a-f]{64})+$", path)
            self.assertEqual(len(lines_of(path)), len(allowed), path)

    def test_sources_include_only_libraries_of_the_list(self):
        for path in files_of("include", "src", "tests"):
            if not path.endswith((".h", ".cpp", ".cu", ".cuh")):
                continue
            for header in re.findall(r"^\s*#\s*include\s*<([^>]+)>", read(path), re.M):
                if re.fullmatch(r"[a-z_0-9]+", header) or SYSTEM_HEADERS.match(header):
                    continue  # of the standard library or the system
                known = header.split("/")[0] in INCLUDES if "/" in header else INCLUDE_FILES.match(header)
                self.assertTrue(known or INCLUDE_FILES.match(header), "%s includes <%s>" % (path, header))

    def test_no_file_names_a_package_server(self):
        for path in files_of("."):
            found = re.search("|".join(SERVERS), read(path))
            self.assertIsNone(found, "%s: %s" % (path, found and found.group(0)))


if __name__ == "__main__":
    unittest.main()
