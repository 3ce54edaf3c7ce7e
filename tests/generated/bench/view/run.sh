#!/bin/sh
# Measures live runs in the viewer: the cost of publishing an instant; and, if there is a browser,
# how much a viewer slows down the host, the delay of the page, the time to open and to search a
# recording of an hour, images with overlays, and a what-if. The argument is the working folder.
set -eu
here=tests/generated/bench/view
common=runtime/hosts/common
build() {
    gcc -std=c99 -D_GNU_SOURCE -O2 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror \
        -Iruntime/include -I$common "$@"
}
build $here/publish.c $common/ring.c -o "$1/publish"
"$1/publish"
build $here/clock_host.c $common/load.c $common/publisher.c $common/ring.c $common/frames.c \
    runtime/core/camera.c runtime/core/frame.c -ldl -o "$1/clock_host"
python=/usr/bin/python3
frobc=$PWD/_build/install/default/bin/frobc
if test -x $python && test -x /usr/bin/chromedriver &&
    $python -c 'import selenium, websockets' 2>/dev/null; then
    if test -z "${SHORT:-}"; then times=300 rounds=3 lasts=3600 tries=20; else times=5 rounds=1 lasts=60 tries=2; fi
    $python $here/latency.py "$frobc" "$1" $times
    $python $here/jitter.py "$frobc" "$1" $rounds
    $python $here/hour.py "$frobc" "$1" $lasts
    $python $here/loading.py "$frobc"
    if test -z "${SHORT:-}"; then $python $here/speed.py "$frobc"; fi
    $python $here/sees.py "$frobc" "$1"
    $python $here/what_if.py "$frobc" "$1" $tries
fi
