#!/bin/sh
# documents.sh FOLDER: copies the documentation and the examples to FOLDER, with the same layout as
# in this repository, so that links between pages work. FOLDER must be share/doc/frobc of an
# installation: the library and the runtime become symbolic links to their installed folders. A
# link to a file that is not installed, such as a source of the compiler, becomes plain text with
# its path.
set -eu
mkdir -p "$1"
to=$(cd "$1" && pwd)
cd "$(dirname "$0")/../.."
copy() { # FILE…, from the top
    for file in "$@"; do
        mkdir -p "$to/$(dirname "$file")"
        cp "$file" "$to/$file"
    done
}
copy README.md CHANGELOG.md compiler/README.md sim/README.md
copy docs/*.* docs/decisions/*.* docs/tutorial/*.* docs/how-to/*.* docs/explanation/*.*
copy $(find -L examples -type f ! -name 'dune*')
ln -sfn ../../frobc/stdlib "$to/stdlib"
ln -sfn ../../frobc/runtime "$to/runtime"

cd "$to"
find . -name '*.md' | while read -r page; do
    awk -v folder="$(dirname "$page")" '
        /^ *```/ { code = !code }
        code { print; next }
        {
            done = ""
            while (match($0, /\[[^]]*\]\([^):# ]+[^): ]*\)/)) {
                link = substr($0, RSTART, RLENGTH)
                done = done substr($0, 1, RSTART - 1) checked(link)
                $0 = substr($0, RSTART + RLENGTH)
            }
            print done $0
        }
        function checked(link,    text, path) {
            text = path = link
            sub(/\]\(.*/, "", text)
            sub(/^\[/, "", text)
            sub(/.*\]\(/, "", path)
            sub(/[#)].*/, "", path)
            path = folder "/" path
            if (system("test -e \047" path "\047") == 0) return link
            while (sub(/[^\/.]+\/\.\.\//, "", path)) { }
            sub(/^\.\//, "", path)
            return index(text, path) ? text : text " (`" path "` of the sources)"
        }' "$page" > "$page.new"
    mv "$page.new" "$page"
done
