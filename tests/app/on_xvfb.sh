#!/usr/bin/env bash
# on_xvfb.sh COMMAND …: runs a command on a screen of its own (Xvfb), with a window manager (openbox)
# where there is one, and ends both afterwards. Gives back the command's status.
set -euo pipefail
work=$(mktemp -d)
server= manager=
finish() {
    [ -z "$manager" ] || kill "$manager" 2>/dev/null || true
    [ -z "$server" ] || kill "$server" 2>/dev/null || true
    wait 2>/dev/null || true
    rm -rf "$work"
}
trap finish EXIT

mkfifo "$work/display"
Xvfb -displayfd 3 -screen 0 1600x1000x24 -nolisten tcp 3>"$work/display" >"$work/log" 2>&1 &
server=$!
if ! read -r -t 20 number <"$work/display"; then
    cat "$work/log" >&2
    echo "Xvfb did not start" >&2
    exit 1
fi
export DISPLAY=:$number
unset WAYLAND_DISPLAY
if command -v openbox >/dev/null; then
    HOME=$work XDG_CONFIG_HOME=$work openbox >>"$work/log" 2>&1 &
    manager=$!
    sleep 1
fi
"$@"
