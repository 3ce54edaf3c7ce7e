#!/bin/sh
# documents.sh FOLDER: what there is to read, and the examples, into FOLDER, laid out as here, so
# that the links from page to page lead where they should. The library and the runtime are
# linked to where an installation has them: FOLDER is share/doc/frobc.
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
copy README.md compiler/README.md sim/README.md
copy docs/*.* docs/tutorial/*.* docs/how-to/*.* docs/explanation/*.*
copy $(find -L examples -type f ! -name 'dune*')
ln -sfn ../../frobc/stdlib "$to/stdlib"
ln -sfn ../../frobc/runtime "$to/runtime"
