#!/usr/bin/env bash
# Goes through a lesson as a student does, clicks cells, and reads the sums behind them.
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
click lesson=smear
until_ nx "!=" 32
click lesson-plots
click tab=Spectrum
click tab=Plots
click lessons
say "a look at the plots in the lesson's place"
pages=$("$whorl" lesson smear | grep -c -E '^[0-9]+\. ')
[ "$pages" -ge 4 ] || fail "the lesson has $pages steps"
for page in $(seq 2 "$pages"); do
    run=$(value run)
    click lesson-next
    until_ run ">" "$run"
done
for page in $(seq 2 "$pages"); do
    run=$(value run)
    click lesson-back
    until_ run ">" "$run"
done
until_ step "==" 1200 # that the first page shows
[ "$(value playing)" = false ] || fail "the lesson's run plays"
say "to the lesson's last page, and back to the first"

# ---- a cell, and the sum behind it
copied() { grep '"event":"copied"' "$trace" | tail -1 | sed -E 's/.*"text":"(.*)"\}/\1/'; }
cell() { copied | sed -E 's/^Density at \(([0-9]+), ([0-9]+)\).*/\1,\2/'; }
copy() {
    sleep 1 # the sum is that of the newest step
    local before
    before=$(grep -c '"event":"copied"' "$trace")
    click inspector-copy
    local end=$((SECONDS + patience))
    until [ "$(grep -c '"event":"copied"' "$trace")" -gt "$before" ]; do
        ((SECONDS < end)) || fail "nothing is copied"
        sleep 0.1
    done
    [[ $(cell) =~ ^[0-9]+,[0-9]+$ ]] || fail "copied: $(copied)"
}
# expect_explained RUN: what was copied is what the program says without a window of that run, step and cell.
expect_explained() {
    "$whorl" explain "$1" --at "$(value step)" --cell "$(cell)" >"$work/explained" || fail "explain failed"
    tr '\n' ' ' <"$work/explained" | grep -q -F "$(copied)" ||
        fail "the window says $(copied); explain says $(cat "$work/explained")"
}
xdotool mousemove "$(field_x 50)" "$(field_y 50)" key i
xdotool mousemove "$(field_x 60)" "$(field_y 60)" sleep 0.3 click 1
until_seen '"key":"inspector-value"'
copy
xdotool mousemove "$(field_x 60)" "$(field_y 5)" key ctrl+s
until_seen '"event":"run-saved"'
expect_explained whorl-0001.toml
say "a click on a curve shows the sum behind cell $(cell), as explain has it"
xdotool mousemove "$(field_x 60)" "$(field_y 5)" key i

# ---- back to one's own run, and a cell of it
click lesson-close
until_ nx "==" 32
until_ total_density ">" 1
until_ playing "==" true
say "closing the lessons gives the run back, which goes on"
xdotool mousemove "$(field_x 50)" "$(field_y 5)" key space
until_ playing "==" false
sleep 0.5
xdotool key i
xdotool mousemove "$(field_x 45)" "$(field_y 60)" sleep 0.3 click 1
copy
before=$(cell)
xdotool mousemove "$(field_x 50)" "$(field_y 5)" key ctrl+s
until_seen 'whorl-0002.toml'
expect_explained whorl-0002.toml
say "a click on the field shows the sum behind cell $before"

# It follows the run.
at=$(value step)
xdotool key shift+Right
xdotool key period
until_ step "==" $((at + 1))
copy
[ "$(cell)" != "$before" ] || fail "Shift and an arrow stay at $before"
expect_explained whorl-0002.toml
say "after a step, its neighbour's sum too"
close_window
