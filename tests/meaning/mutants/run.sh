#!/bin/sh
# run.sh COUNT SEED [NUMBER...]: tests the random programs themselves. Plants each fault of
# tests/meaning/mutants/list (or those with these numbers) into a copy of the compiler, and checks
# that the random programs of tests/meaning/fuzz detect it within COUNT programs. Prints a table;
# the exit status is 1 if a fault survives, no longer applies or does not build. If a fault makes a
# program run forever, it counts as found.
set -u
cd "$(dirname "$0")/../../.." || exit 1
count=$1 seed=$2
shift 2
here=$(pwd)
list=tests/meaning/mutants/list
work=$here/_build/mutants
tree=$work/tree
[ $# -gt 0 ] || set -- $(seq "$(awk -v count=1 -f tests/meaning/mutants/apply.awk $list)")

fresh() {
    for part in compiler stdlib runtime tests/meaning/fuzz; do
        mkdir -p "$tree/$(dirname $part)"
        rm -rf "${tree:?}/$part"
        cp -Rp $part "$tree/$part"
    done
    cp -p dune dune-project frobc.opam "$tree/"
}

# Only the last changed file gets a new modification time, so that dune rebuilds little.
build() { dune build --root "$tree" ./tests/meaning/fuzz/main.exe >"$work/build" 2>&1; }

mkdir -p "$work"
rm -rf "${tree:?}/compiler"
fresh
build || { cat "$work/build"; exit 1; }

survivors=0 broken=0 found=0
printf '%3s  %-34s  %-10s  %s\n' '' file 'found after' fault
for number in "$@"; do
    if ! line=$(awk -v number="$number" -v tree="$tree" -f tests/meaning/mutants/apply.awk $list); then
        broken=$((broken + 1))
        continue
    fi
    file=${line%%	*} name=${line#*	}
    if ! build; then
        verdict='not built'
        broken=$((broken + 1))
        tail -n 12 "$work/build" >&2
    elif timeout $((300 + count)) "$tree/_build/default/tests/meaning/fuzz/main.exe" --count "$count" --seed "$seed" --stop-at-first \
        --runtime "$tree/runtime" --jobs "$(nproc)" >"$work/programs" 2>&1; then
        verdict=SURVIVED
        survivors=$((survivors + 1))
    elif [ $? -eq 124 ]; then
        verdict='a hang'
        found=$((found + 1))
    else
        verdict=$(sed -n 's/^FAIL \([0-9]*\) random programs.*/\1/p' "$work/programs")
        verdict=${verdict:-a crash}
        found=$((found + 1))
    fi
    printf '%3d  %-34s  %-10s  %s\n' "$number" "${file#compiler/}" "$verdict" "$name"
    cp -p "$file" "$tree/$file"
done
echo "$found of $# faults found within $count programs of seed $seed, $survivors survived, $broken could not be tried"
[ $survivors -eq 0 ] && [ $broken -eq 0 ]
