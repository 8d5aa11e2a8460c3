# Sourced by ./run and ./check: installs what is missing, configures, builds. A second start does
# nothing but ask ninja, without network or sudo.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$root/build/release
deps=$root/build/deps
export CCACHE_BASEDIR=$root

say() { printf '%s\n' "$*" >&2; }
die() { say "error: $*"; exit 1; }

# Installs the packages of scripts/packages.txt that are not there.
install_packages() {
    command -v dpkg-query >/dev/null || die "this system has no Debian packages; install what scripts/packages.txt lists by hand, then configure with CMake (CONTRIBUTING.md)"
    local wanted missing
    wanted=$(sed 's/#.*//' "$root/scripts/packages.txt")
    missing=$(comm -23 <(printf '%s\n' $wanted | sort) \
        <(dpkg-query -W -f '${db:Status-Status} ${Package}\n' $wanted 2>/dev/null | sed -n 's/^installed //p' | sort -u))
    [ -z "$missing" ] && return 0
    local sudo=
    if [ "$(id -u)" != 0 ]; then
        command -v sudo >/dev/null || die "these packages are missing and sudo is not there to install them; as root: apt-get install -y --no-install-recommends" $missing
        sudo=sudo
    fi
    say "installing packages:" $missing
    $sudo apt-get update -qq || say "the package lists could not be refreshed; trying with the old ones"
    $sudo env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $missing >&2 ||
        die "the packages could not be installed; by hand: apt-get install" $missing
}

has_nvidia_driver() { [ -e /dev/nvidiactl ] || command -v nvidia-smi >/dev/null || ldconfig -p 2>/dev/null | grep -q 'libcuda\.so\.1'; }

# Sets nvcc to the CUDA compiler to use, or to nothing.
find_nvcc() {
    local place
    nvcc=
    for place in "${CUDACXX:-}" "${CUDA_HOME:+$CUDA_HOME/bin/nvcc}" "$(command -v nvcc || true)" /usr/local/cuda/bin/nvcc \
        /usr/local/cuda-*/bin/nvcc /opt/cuda/bin/nvcc /usr/lib/cuda/bin/nvcc; do
        if [ -n "$place" ] && [ -x "$place" ]; then nvcc=$(readlink -f "$place"); return; fi
    done
    has_nvidia_driver || return 0
    fetch_cuda && nvcc=$deps/cuda_root/bin/nvcc || say "the CUDA compiler could not be fetched: host backend only"
}

# nvcc and its libraries from PyPI, into a virtual environment of the build folder.
fetch_cuda() {
    local venv=$deps/cuda home
    [ -x "$deps/cuda_root/bin/nvcc" ] && return 0
    say "an NVIDIA driver without a CUDA Toolkit: fetching the compiler"
    python3 -m venv "$venv" && "$venv/bin/pip" -q --disable-pip-version-check install --no-deps --require-hashes -r "$root/scripts/cuda_wheels.txt" || return 1
    home=$(echo "$venv"/lib/python3*/site-packages/nvidia/cu13)
    ln -sfn lib "$home/lib64"                                # where the compiler test looks for its libraries
    ln -sfn libcudart.so.13 "$home/lib/libcudart.so"
    ln -sfn "$home" "$deps/cuda_root"
}

# Real code for the cards of this machine and PTX for later ones; without a card for the newest two
# kinds of data-centre card, so that the code is compiled at all.
cuda_architectures() {
    local cards
    cards=$(nvidia-smi --query-gpu=compute_cap --format=csv,noheader 2>/dev/null | tr -d . | grep -E '^[0-9]+$' | sort -un || true)
    if [ -z "$cards" ]; then echo 90; return; fi
    echo "$cards" | sed 's/$/-real/' | paste -sd';' - | sed "s/\$/;$(echo "$cards" | tail -1)-virtual/"
}

# What the last configuration was made from.
configuration_stamp() {
    cat "$root"/CMakeLists.txt "$root"/scripts/*.txt "$root"/scripts/*.sh "$root"/third_party/*.cmake "$root"/cmake/*.cmake | sha256sum
    printf '%s\n' "$nvcc" "$@"
}

# set_up [CMake option …]: leaves the program in $build/teapath.
set_up() {
    install_packages
    mkdir -p "$deps"
    bash "$root/scripts/fetch_window.sh" "$deps" || say "what the window needs could not be fetched: command line only"
    find_nvcc
    local stamp
    stamp=$(configuration_stamp "$@")
    if [ ! -e "$build/build.ninja" ] || [ "$(cat "$build/setup.stamp" 2>/dev/null)" != "$stamp" ]; then
        local cuda=(-DTEAPATH_CUDA=OFF)
        if [ -n "$nvcc" ]; then
            cuda=(-DTEAPATH_CUDA=ON "-DCMAKE_CUDA_COMPILER=$nvcc" "-DCMAKE_CUDA_ARCHITECTURES=$(cuda_architectures)" -DCMAKE_CUDA_COMPILER_LAUNCHER=ccache)
            say "CUDA: $nvcc"
        else
            say "no CUDA here: host backend only"
        fi
        mkdir -p "$build"
        cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER_LAUNCHER=ccache -DCMAKE_C_COMPILER_LAUNCHER=ccache \
            "${cuda[@]}" "$@" >"$build/configure.log" 2>&1 || { cat "$build/configure.log" >&2; die "the build could not be configured"; }
        printf '%s' "$stamp" >"$build/setup.stamp"
    fi
}

# build_targets TARGET …: quiet unless something is built.
build_targets() {
    if ninja -C "$build" -n "$@" 2>/dev/null | grep -q 'no work to do'; then return 0; fi
    say "building (the first time takes some minutes)"
    ninja -C "$build" "$@" >&2
}
