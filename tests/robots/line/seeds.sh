#!/bin/sh
# Runs examples through each robot's driver and line, with many seeds of noise. They must reach the
# same goals as in the simulator; BUG must also do so if a USB adapter holds bytes back for 16 ms
# and a step takes 5 ms. Prints the seeds that are out of bounds.
#
# usage: seeds.sh FROBC FROB_LINE EXAMPLES COUNT
frobc=$1 line=$2 examples=$3 count=$4
. "$(dirname "$0")/../run/within.sh"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# frobc caches the shared objects that it builds; this one gets a separate cache.
compile () { # EXAMPLE ROBOT
  XDG_CACHE_HOME=$work/$1-$2 "$frobc" run "$examples/$1/$1.frob" --robot "$2" \
    --world "$examples/$1/world.toml" --for 10ms >"$work/said" || { cat "$work/said"; return 1; }
  echo "$work/$1-$2"/frobc/*.so
}

status=0
robots="pioneer scout create"
each () { # EXAMPLE SECONDS WAYS BOUNDS...
  example=$1 for_s=$2 ways=$3
  shift 3
  for robot in $robots; do
    program=$(compile "$example" "$robot") || exit 2
    failed=0
    for seed in $(seq 1 "$count"); do
      for way in $ways; do
        case $way in prompt) slow= ;; slow) slow="adapter=16 step=5" ;; esac
        "$line" "$program" "$robot" "$examples/$example/world.toml" "$seed" "$for_s" $slow |
          within connections 1 1 stale_readings 0 0 collisions 0 0 "$@" ||
          { echo "$example on a $robot, seed $seed, $way"; failed=$((failed + 1)); }
      done
    done
    echo "$example on a $robot behind its line: $failed runs out of bounds"
    [ "$failed" -eq 0 ] || status=1
  done
}
each bug 360 "prompt slow" result true true odometry_error_at_the_end 0 1
each wall_follow 60 prompt mean_wall_distance_error 0 0.03 largest_wall_distance_error 0 0.2
robots=create # with sensors that look down
each line_follow 220 "prompt slow" mean_distance_from_the_tape 0 0.01 largest_distance_from_the_tape 0 0.04 distance_along_the_tape 45 50
exit $status
