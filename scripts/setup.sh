# shellcheck shell=bash
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
    local wanted installed package missing=
    wanted=$(sed 's/#.*//' "$root/scripts/packages.txt")
    installed=$(dpkg-query -W -f '${db:Status-Status} ${Package}\n' $wanted 2>/dev/null | sed -n 's/^installed //p' | tr '\n' ' ' || true)
    for package in $wanted; do
        case " $installed" in *" $package "*) ;; *) missing+=" $package" ;; esac
    done
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

# Whether there is an NVIDIA driver that runs what the compiler from PyPI (CUDA 13.0) makes: 580 or newer.
has_nvidia_driver() {
    local version
    if [ -r /sys/module/nvidia/version ]; then
        read -r version </sys/module/nvidia/version
        [[ ${version%%.*} =~ ^[0-9]+$ ]] && [ "${version%%.*}" -lt 580 ] || return 0
        why_no_cuda="no CUDA Toolkit here, and driver $version is older than 580, which the one from PyPI needs"
        return 1
    fi
    [ -e /dev/nvidiactl ] || [ -e /usr/lib/wsl/lib/libcuda.so.1 ] || command -v nvidia-smi >/dev/null ||
        PATH=$PATH:/usr/sbin:/sbin ldconfig -p 2>/dev/null | grep -q 'libcuda\.so\.1'
}

# Whether this CUDA compiler is one that Teapath is written for: 12.4 or newer.
nvcc_is_new_enough() {
    local release
    release=$("$1" --version 2>/dev/null | sed -nE 's/.*release ([0-9]+\.[0-9]+).*/\1/p')
    [ -n "$release" ] && [ "$(printf '%s\n' 12.4 "$release" | sort -V | head -1)" = 12.4 ]
}

