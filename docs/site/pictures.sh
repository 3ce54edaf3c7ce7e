#!/bin/sh
# pictures.sh PAGE.md…: does what the pages tell their readers to do (see
# tests/documents/pages), and puts the pictures that they show beside them, smaller. One of
# a run in real time (real-robot.md) is another each time.
set -eu
here=$(dirname "$0")
out=$here/../../_build/pages
for page in "$@"; do
    name=$(basename "$page" .md)
    awk -v pages="$out" -f "$here/../../tests/documents/pages/page.awk" "$page" >"$out.page"
    cmp -s "$page" "$out.page" || echo "$page: other things were printed than it shows" >&2
    grep -oE '^!\[[^]]*\]\([^)]*\.(png|svg)\)' "$page" | sed 's/.*(//; s/)$//' | while read -r picture; do
        case $picture in
            */*) continue ;; # of another page
            *.png) convert "$out/$name/$picture" -resize 800x -dither None -colors 64 -strip \
                "PNG8:$(dirname "$page")/$picture" ;;
            *.svg) cp "$out/$name/$picture" "$(dirname "$page")/$picture" ;;
        esac
        echo "$(dirname "$page")/$picture"
    done
done
