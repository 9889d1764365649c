#!/usr/bin/env bash
# Goes through a lesson as a student does, clicks a cell, and reads the sum behind it.
# usage: lesson_test.sh WHORL
set -u
whorl=$1
. "$(dirname "$0")/person.sh"

open_screen 1024 768
mkdir "$work/files"
cd "$work/files" || exit 1
open_window empty --set resolution=32 --size 1024x768 --no-tour
until_ step ">" 5
xdotool mousemove "$(field_x 50)" "$(field_y 50)"
drag 1 30 70 60 50
until_ total_density ">" 1
say "a run of one's own"

# ---- through a lesson
xdotool key l
click lesson=aslam
until_ nx "!=" 32
pages=$("$whorl" lesson aslam | grep -c -E '^[0-9]+\. ')
[ "$pages" -ge 4 ] || fail "the lesson has $pages steps"
for page in $(seq 2 "$pages"); do
    run=$(value run)
    click lesson-next
    until_ run ">" "$run"
done
run=$(value run)
click lesson-back
until_ run ">" "$run"
sleep 0.5
say "to the lesson's last page, and one back"

# ---- a cell, and the sum behind it
[ "$(value playing)" = false ] || fail "the lesson's run plays"
xdotool mousemove "$(field_x 50)" "$(field_y 50)" key i
click_field() { xdotool mousemove "$(field_x "$1")" "$(field_y "$2")" sleep 0.3 click 1; }
click_field 40 60
until_seen '"key":"inspector-value"'
click inspector-copy
until_seen '"event":"copied"'
say "a click on a cell shows its sum"

# What it says is what the program says without a window, of the same run, step and cell.
xdotool mousemove "$(field_x 50)" "$(field_y 5)" key ctrl+s
until_seen '"event":"run-saved"'
copied() { grep '"event":"copied"' "$trace" | tail -1 | sed -E 's/.*"text":"(.*)"\}/\1/'; }
cell() { copied | sed -E 's/^Density at \(([0-9]+), ([0-9]+)\).*/\1,\2/'; }
[[ $(cell) =~ ^[0-9]+,[0-9]+$ ]] || fail "copied: $(copied)"
"$whorl" explain whorl-0001.toml --at "$(value step)" --cell "$(cell)" >"$work/explained" || fail "explain failed"
tr '\n' ' ' <"$work/explained" | grep -q -F "$(copied)" || fail "the window says $(copied); explain says $(cat "$work/explained")"
say "it is what explain says of cell $(cell) at step $(value step)"

# It follows the run.
before=$(cell)
xdotool key shift+Right
at=$(value step)
xdotool key period
until_ step "==" $((at + 1))
sleep 0.5
click inspector-copy
sleep 0.5
[ "$(cell)" != "$before" ] || fail "Shift and an arrow stay at $before"
"$whorl" explain whorl-0001.toml --at $((at + 1)) --cell "$(cell)" >"$work/explained" || fail "explain failed"
tr '\n' ' ' <"$work/explained" | grep -q -F "$(copied)" || fail "after a step the window says $(copied)"
say "after a step, its neighbour's sum too"
xdotool mousemove "$(field_x 50)" "$(field_y 50)" key i
sleep 0.5

# ---- back to one's own run
click lesson-close
until_ nx "==" 32
until_ total_density ">" 1
say "closing the lessons gives the run back"
close_window
