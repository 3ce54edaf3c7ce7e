#!/bin/sh
# Runs that are looked at: the cost of publishing an instant, beside the aim; and, where there
# is a browser, the time from a key on the page to what comes of it there. The argument is the
# folder to work in.
set -eu
here=tests/generated/bench/view
gcc -std=c99 -D_XOPEN_SOURCE=700 -O2 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror \
    -Iruntime/hosts/common "$here/publish.c" runtime/hosts/common/ring.c -o "$1/publish"
"$1/publish"
python=/usr/bin/python3
if test -x $python && test -x /usr/bin/chromedriver && $python -c 'import selenium' 2>/dev/null; then
    $python "$here/latency.py" "$PWD/_build/install/default/bin/frobc" 200
fi
