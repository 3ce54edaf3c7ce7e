#!/bin/sh
# usage: run.sh FROBC FOLDER : reads recordings in MCAP format with third-party packages: Python's
# mcap and, if npm is installed, @mcap/core. Installs them in FOLDER.
set -eu
frobc=$1
here=$PWD/tests/users/convert/readers
examples=$PWD/examples
mkdir -p "$2"
cd "$2"
test -x venv/bin/python || { python3 -m venv venv && venv/bin/pip install --quiet mcap==1.6.0 jsonschema; }
if command -v npm > /dev/null; then
    test -d node_modules/@mcap/core ||
        npm install --silent --no-save --no-audit --no-fund @mcap/core@2.2.2
    cp "$here/read.mjs" .
else
    echo "     (without npm, so not by @mcap/core)"
fi
for program in wall_follow follow_ball; do
    "$frobc" run "$examples/$program/$program.frob" --for 5s --record $program.csv > summary
    "$frobc" convert $program.csv $program.mcap
    venv/bin/python "$here/read.py" $program.mcap $program.csv
    ! test -f read.mjs || node read.mjs $program.mcap
done
