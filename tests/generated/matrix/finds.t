The matrix detects differences: a run that stops before its last row, a step with a wrong dt, a
compiler warning, and a state that differs although the outputs are equal.

  $ cat > once.frob << 'END'
  > main :: SF Float Float
  > main = proc x -> x * 3 + 1
  > END
  $ cat > waited.frob << 'END'
  > main :: SF Float Float
  > main = proc x -> time () / 1[s] + x
  > END
  $ matrix () { sh ./run.sh ./emit.exe ../../../stdlib ../../../runtime 0 1 gcc-O0 "${1:-once.frob}"; }
  $ matrix
  ok gcc-O0: 2 modules
  $ cp runner.c whole.c
  $ sed -i 's/i < r->count; i++/i < r->count - 1; i++/' runner.c && matrix
  FAIL gcc-O0
  gcc-O0, once:
  once: recording 0: the output differs
  once: recording 1: the output differs
  once: recording 2: the output differs
  gcc-O0, once_single:
  once: recording 0: the output differs
  once: recording 1: the output differs
  once: recording 2: the output differs
  [1]
  $ cp whole.c runner.c
  $ sed -i 's/frob_whole_ns(dt)/(int64_t)(dt * 1e9)/' runner.c && matrix waited.frob | sed 's/recording [0-9]*/recording N/' | uniq
  FAIL gcc-O0
  gcc-O0, waited:
  waited: recording N: the output differs
  $ cp whole.c runner.c
  $ sed -i 's/(float)dt/2 * &/' runner.c && matrix waited.frob
  FAIL gcc-O0
  gcc-O0, waited_single:
  waited: recording 2: the output differs
  [1]
  $ sed -i 's/^int main(void)/int main(int argc, char **argv)/' runner.c && matrix 2>&1 | grep -c 'unused parameter'
  2
  $ cp whole.c runner.c
  $ cat > set.frob << 'END'
  > param k :: Float = 2
  > 
  > main :: SF Float Float
  > main = proc x -> k * x
  > END
  $ matrix set.frob
  ok gcc-O0: 2 modules
  $ sed -i 's/step(state, params,/step(state, program->default_params,/' runner.c && matrix set.frob | grep -v 'recording [12]'
  FAIL gcc-O0
  gcc-O0, set:
  set: recording 0: the output differs
  gcc-O0, set_single:
  set: recording 0: the output differs
  $ cp whole.c runner.c
  $ cat > kept.frob << 'END'
  > main :: SF Float Float
  > main = switch (proc x -> (delay 0 x, after 3600[s] ())) (\_ -> integral >>> arr (\x -> x / 1[s]))
  > END
  $ two () { sh ./run.sh ./emit.exe ../../../stdlib ../../../runtime 0 1 gcc-O0,gcc-O2 kept.frob; }
  $ two
  ok gcc-O0: 2 modules
  ok gcc-O2: 2 modules
  $ sed -i 's/^    free(buffer);$/#ifdef __OPTIMIZE__\n    ((unsigned char *)state)[3] ^= 1;\n    hash_state(state_hash, state);\n#endif\n&/' runner.c && two
  ok gcc-O0: 2 modules
  FAIL gcc-O2
  gcc-O2, kept: the state differs from that under gcc-O0
  gcc-O2, kept_single: the state differs from that under gcc-O0
  [1]
