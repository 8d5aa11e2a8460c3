#!/usr/bin/env bash
# fetch_window.sh FOLDER: obtains into FOLDER what the window is built from: Dear ImGui (docking), GLFW,
# ImGuizmo, ImPlot, fonts and, for the tests alone, the Dear ImGui test engine out of one source archive,
# and the GL loader, generated. Does nothing where they are already there. Needs python3 with venv, and the
# network the first time.
set -euo pipefail
folder=$1
scripts=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
stamp=$folder/window.stamp
wanted=$(cat "$scripts/window_dependencies.txt" "$scripts/window_tools.txt" "${BASH_SOURCE[0]}" | sha256sum)
[ -e "$stamp" ] && [ "$(cat "$stamp")" = "$wanted" ] && exit 0

mkdir -p "$folder"
work=$(mktemp -d "$folder/fetch.XXXXXX")
trap 'rm -rf "$work"' EXIT
python3 -m venv "$work/tools"
pip() { "$work/tools/bin/pip" --disable-pip-version-check -q "$@"; }
pip install --no-deps --require-hashes -r "$scripts/window_tools.txt"
pip download --no-deps --no-build-isolation --no-binary :all: --require-hashes -r "$scripts/window_dependencies.txt" -d "$work"

# Only the parts that are used.
mkdir "$work/unpacked"
tar -xzf "$work"/imgui_bundle-*.tar.gz -C "$work/unpacked" --strip-components=2 --wildcards \
    '*/external/imgui/imgui/*' '*/external/glfw/glfw/*' '*/external/implot/implot/*' '*/external/ImGuizmo/ImGuizmo/*' \
    '*/external/imgui_rich_md/imgui_rich_md/assets/fonts/*' '*/external/hello_imgui/hello_imgui/hello_imgui_assets/fonts/*' \
    '*/external/hello_imgui/hello_imgui/src/hello_imgui/icons_font_awesome_6.h' \
    '*/external/portable_file_dialogs/portable_file_dialogs/*' \
    '*/external/imgui_test_engine/imgui_test_engine/imgui_test_engine/*'
"$work/tools/bin/python" -m glad --quiet --reproducible --api gl:core=4.5 --extensions GL_KHR_debug --out-path "$work/glad" c

rm -rf "$folder/external" "$folder/glad"
mv "$work/unpacked" "$folder/external"
mv "$work/glad" "$folder/glad"
echo "$wanted" >"$stamp"
