#!/usr/bin/env bash
# Uses the window as a person does, with mouse and keys on a virtual screen, and follows what the run reports.
# usage: window_test.sh WHORL CHECK_PICTURE
set -u
whorl=$1
check_picture=$2
. "$(dirname "$0")/person.sh"

# ---- without a display: one line, exit code 3
env -u DISPLAY "$whorl" empty >"$work/log" 2>&1
code=$?
[ $code = 3 ] && [ "$(wc -l <"$work/log")" = 1 ] || fail "without a display: exit code $code"
say "without a display it says so and exits 3"

# ---- a screen and the window
open_screen 1600 1000
mkdir "$work/pictures"
cd "$work/pictures" || exit 1
open_empty() {
    open_window empty --set resolution=64 --size 1600x1000
    until_ step ">" 5
}

# ---- the first start
open_empty
until_seen '"key":"tour-card=1"'
click tour-next
until_seen '"key":"tour-card=2"'
xdotool key Right
until_seen '"key":"tour-card=3"'
before=$(value step)
until_ step ">" "$before"
click tour-skip
until_seen '"event":"tour-seen"'
[ -f "$XDG_STATE_HOME/whorl/tour-seen" ] || fail "the tour is not remembered"
say "the first start shows a tour, over a run that plays"
xdotool key F12
close_window
"$check_picture" whorl-0001.png >"$work/picture" || fail "the picture is lost"
rm whorl-0001.png
say "a picture is finished though the window is closed"

# ---- the second
open_empty
grep -q -s -F tour-card "$trace" && fail "the tour comes back"
say "the window opens and the run plays, without the tour"

# ---- mouse on the field
drag 1 30 70 60 50
until_ total_density ">" 1
say "a drag injects smoke"
xdotool keydown shift
drag 1 70 20 85 20
xdotool keyup shift
until_ solids ">" 0
say "a shift-drag paints an obstacle"
painted=$(value solids)
xdotool keydown ctrl
drag 1 70 20 78 20
xdotool keyup ctrl
until_ solids "<" "$painted"
say "a ctrl-drag erases"
xdotool mousemove "$(field_x 50)" "$(field_y 50)" click 4 click 4
until_ brush_radius ">" 2.2
say "the wheel widens the brush"

# ---- controls, by mouse
click interpolation
click interpolation=fritsch-carlson
until_ interpolation "==" fritsch-carlson
say "another interpolation"
click interpolation
for key in Down Return; do xdotool sleep 0.3 keydown $key sleep 0.4 keyup $key; done # held, so that slow frames see it
until_ interpolation "!=" fritsch-carlson
say "one further down, by keys"
click advector
click advector=aslam
until_ advector "==" aslam
until_ interpolation "==" linear
say "ASLAM, which takes linear interpolation along"
until_seen '"key":"zeta"'
xdotool mousemove $(($(part zeta x) + $(part zeta w) * 4 / 10)) "$(part zeta y)" sleep 0.2 click 1
until_ zeta "==" 4
say "ζ = 4"

# ---- keys
xdotool mousemove "$(field_x 50)" "$(field_y 20)" key space
until_ playing "==" false
sleep 0.5
at=$(value step)
sleep 0.5
[ "$(value step)" = "$at" ] || fail "it steps while paused"
until_seen '"event":"rest"'
say "the window rests"
xdotool key period
until_ step "==" $((at + 1))
say "pause and single step"
click play
until_ step ">" $((at + 5))
say "the play button"
xdotool key r
until_ run ">" 0
until_ total_density "<" 0.01
say "reset"

# ---- lanes
click comparison
click comparison=thesis-five
until_ lanes "==" 5
for k in 1 2 3 4 5; do until_ total_density_$k "<" 0.01; done
drag 1 30 70 60 50
for k in 1 2 3 4 5; do until_ total_density_$k ">" 1; done
say "one drag goes into all of the thesis' five"
click compare=wipe
click compare=difference
click lane-title=1
click lane-duplicate
until_ lanes "==" 6
say "another lane, while two are compared under a line"

# ---- a picture brings its run back
xdotool mousemove "$(field_x 50)" "$(field_y 5)" key space
until_ playing "==" false
sleep 0.5
xdotool mousemove "$(field_x 50)" "$(field_y 5)" key F12
until_seen 'whorl-0001.png"'
at=$(value step)
xdotool key Home
until_ step "==" 0
say "Home goes back to the start"
xdotool key ctrl+o
click open-path
xdotool type --delay 50 nowhere.png
xdotool key Return
until_seen '"event":"opened-failed"'
xdotool key Escape sleep 0.3 key ctrl+o
click open-path
xdotool type --delay 50 whorl-0001.png
xdotool key Return
until_seen '"event":"opened"'
until_seen '"event":"replayed","text":"same"'
until_ step "==" "$at"
[ "$(value playing)" = false ] || fail "the opened run plays"
xdotool mousemove "$(field_x 50)" "$(field_y 5)" key F12
until_seen 'whorl-0002.png"'
"$check_picture" whorl-0001.png >"$work/first" && "$check_picture" whorl-0002.png >"$work/second" || fail "no pictures"
cmp "$work/first" "$work/second" || fail "the picture of the opened run differs"
grep -q digest "$work/first" || fail "the picture holds no digest"
say "a picture opened again is the same picture"
"$whorl" run whorl-0001.png --threads 1 >"$work/replay" 2>&1 || fail "$(cat "$work/replay")"
grep -q "the same bits as were recorded" "$work/replay" || fail "$(cat "$work/replay")"
say "without a window it has the same bits"

xdotool mousemove "$(part panel=Lanes x)" "$(part panel=Lanes y)" click --repeat 60 --delay 10 5 sleep 0.3
click lab=stencil
until_seen '"key":"lab-window=stencil"'
xdotool key Escape
sleep 0.5
before=$(value brush_radius)
xdotool mousemove "$(part lab-window=stencil x)" "$(part lab-window=stencil y)" sleep 0.3 click 4
until_ brush_radius ">" "$before"
xdotool mousemove "$(part lab=stencil x)" "$(part lab=stencil y)" click --repeat 60 --delay 10 4 sleep 0.3
say "Esc closes a lab, and the field below takes the wheel again"

click comparison
click comparison=one
until_ lanes "==" 1
xdotool mousemove "$(field_x 50)" "$(field_y 5)" key 1
until_ nx "==" 128
xdotool key space
until_ total_density ">" 0.5
say "the first preset"

# ---- a lesson of one's own
cat >own.toml <<'TOML'
whorl = 1
title = "Mine"
summary = "What I teach."
[[step]]
title = "Here"
text = "A line."
scene = "rotation"
run_to = 3
TOML
xdotool mousemove "$(field_x 50)" "$(field_y 5)" key ctrl+o
click open-path
xdotool type --delay 50 own.toml
xdotool key Return
until_seen '"event":"opened","text":"own.toml"'
until_ step "==" 3
until_ nx "==" 40
click lesson-all
click lesson=own.toml
until_ step "==" 3
click lesson-close
until_ nx "==" 128
say "a lesson from a file, and back to the run"

# ---- a picture of one lane
xdotool key F12
until_seen 'whorl-0003.png"'
"$check_picture" whorl-0003.png >"$work/picture" || fail "the picture cannot be read, or is empty"
grep -q -E "experiment = ['\"]plume['\"]" "$work/picture" || fail "the picture does not hold its scene"
say "a picture of $(head -1 "$work/picture") pixels"

rm -rf "$work/pictures"
xdotool key F12
until_seen '"event":"picture-failed"'
say "a picture that cannot be written says why"

# ---- the end
close_window
say "q quits"