# Sets nvcc to the CUDA compiler to use, or to nothing and why_no_cuda to the reason.
find_nvcc() {
    local place versions
    nvcc= why_no_cuda="neither a CUDA Toolkit nor an NVIDIA driver here"
    versions=$(printf '%s\n' /usr/local/cuda-*/bin/nvcc | sort -rV)
    for place in "${CUDACXX:-}" "${CUDA_HOME:+$CUDA_HOME/bin/nvcc}" "${CUDA_PATH:+$CUDA_PATH/bin/nvcc}" "$(type -P nvcc || true)" \
        /usr/local/cuda/bin/nvcc $versions /opt/cuda/bin/nvcc /usr/lib/cuda/bin/nvcc; do
        if [ -f "$place" ] && [ -x "$place" ] && nvcc_is_new_enough "$place"; then
            nvcc=$(cd "$(dirname "$place")" && pwd -P)/${place##*/}
            return
        fi
    done
    if has_nvidia_driver && fetch_cuda; then nvcc=$deps/cuda_root/bin/nvcc; fi
}

# nvcc and its libraries from PyPI, into a virtual environment of the build folder. A failure is
# remembered, so that the next start does not ask the network again.
fetch_cuda() {
    local failed=$deps/cuda.failed home
    why_no_cuda="the CUDA compiler could not be fetched; to try again, remove $failed"
    [ -x "$deps/cuda_root/bin/nvcc" ] && return 0
    [ -e "$failed" ] && return 1
    say "an NVIDIA driver without a CUDA Toolkit: fetching the compiler (105 MB)"
    if ! { python3 -m venv --clear "$deps/cuda" && "$deps/cuda/bin/python" -m pip -q --disable-pip-version-check \
        install --no-deps --only-binary=:all: --require-hashes -r "$root/scripts/cuda_wheels.txt"; } >&2; then
        touch "$failed"
        return 1
    fi
    home=$(cd "$deps" && echo cuda/lib/python3*/site-packages/nvidia/cu13)
    ln -sfn lib "$deps/$home/lib64"                          # where the compiler test looks for its libraries
    ln -sfn libcudart.so.13 "$deps/$home/lib/libcudart.so"
    ln -sfn "$home" "$deps/cuda_root"
}

# Real code for the cards of this machine, and PTX for later ones; without a card for 9.0, which every
# compiler from 12.4 on knows, so that the code is compiled at all. Prints nothing if the compiler
# knows the cards no longer.
cuda_architectures() {
    local cards card known newest wanted= ptx=
    cards=$(nvidia-smi --query-gpu=compute_cap --format=csv,noheader 2>/dev/null | tr -d '. ' | grep -xE '[0-9]+' | sort -un || true)
    if [ -z "$cards" ]; then echo 90; return; fi
    known=$("$nvcc" --list-gpu-arch | sed -n 's/^compute_\([0-9]*\)$/\1/p' | sort -n)
    newest=$(echo "$known" | tail -1)
    for card in $cards; do
        if echo "$known" | grep -qx "$card"; then
            wanted+="$card-real;" ptx=$card
        elif [ "$card" -gt "$newest" ]; then
            ptx=$newest                                      # the driver translates it for this card
        fi
    done
    [ -z "$ptx" ] || echo "$wanted$ptx-virtual"
}

# What the last configuration was made from.
configuration_stamp() {
    cat "$root"/CMakeLists.txt "$root"/scripts/*.txt "$root"/scripts/*.sh "$root"/third_party/*.cmake "$root"/cmake/*.cmake | sha256sum
    printf '%s\n' "$root" "$nvcc"
    cat /proc/driver/nvidia/gpus/*/information 2>/dev/null | grep Model || true   # another card: other code
    [ -e "$deps/window.stamp" ] && echo window || true
}

# configure OPTION …: one configuration of build/release; its output is in configure.log.
configure() {
    # A folder that was moved or copied cannot be configured again, only anew.
    grep -qsxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$build/CMakeCache.txt" || rm -rf "$build/CMakeCache.txt" "$build/CMakeFiles"
    local cache=
    if command -v ccache >/dev/null; then cache=ccache; fi
    cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release "-DCMAKE_CXX_COMPILER_LAUNCHER=$cache" \
        "-DCMAKE_C_COMPILER_LAUNCHER=$cache" "-DCMAKE_CUDA_COMPILER_LAUNCHER=$cache" "$@" >"$build/configure.log" 2>&1
}

# configure_with_cuda OPTION …: the same for the cards here; false where CUDA cannot be built.
configure_with_cuda() {
    [ -n "$nvcc" ] || return 1
    local architectures
    architectures=$(cuda_architectures)
    why_no_cuda="$nvcc no longer knows the cards of this machine"
    [ -n "$architectures" ] || return 1
    say "CUDA: $nvcc, for $architectures"
    configure -DTEAPATH_CUDA=ON "-DCMAKE_CUDA_COMPILER=$nvcc" "-DCMAKE_CUDA_ARCHITECTURES=$architectures" "$@" && return 0
    cp "$build/configure.log" "$build/configure_cuda.log"
    why_no_cuda="it could not be configured, see $build/configure_cuda.log"
    rm -rf "$build/CMakeCache.txt" "$build/CMakeFiles"
    return 1
}

# What the window is built from; a failure is remembered, so that the next start does not ask the network again.
fetch_window() {
    local failed=$deps/window.failed
    if [ -e "$failed" ] || bash "$root/scripts/fetch_window.sh" "$deps"; then return 0; fi
    touch "$failed"
    say "what the window needs could not be fetched: command line only; to try again, remove $failed"
}

# The denoiser's libraries, which the program loads where they are; a failure is remembered in the same way.
fetch_denoiser() {
    local failed=$deps/denoiser.failed
    if [ -e "$failed" ] || bash "$root/scripts/fetch_denoiser.sh" "$deps"; then return 0; fi
    touch "$failed"
    say "Open Image Denoise could not be fetched: pictures keep their noise; to try again, remove $failed"
}

# One set-up and build at a time in this folder; the lock ends with unlock or with the shell.
lock() {
    command -v flock >/dev/null || return 0
    exec 9>"$root/build/lock"
    flock -n 9 && return 0
    say "waiting for another set-up of this folder"
    flock 9
}
unlock() { exec 9>&-; }

# set_up: packages, what the window needs, the CUDA compiler, the configuration of build/release.
# TEAPATH_WERROR=ON makes warnings errors, and this stays so until the folder is removed.
set_up() {
    mkdir -p "$build" "$deps" || die "$root must be writable: everything is built in its folder build"
    lock
    install_packages
    fetch_window
    fetch_denoiser
    find_nvcc
    local stamp options=()
    [ "${TEAPATH_WERROR:-}" = ON ] && touch "$build/werror"
    [ -e "$build/werror" ] && options+=(-DTEAPATH_WERROR=ON)
    stamp=$(configuration_stamp; echo "${options[*]}")
    if [ -e "$build/build.ninja" ] && [ "$(cat "$build/setup.stamp" 2>/dev/null)" = "$stamp" ]; then return 0; fi
    rm -f "$build/setup.stamp"
    if ! configure_with_cuda "${options[@]}"; then
        say "no CUDA ($why_no_cuda): host backend only"
        configure -DTEAPATH_CUDA=OFF "${options[@]}" || { cat "$build/configure.log" >&2; die "the build could not be configured"; }
    fi
    printf '%s' "$stamp" >"$build/setup.stamp"
}

# build_targets TARGET …: quiet unless something is built. The last step of a set-up.
build_targets() {
    if ! ninja -C "$build" -n "$@" 2>/dev/null | grep -q 'no work to do'; then
        say "building in $build (the first time takes some minutes)"
        ninja -C "$build" "$@" >&2 || die "the build failed; the messages above say where"
    fi
    unlock
}
