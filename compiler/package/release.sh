#!/bin/sh
# release.sh BUILD: collects the files of a release in BUILD/release, from the committed sources:
# the wheel, the Debian packages frobc and frobc-doc, the documentation as a website, the changes of
# this version, and the checksums of these files. Builds everything twice from nothing, and
# compares the results byte for byte. Both passes use the same folder, because the debugging
# information, and with it the build ID of a program, contains its path. Publishes nothing. Run it
# in the top folder of the project, after `make`, which installs the packages that the build needs.
# With SHORT=1, both passes use the program in BUILD/install, so only the packaging is repeated.
set -eu
top=$PWD
build=$(cd "$1" && pwd)
release=$build/release
version=$(sed -n 's/^(version \(.*\))$/\1/p' dune-project)

changes() { awk -v start="## [$version]" 'index($0, start) == 1 { on = 1 } on && /^## / && index($0, start) != 1 { exit } on' CHANGELOG.md; }
[ -n "$(changes)" ] || { echo "release.sh: CHANGELOG.md has no section ## [$version]" >&2; exit 1; }
if ! git diff --quiet HEAD 2>/dev/null; then
    echo "release.sh: warning: uncommitted changes are not part of the release" >&2
fi

# The time of the newest commit, for the files of archives.
SOURCE_DATE_EPOCH=$(git log -1 --format=%ct)
export SOURCE_DATE_EPOCH
export TZ=UTC LC_ALL=C.UTF-8
umask 022

rm -rf "$build/release-1" "$build/release-2" "$release"
one_pass() { # NUMBER
    pass=$build/release-pass
    rm -rf "$pass"
    mkdir -p "$pass/out" "$pass/sources"
    git archive HEAD | tar -x -C "$pass/sources"
    cd "$pass/sources"
    if [ -n "${SHORT:-}" ]; then
        mkdir _build
        cp -RL "$build/install" _build/install
    else
        dune build -p frobc @install 2>"$pass/build.log" || { tail "$pass/build.log" >&2; exit 1; }
    fi
    # Both passes use the same tools from PyPI.
    ln -s "$build/wheel-tools" _build/wheel-tools
    sh runtime/python/wheel.sh "$PWD/_build" >"$pass/wheel.log"
    cp _build/wheel/frobc-*.whl "$pass/out"
    sh compiler/package/deb.sh _build/install/default "$pass/out" >"$pass/deb.log"
    python3 -B docs/site/build.py . "$PWD/_build/install/default/bin/frobc" _build/site-pages >"$pass/site.log"
    "$build/site-tools/bin/mkdocs" build --quiet --config-file docs/site/mkdocs.yml >>"$pass/site.log" 2>&1
    # These contain the time of the build.
    rm -f _build/site/sitemap.xml _build/site/sitemap.xml.gz
    tar --sort=name --owner=0 --group=0 --numeric-owner --mtime="@$SOURCE_DATE_EPOCH" \
        -C _build --transform "s|^site|frobc-$version-site|" -cf - site | gzip -9n >"$pass/out/frobc-$version-site.tar.gz"
    changes >"$pass/out/CHANGES-$version.md"
    cd "$pass/out"
    sha256sum -- * >SHA256SUMS
    cd "$top"
    mkdir "$build/release-$1"
    mv "$pass/out" "$build/release-$1/out"
    rm -rf "$pass"
}

[ -x "$build/wheel-tools/bin/auditwheel" ] || { echo "release.sh: run make wheel first" >&2; exit 1; }
[ -x "$build/site-tools/bin/mkdocs" ] || { echo "release.sh: run make site first" >&2; exit 1; }
for number in 1 2; do
    echo "building the release, pass $number of 2"
    (one_pass "$number")
done
if ! diff "$build/release-1/out/SHA256SUMS" "$build/release-2/out/SHA256SUMS"; then
    echo "release.sh: the two passes differ; they are in $build/release-1/out and release-2/out" >&2
    exit 1
fi
mv "$build/release-1/out" "$release"
rm -rf "$build/release-1" "$build/release-2"
echo "both passes are equal; the release is in $release:"
(cd "$release" && ls)
