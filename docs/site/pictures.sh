#!/bin/sh
# pictures.sh PAGE.md…: follows the pages as their readers would (see tests/documents/pages),
# and writes smaller copies of the resulting pictures to the pages' folders. The picture of a
# run in real time (real-robot.md) differs each time.
set -eu
to=${PICTURES:-.} # replaces the folder that contains docs/
here=$(dirname "$0")
out=$here/../../_build/pages
for page in "$@"; do
    name=$(basename "$page" .md)
    awk -v pages="$out" -f "$here/../../tests/documents/pages/page.awk" "$page" >"$out.page"
    cmp -s "$page" "$out.page" || echo "$page: the printed output differs from the page" >&2
    grep -oE '^!\[[^]]*\]\([^)]*\.(png|svg)\)' "$page" | sed 's/.*(//; s/)$//' | while read -r picture; do
        mkdir -p "$to/$(dirname "$page")"
        case $picture in
            */*) continue ;; # belongs to another page
            *.png) convert "$out/$name/$picture" -resize 800x -dither None -colors 64 -strip \
                "PNG8:$to/$(dirname "$page")/$picture" ;;
            *.svg) cp "$out/$name/$picture" "$to/$(dirname "$page")/$picture" ;;
        esac
        echo "$to/$(dirname "$page")/$picture"
    done
done
