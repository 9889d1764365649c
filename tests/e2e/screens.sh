#!/usr/bin/env bash
# Takes a picture of the window's every panel, tab, lab, dialog and lesson, to be looked at: the guide shows them.
# usage: screens.sh WHORL FOLDER WIDTH HEIGHT [SCALE]   needs scrot, and for a content scale xrdb
set -u
whorl=$1
folder=$(realpath "$2")
width=$3
height=$4
. "$(dirname "$0")/person.sh"
command -v scrot >/dev/null || { echo "scrot is not installed"; exit 1; }

open_screen "$width" "$height" ${5:+"$5"}
mkdir -p "$folder" "$work/files"
cd "$work/files" || exit 1
shot() {
    sleep 0.8
    scrot -o "$folder/$1.png" || fail "no picture $1"
    say "$1"
}
rest() { xdotool mousemove "$((width / 2))" $((height - 2)); }
# Turns the wheel over the left column until a control is in sight.
scroll_to() {
    until_seen "\"key\":\"$1\""
    xdotool mousemove "$(part play x)" $((height / 2))
    for _ in $(seq 80); do
        (($(part "$1" y) < height - 12)) && return
        xdotool click 5 sleep 0.1
    done
    fail "$1 does not come into sight"
}

open_window plume --lanes thesis-five --set resolution=64 --size "${width}x$height" --tour
until_seen '"key":"tour-card=1"'
shot tour
click tour-skip
until_ step ">" 300
xdotool mousemove "$(field_x 50)" "$(field_y 50)" key space
rest
shot plots
for tab in Spectrum Budget Table; do
    click "tab=$tab"
    rest
    shot "${tab,,}"
done
click tab=Plots
xdotool key h
rest
shot help
xdotool key Escape
xdotool key ctrl+o
rest
shot open
xdotool key Escape

# The left column, page by page.
for page in 1 2 3 4 5 6 7 8; do
    rest
    shot "controls-$page"
    (($(part lab=inspector y) < height)) && break
    xdotool mousemove "$(part play x)" $((height / 2))
    for _ in 1 2 3 4 5 6; do xdotool click 5 sleep 0.1; done
done
scroll_to lab=slice
for lab in interpolation stencil slice; do
    click "lab=$lab"
    rest
    shot "lab-$lab"
    xdotool key Escape
done
xdotool mousemove "$(field_x 50)" "$(field_y 50)" key i
xdotool mousemove "$(field_x 50)" "$(field_y 80)" sleep 0.3 click 1
until_seen '"key":"inspector-value"'
rest
shot inspector
xdotool key 0
xdotool key i

rest
xdotool key l
shot lessons
for lesson in $("$whorl" lesson | awk '/^  [a-z]/{print $1}'); do
    run=$(value run)
    click "lesson=$lesson"
    until_ run ">" "$run"
    rest
    shot "lesson-$lesson"
    click lesson-all
done
click lesson-close
close_window
