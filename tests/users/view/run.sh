#!/bin/sh
# usage: run.sh TEST.py RUN.csv : runs one of the tests in this folder, if that is possible here.
set -eu
python=/usr/bin/python3 # Debian's, for its packages
test -x $python || python=python3
case $1 in
journey*.py) needed="selenium, websockets"; test -x /usr/bin/chromedriver || needed=chromium-driver ;;
*) needed=websockets ;;
esac
if ! $python -c "import $needed" 2>/dev/null; then
    echo "skipped: $1 needs $needed"
    exit 0
fi
exec $python "$1" "$(command -v frobc)" "$2" ../../../examples/bug/bug.frob pioneer
