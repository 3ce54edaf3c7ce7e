#!/bin/sh
# usage: bundle.sh PAGE : checks that PAGE/bundle is up to date with the sources in PAGE.
set -eu
if ! command -v npm >/dev/null || ! command -v node >/dev/null; then
    echo "skipped: the page is not built again without npm"
    exit 0
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
if ! (mkdir "$work/packages" && cd "$1" && cp package.json package-lock.json "$work/packages" &&
    cd "$work/packages" && npm ci --silent --no-audit --no-fund) >"$work/log" 2>&1; then
    echo "skipped: the page is not built again, as npm has no packages for it:"
    tail -n 3 "$work/log"
    exit 0
fi
sh "$1/build.sh" "$work/packages" "$work/bundle" 2>"$work/log" || { cat "$work/log"; exit 1; }
for file in "$work"/bundle/*; do
    name=$(basename "$file")
    if cmp -s "$file" "$1/bundle/$name"; then
        echo "ok bundle/$name is up to date with its sources"
    else
        echo "FAIL bundle/$name is out of date: run make page"
        failed=1
    fi
done
exit ${failed:-0}
