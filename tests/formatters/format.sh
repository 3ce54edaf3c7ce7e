#!/bin/sh
# format.sh [--check]: formats all sources in place, each language with its formatter from
# _build/formatters. With --check it changes nothing; it prints a line for each language, as the
# tests do: `ok`, `FAIL` with the files whose format differs, or `skipped` with the missing
# formatter.
set -u
cd "$(dirname "$0")/../.." || exit 1
. tests/formatters/versions.sh
tools=_build/formatters
check=${1:-}
failed=0

# Lists the tracked files with these extensions. Excludes files that frobc generates, such as the
# headers of robots and golden files: tests compare them byte for byte with the compiler's output.
sources() {
    if [ -e .git ]; then git ls-files "$@"; else
        for pattern in "$@"; do find . -path ./_build -prune -o -name "$pattern" -print; done
    fi | grep -v -e '/golden/' -e '/bundle/' -e 'include/frob/\(pioneer\|scout\|create\|ros\).h$'
}

# format NAME VERSION 'WRITE COMMAND' 'CHECK COMMAND' PATTERN...
# The check command gets files as arguments and prints those whose format differs.
format() {
    name=$1 version=$2 write=$3 verify=$4
    shift 4
    case $("$tools/$name" --version 2>/dev/null) in
        *"$version"*) ;;
        *)
            echo "skipped: the format of $*, because $name $version is missing (make fmt installs it)"
            return
            ;;
    esac
    if [ "$check" != --check ]; then
        sources "$@" | xargs -P "$(nproc)" -n 40 sh -c "$write" sh || failed=1
        return
    fi
    differ=$(sources "$@" | xargs -P "$(nproc)" -n 40 sh -c "$verify" sh 2>/dev/null)
    if [ -z "$differ" ]; then
        echo "ok $name: $(sources "$@" | wc -l) files"
    else
        echo "FAIL $name would change these files (make fmt formats them): $(echo $differ)"
        failed=1
    fi
}

format ocamlformat "$OCAMLFORMAT" "$tools/ocamlformat --inplace \"\$@\"" \
    "$tools/ocamlformat --check \"\$@\" ||
     for f in \"\$@\"; do $tools/ocamlformat --check \"\$f\" || echo \"\$f\"; done" \
    '*.ml' '*.mli'
format clang-format "$CLANG_FORMAT" "$tools/clang-format -i \"\$@\"" \
    "$tools/clang-format --dry-run -Werror \"\$@\" 2>&1 | sed -n 's/:[0-9:]* error: .*//p' | sort -u" \
    '*.c' '*.h' '*.cc'
format ruff "$RUFF" "$tools/ruff format --no-cache --line-length 100 --quiet \"\$@\"" \
    "$tools/ruff format --no-cache --line-length 100 --check \"\$@\" | sed -n 's/^Would reformat: //p'" '*.py'
format prettier "$PRETTIER" "$tools/prettier --print-width 100 --log-level error --write \"\$@\"" \
    "$tools/prettier --print-width 100 --list-different \"\$@\"" '*.ts' '*.mjs' '*.js' '*.css'
exit $failed
