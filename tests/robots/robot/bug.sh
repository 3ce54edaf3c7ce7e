#!/bin/sh
# Tests BUG with the real drivers and the real host: each kind of robot, simulated behind a
# pseudo-terminal, drives in real time past three obstacles to its goal, and its recording must
# replay bit for bit. All three run at once, for three minutes. Prints `ok` or `FAIL` for each.
#
# usage: bug.sh FROBC EXAMPLES
set -eu
frobc=$1 examples=$2
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
. "$here/../run/within.sh"

# The times and outputs of a recording that also has inputs.
outputs () { # LOG
    awk -F, '
        NR == 1 { for (i = 1; i <= NF; i++) if (i == 1 || $i ~ /^out/) columns[++n] = i }
        { for (i = 1; i <= n; i++) printf "%s%s", $columns[i], i < n ? "," : "\n" }' "$1"
}

drive () { # ROBOT
    mkdir "$work/$1"
    "$frobc" serve --robot "$1" --world "$examples/bug/world.toml" --for 6min \
        --link "$work/$1/line" >"$work/$1/served" &
    server=$!
    for attempt in $(seq 200); do
        [ -e "$work/$1/line" ] && break
        sleep 0.05
    done
    "$frobc" run "$examples/bug/bug.frob" --robot "$1" --device "$work/$1/line" --for 5min \
        --exit-when-done --record "$work/$1/log.csv" >"$work/$1/summary" 2>"$work/$1/messages" || true
    kill "$server"
    wait "$server"
    "$frobc" trace "$examples/bug/bug.frob" --robot "$1" --input "$work/$1/log.csv" \
        >"$work/$1/again.csv"
    grep -q "^result: true" "$work/$1/summary" &&
        within connections 1 1 <"$work/$1/summary" &&
        within collisions 0 0 odometry_error_at_the_end 0 1 <"$work/$1/served" &&
        outputs "$work/$1/log.csv" | cmp - "$work/$1/again.csv"
}

one () { # ROBOT
    if drive "$1" >"$work/$1.said" 2>&1; then echo "ok BUG on a $1 behind its line"; else
        echo "FAIL BUG on a $1 behind its line"
        cat "$work/$1.said" "$work/$1/served" "$work/$1/summary" "$work/$1/messages"
        return 1
    fi
}

one pioneer & pioneer=$!
one scout & scout=$!
one create & create=$!
failed=0
for run in $pioneer $scout $create; do
    wait "$run" || failed=1
done
exit $failed
