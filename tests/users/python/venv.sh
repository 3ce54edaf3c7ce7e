#!/bin/sh
# usage: venv.sh BUILD : installs the wheel in BUILD/wheel in new virtual environments, as a user
# would, without frobc on PATH: first without numpy, then with its optional packages from PyPI. Run
# it in the top folder of the project.
set -eu
build=$1
here=$PWD
clean() { env -u FROBC -u FROB_HOME -u PYTHONPATH PATH=/usr/bin:/bin PYTHONDONTWRITEBYTECODE=1 "$@"; }
pip() { "$environment/bin/pip" install --quiet --disable-pip-version-check "$@"; }
work=$build/python-work
rm -rf "$work" && mkdir -p "$work"
cp tests/users/python/*.py "$work"

environment=$build/python-alone
rm -rf "$environment"
/usr/bin/python3 -m venv "$environment"
pip "$build"/wheel/frobc-*.whl
(cd "$work" && clean "$environment/bin/python" alone.py)

environment=$build/python-test
test -x "$environment/bin/python" || /usr/bin/python3 -m venv "$environment"
echo "Installing in $environment, from PyPI: numpy, pandas, pandas-stubs, gymnasium, mypy, nbclient"
pip numpy pandas pandas-stubs gymnasium mypy nbclient ipykernel
pip --force-reinstall --no-deps "$build"/wheel/frobc-*.whl
for test in test_program.py test_simulation.py test_gym.py test_sweep.py; do
    (cd "$work" && FROB_ROOT=$here clean "$environment/bin/python" -W error "$test")
done
(cd "$work" && FROB_ROOT=$here clean "$environment/bin/python" test_notebook.py)
if pip distributed; then
    (cd "$work" && clean "$environment/bin/python" test_cluster.py)
else
    echo "ok   sweeps on a Dask cluster (skipped: distributed cannot be had from PyPI)"
fi
"$environment/bin/mypy" --config-file runtime/python/pyproject.toml --cache-dir "$work/mypy" \
    runtime/python/frob && echo "ok   the package's types, by mypy"
grep -n '# wrong$' "$work/typed.py" | sed 's/^/typed.py:/; s/:[^:]*$/: error/' >"$work/typed.wrong"
(cd "$work" && "$environment/bin/mypy" --strict --cache-dir mypy typed.py) >"$work/typed.told" || true
grep -o '^typed.py:[0-9]*: error' "$work/typed.told" | sort -u | diff "$work/typed.wrong" - ||
    { cat "$work/typed.told"; exit 1; }
echo "ok   a user's types, by mypy"
