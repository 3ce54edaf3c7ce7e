# Runs in a bare system as an ordinary user: the two commands of README.md, then others that should
# work without a C compiler.
set -eu
cd
LANG=C.UTF-8
export LANG
pip_options="--quiet --disable-pip-version-check --no-index --find-links /index"

began=$(date +%s)
python3 -m venv frob && frob/bin/pip install $pip_options frobc
frob/bin/frobc demo >demo.txt
seconds=$(($(date +%s) - began))
grep -q '^collisions: 0$' demo.txt
grep '^distance driven' demo.txt
echo "from nothing to a driven robot: $seconds s, with Python $(python3 -c 'import platform; print(platform.python_version())')"
[ "$seconds" -lt "$LIMIT" ]

PATH=$HOME/frob/bin:$PATH
frobc selftest >selftest.txt
tail -n 1 selftest.txt
frobc test frob-demo | tail -n 1
frobc trace frob-demo/wall_follow.frob --input frob-demo/run.csv --output trace.csv
cut -d , -f 1 frob-demo/run.csv | cmp - "$(cut -d , -f 1 trace.csv >times && echo times)"
frobc view --print frob-demo/run.csv frob-demo/wall_follow.frob >view.txt &
viewer=$!
python3 /page.py view.txt
kill "$viewer"
python -c '
import frob
program = frob.compile("frob-demo/wall_follow.frob")
print("from Python:", type(program).__name__)'

# Commands that use Python packages, outside of the virtual environment.
PIP_NO_INDEX=1 PIP_FIND_LINKS=/index
export PIP_NO_INDEX PIP_FIND_LINKS
cat >cruise.frob <<'END'
main :: SF Float Float
main = proc x -> x where
    assert "small" (x < 2)
END
! frobc falsify cruise.frob --input "in=0 to 3" --for 1s 2>told
grep -q 'frobc extras install search' told
frobc extras install search mcap
frobc falsify cruise.frob --input "in=0 to 3" --for 1s | head -n 1
python3 /foreign.py foreign.mcap
frobc convert foreign.mcap foreign.csv
cat foreign.csv
frobc doctor
