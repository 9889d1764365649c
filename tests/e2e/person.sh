# A person at a virtual screen, with mouse and keys, who follows what the window reports. To be sourced; needs
# `whorl`, the program's path.
patience=${WHORL_E2E_PATIENCE:-60} # seconds to wait for an effect; sanitizers are slow

for tool in Xvfb xdotool; do
    command -v "$tool" >/dev/null || { echo "skipped: $tool is not installed"; exit 77; }
done

work=$(mktemp -d)
trace=$work/trace
app=
screen=
cleanup() {
    [ -n "$app" ] && kill "$app" 2>/dev/null
    [ -n "$screen" ] && kill "$screen" 2>/dev/null
    wait 2>/dev/null
    rm -rf "$work"
}
trap cleanup EXIT

fail() {
    echo "FAILED: $*" >&2
    grep '"frame"' "$trace" 2>/dev/null | tail -1 >&2
    cat "$work/log" >&2
    exit 1
}
say() { echo "ok: $*"; }

# The last frame's value of a key, without quotes.
value() { grep '"event":"frame"' "$trace" 2>/dev/null | tail -1 | sed -E "s/.*\"$1\":\"?([^,\"}]*).*/\1/"; }
# Where a control is: its middle, or its left edge, width … by the names of the trace.
part() { grep -s -F "\"key\":\"$1\"" "$trace" | tail -1 | sed -E "s/.*\"$2\":(-?[0-9]+).*/\1/"; }
# until KEY OPERATOR VALUE: waits for the run to report it.
until_() {
    local end=$((SECONDS + patience))
    while ((SECONDS < end)); do
        awk -v a="$(value "$1")" -v b="$3" "BEGIN { exit !(a $2 b) }" && return 0
        sleep 0.1
    done
    fail "$1 is $(value "$1"), not $2 $3"
}
until_seen() {
    local end=$((SECONDS + patience))
    while ((SECONDS < end)); do
        grep -q -s -F "$1" "$trace" && return 0
        sleep 0.1
    done
    fail "no $1"
}
click() {
    until_seen "\"key\":\"$1\""
    sleep 0.3 # what was opened by the last click has its place
    xdotool mousemove "$(part "$1" x)" "$(part "$1" y)" sleep 0.2 click 1 sleep 0.2
}
# A place on the field, in hundredths of its size from the upper left corner.
field_x() { echo $(($(part field x) + ($1 - 50) * $(part field w) / 100)); }
field_y() { echo $(($(part field y) + ($1 - 50) * $(part field h) / 100)); }
# drag BUTTON X0 Y0 X1 Y1
drag() {
    xdotool mousemove "$(field_x "$2")" "$(field_y "$3")" sleep 0.2 mousedown "$1"
    for k in 1 2 3 4 5 6 7 8; do
        xdotool mousemove "$(field_x $(($2 + k * ($4 - $2) / 8)))" "$(field_y $(($3 + k * ($5 - $3) / 8)))" sleep 0.03
    done
    xdotool mouseup "$1"
}

# open_screen WIDTH HEIGHT [SCALE]: with a content scale, for which xrdb is needed.
open_screen() {
    Xvfb -displayfd 3 -screen 0 "$1x$2x24" -noreset 3>"$work/display" 2>"$work/xvfb.log" &
    screen=$!
    for _ in $(seq 100); do [ -s "$work/display" ] && break; sleep 0.1; done
    [ -s "$work/display" ] || fail "Xvfb gives no screen"
    DISPLAY=:$(cat "$work/display")
    export DISPLAY
    [ $# -lt 3 ] || echo "Xft.dpi: $((96 * $3))" | xrdb -merge || fail "no content scale without xrdb"
}
# open_window ARGUMENTS: in a folder of its own, with a memory of its own.
export XDG_STATE_HOME=$work/state
open_window() {
    rm -f "$trace"
    "$whorl" "$@" --trace "$trace" >"$work/log" 2>&1 &
    app=$!
    until_seen '"event":"frame"'
}
# The window ends as it should, and has said nothing.
close_window() {
    xdotool key q
    for _ in $(seq $((patience * 10))); do kill -0 $app 2>/dev/null || break; sleep 0.1; done
    kill -0 $app 2>/dev/null && fail "q does not quit"
    wait $app
    code=$?
    app=
    [ $code = 0 ] || fail "exit code $code"
    [ ! -s "$work/log" ] || fail "the log is not empty"
}
