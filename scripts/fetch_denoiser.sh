#!/usr/bin/env bash
# fetch_denoiser.sh FOLDER: obtains into FOLDER/denoiser/lib the libraries of Open Image Denoise, for the
# processor and for CUDA. Does nothing where they are already there. Needs python3 with venv, and the
# network the first time.
set -euo pipefail
folder=$1
scripts=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
stamp=$folder/denoiser.stamp
wanted=$(cat "$scripts/denoiser_wheels.txt" "${BASH_SOURCE[0]}" | sha256sum)
[ -e "$stamp" ] && [ "$(cat "$stamp")" = "$wanted" ] && exit 0
[ "$(uname -m)" = x86_64 ] || { echo "Open Image Denoise is there for x86-64 alone" >&2; exit 1; }

mkdir -p "$folder"
work=$(mktemp -d "$folder/fetch.XXXXXX")
trap 'rm -rf "$work"' EXIT
python3 -m venv "$work/tools"
"$work/tools/bin/pip" --disable-pip-version-check -q download --no-deps --only-binary=:all: --require-hashes \
    -r "$scripts/denoiser_wheels.txt" -d "$work"

# Only the libraries that are used; they find each other in a folder of this name.
python3 -m zipfile -e "$work"/pyoidn-*.whl "$work/unpacked"
mkdir -p "$work/denoiser/lib"
for name in OpenImageDenoise OpenImageDenoise_core OpenImageDenoise_device_cpu OpenImageDenoise_device_cuda tbb; do
    find "$work/unpacked" -name "lib$name.so*" -exec cp {} "$work/denoiser/lib/" \;
done
[ -e "$work/denoiser/lib/libOpenImageDenoise.so.2" ] || { echo "the package holds no libOpenImageDenoise.so.2" >&2; exit 1; }
rm -rf "$folder/denoiser"
mv "$work/denoiser" "$folder/denoiser"
echo "$wanted" >"$stamp"
