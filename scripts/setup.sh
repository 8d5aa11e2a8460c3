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
    if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
        say "this system has no Debian packages: scripts/packages.txt lists what must be there"
        return 0
    fi
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
    local lock=(-o DPkg::Lock::Timeout=300)
    $sudo apt-get "${lock[@]}" update -qq >&2 || say "the package lists could not be refreshed; trying with the old ones"
    $sudo env DEBIAN_FRONTEND=noninteractive apt-get "${lock[@]}" install -y -qq --no-install-recommends $missing >&2 ||
        die "the packages could not be installed; by hand: apt-get install" $missing
}

has_nvidia_driver() { [ -e /dev/nvidiactl ] || command -v nvidia-smi >/dev/null || ldconfig -p 2>/dev/null | grep -q 'libcuda\.so\.1'; }

# Whether this CUDA compiler is one that Teapath is written for: 12.4 or newer.
nvcc_is_new_enough() {
    local release
    release=$("$1" --version 2>/dev/null | sed -nE 's/.*release ([0-9]+\.[0-9]+).*/\1/p')
    [ -n "$release" ] && [ "$(printf '%s\n' 12.4 "$release" | sort -V | head -1)" = 12.4 ]
}

# Sets nvcc to the CUDA compiler to use, or to nothing.
find_nvcc() {
    local place
    nvcc=
    while IFS= read -r place; do
        if [ -x "$place" ] && nvcc_is_new_enough "$place"; then nvcc=$(readlink -f "$place"); return; fi
    done < <(printf '%s\n' "${CUDACXX:-}" "${CUDA_HOME:+$CUDA_HOME/bin/nvcc}" "$(command -v nvcc || true)" /usr/local/cuda/bin/nvcc
        printf '%s\n' /usr/local/cuda-*/bin/nvcc | sort -rV
        printf '%s\n' /opt/cuda/bin/nvcc /usr/lib/cuda/bin/nvcc)
    has_nvidia_driver || return 0
    if fetch_cuda; then nvcc=$deps/cuda_root/bin/nvcc; fi
}

# nvcc and its libraries from PyPI, into a virtual environment of the build folder. A failure is
# remembered, so that the next start does not ask the network again.
fetch_cuda() {
    local venv=$deps/cuda failed=$deps/cuda.failed home
    [ -x "$deps/cuda_root/bin/nvcc" ] && return 0
    [ -e "$failed" ] && return 1
    say "an NVIDIA driver without a CUDA Toolkit: fetching the compiler"
    if ! { python3 -m venv "$venv" && "$venv/bin/pip" -q --disable-pip-version-check install --no-deps --require-hashes -r "$root/scripts/cuda_wheels.txt"; } >&2; then
        touch "$failed"
        say "the CUDA compiler could not be fetched; to try again, remove $failed"
        return 1
    fi
    home=$(echo "$venv"/lib/python3*/site-packages/nvidia/cu13)
    ln -sfn lib "$home/lib64"                                # where the compiler test looks for its libraries
    ln -sfn libcudart.so.13 "$home/lib/libcudart.so"
    ln -sfn "$home" "$deps/cuda_root"
}

# Real code for the cards of this machine and PTX of the newest for later ones; without a card for
# the newest kind that every compiler from 12.4 on knows, so that the code is compiled at all.
# Prints nothing if the compiler knows none of the cards.
cuda_architectures() {
    local cards known
    cards=$(nvidia-smi --query-gpu=compute_cap --format=csv,noheader 2>/dev/null | tr -d '. ' | grep -E '^[0-9]+$' | sort -un || true)
    if [ -z "$cards" ]; then echo 90; return; fi
    known=$(comm -12 <(echo "$cards" | sort) <("$nvcc" --list-gpu-arch | sed 's/compute_//' | sort) | sort -n)
    [ -n "$known" ] || return 0
    echo "$(echo "$known" | sed 's/$/-real/' | paste -sd';');$(echo "$known" | tail -1)-virtual"
}

# What the last configuration was made from.
configuration_stamp() {
    cat "$root"/CMakeLists.txt "$root"/scripts/*.txt "$root"/scripts/*.sh "$root"/third_party/*.cmake "$root"/cmake/*.cmake | sha256sum
    printf '%s\n' "$root" "$nvcc"
    [ -e "$deps/window.stamp" ] && echo window || true
}

# configure OPTION …: one configuration of build/release; its output is in configure.log.
configure() {
    # A folder that was moved or copied cannot be configured again, only anew.
    grep -qsxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$build/CMakeCache.txt" || rm -rf "$build/CMakeCache.txt" "$build/CMakeFiles"
    cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER_LAUNCHER=ccache \
        -DCMAKE_C_COMPILER_LAUNCHER=ccache -DCMAKE_CUDA_COMPILER_LAUNCHER=ccache "$@" >"$build/configure.log" 2>&1
}

# configure_with_cuda OPTION …: the same for the cards here; false where CUDA cannot be built.
configure_with_cuda() {
    [ -n "$nvcc" ] || return 1
    local architectures
    architectures=$(cuda_architectures)
    [ -n "$architectures" ] || { say "CUDA: $nvcc knows none of the cards of this machine"; return 1; }
    say "CUDA: $nvcc, for $architectures"
    configure -DTEAPATH_CUDA=ON "-DCMAKE_CUDA_COMPILER=$nvcc" "-DCMAKE_CUDA_ARCHITECTURES=$architectures" "$@" && return 0
    cp "$build/configure.log" "$build/configure_cuda.log"
    say "CUDA could not be configured; why is in $build/configure_cuda.log"
    rm -rf "$build/CMakeCache.txt" "$build/CMakeFiles"
    return 1
}

# set_up: packages, what the window needs, the CUDA compiler, the configuration of build/release.
# TEAPATH_WERROR=ON makes warnings errors, and this stays so until the folder is removed.
set_up() {
    install_packages
    mkdir -p "$build" "$deps"
    bash "$root/scripts/fetch_window.sh" "$deps" || say "what the window needs could not be fetched: command line only"
    find_nvcc
    local stamp options=()
    [ "${TEAPATH_WERROR:-}" = ON ] && touch "$build/werror"
    [ -e "$build/werror" ] && options+=(-DTEAPATH_WERROR=ON)
    stamp=$(configuration_stamp; echo "${options[*]}")
    if [ -e "$build/build.ninja" ] && [ "$(cat "$build/setup.stamp" 2>/dev/null)" = "$stamp" ]; then return 0; fi
    rm -f "$build/setup.stamp"
    if ! configure_with_cuda "${options[@]}"; then
        say "no CUDA: host backend only"
        configure -DTEAPATH_CUDA=OFF "${options[@]}" || { cat "$build/configure.log" >&2; die "the build could not be configured"; }
    fi
    printf '%s' "$stamp" >"$build/setup.stamp"
}

# build_targets TARGET …: quiet unless something is built.
build_targets() {
    if ninja -C "$build" -n "$@" 2>/dev/null | grep -q 'no work to do'; then return 0; fi
    say "building in $build (the first time takes some minutes)"
    ninja -C "$build" "$@" >&2 || die "the build failed; the messages above say where"
}
