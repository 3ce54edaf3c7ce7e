#!/bin/sh
# targets.sh [TARGET...]: runs these targets of the Makefile, or all, in a short form that checks
# that they work, and prints a line for each. Writes their output to _build/targets.
#
# targets.sh --list: lists the targets with the settings that make them short.
set -u
cd "$(dirname "$0")/.." || exit 1
out=$PWD/_build/targets

# Omits `test`, which runs on its own; `all` and `setup`, which are parts of other targets; and
# `clean`, which would remove their results.
short_forms() {
    cat <<END
run
fmt
fuzz N=40
fuzz-format N=40
fuzz-lsp N=40
fuzz-drivers BYTES=200000
soak SECONDS=2 SEEDS=2
kills KILLS=2
elementary STEP=1000003
faults N=2
seeds SEEDS=1 SHORT=1
mutants MUTANTS=1 MUTANT_PROGRAMS=200
install PREFIX=$out/prefix
deb
slurm
prove PROGRAMS=examples/wall_follow/wall_follow.frob
bench SHORT=1
matrix N=10
fuzz-frontend SECONDS=20
test-clients
vsix
page
site
pictures PAGES=docs/tutorial/first-drive.md PICTURES=$out/pictures
rtamt N=50
falsify TRIES=1
mcap
ros
ros-figures
wheel
python
install-check BARE_SUITES=bookworm
wheel-arm SHORT=1
release SHORT=1 BARE_SUITES=bookworm
photographs
END
}

if [ "${1:-}" = --list ]; then
    short_forms
    exit 0
fi

mkdir -p "$out"
passed=0 failed=0
for target in ${*:-$(short_forms | cut -d ' ' -f 1)}; do
    form=$(short_forms | grep "^$target\( \|\$\)") ||
        { echo "FAIL $target: add a short form of it to tests/targets.sh"; failed=$((failed + 1)); continue; }
    begun=$(date +%s)
    # shellcheck disable=SC2086
    if make $form >"$out/$target.log" 2>&1 </dev/null; then
        echo "ok   make $form: $(($(date +%s) - begun)) s"
        passed=$((passed + 1))
    else
        echo "FAIL make $form: see _build/targets/$target.log, whose last lines are"
        tail -n 5 "$out/$target.log" | sed 's/^/     /'
        failed=$((failed + 1))
    fi
done
echo "$passed passed, $failed failed"
[ $failed -eq 0 ]
