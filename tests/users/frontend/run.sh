#!/bin/sh
# run.sh HARNESS STDLIB SECONDS: runs afl-fuzz on the compiler, starting from all programs in the
# repository. Prints the inputs that broke it, and the number of inputs tried; the exit status is 1
# if any input broke it.
set -u
harness=$1 library=$2 seconds=$3
cd "$(dirname "$0")/../../.." || exit 1
work=_build/fuzz-frontend
rm -rf "$work"
mkdir -p "$work/corpus"

# Small programs, each once; and those in the explanations of diagnostics.
n=0
for program in $(find tests examples stdlib -name '*.frob' -size -5k); do
    n=$((n + 1))
    cp "$program" "$work/corpus/$n.frob"
done
for page in compiler/explain/*/*.md; do
    awk -v to="$work/corpus/$(basename "$page" .md)" '
        /^```frob/ { file = to "." ++n ".frob"; next }
        /^```$/    { file = "" }
        file       { print > file }' "$page"
done

export AFL_SKIP_CPUFREQ=1 AFL_I_DONT_CARE_ABOUT_MISSING_CRASHES=1 AFL_NO_UI=1 AFL_NO_AFFINITY=1 AFL_FAST_CAL=1
# A long limit, so that a busy machine does not look like a hang.
export AFL_HANG_TMOUT=20000
afl-fuzz -i "$work/corpus" -o "$work/out" -x tests/users/frontend/words -t 10000 -m 2000 -V "$seconds" \
    -- "$harness" "$library" @@ >"$work/log" 2>&1
stats=$work/out/default/fuzzer_stats
[ -f "$stats" ] || { tail -n 30 "$work/log" >&2; exit 1; }
value() { sed -n "s/^$1 *: *//p" "$stats"; }
crashes=$(find "$work/out/default/crashes" "$work/out/default/hangs" -name 'id*' | sort)
[ -z "$crashes" ] || printf 'FAIL %s\n' $crashes
echo "$(value execs_done) inputs in $(value run_time) s, $(value corpus_count) with something new: $(value saved_crashes) exceptions, $(value saved_hangs) hangs"
[ -z "$crashes" ]
