#!/bin/sh
# Runs that are looked at: the cost of publishing an instant; and, where there is a browser, what it
# costs the host to be looked at, how late the page is, how long a recording of an hour takes to
# open and to go through, images with what is drawn on them, and a what-if. The argument is the folder
# to work in.
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
    $python $here/latency.py "$frobc" "$1" 300
    $python $here/jitter.py "$frobc" "$1" 3
    $python $here/hour.py "$frobc" "$1"
    $python $here/sees.py "$frobc" "$1"
    $python $here/what_if.py "$frobc" "$1" 20
fi
