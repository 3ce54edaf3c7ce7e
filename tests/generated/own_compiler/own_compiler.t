frobc comes with a C compiler, frob-tcc, for computers that have no other one. It is based on
libtcc. Without a compiler on PATH, frobc uses it:

  $ frobc=$(command -v frobc); mkdir none
  $ alone() { env -u CC PATH=$PWD/none "$frobc" "$@"; }
  $ alone selftest | sed 's|/.*/lib/frobc/|LIB/|'
  compiler: LIB/frob-tcc -std=c99 -O2 -ffp-contract=off
  arithmetic: correct
  numbers: correct
  functions: correct
  time: correct
  data: correct
  arrays: correct
  switches: correct
  tasks: correct
  rounds: correct
  foreign: correct
  verdict: fit
  $ alone selftest --real float | tail -n 1
  verdict: fit

An example in the simulator has the same log, bit for bit, as when gcc compiles it. This includes
programs with cameras, whose kernels gcc compiled when frobc was built.

  $ drive() { # NAME
  >   set -- run ../../../examples/$1/$1.frob --world ../../../examples/$1/world.toml --for 3s --seed 1
  >   CC=gcc frobc "$@" --record gcc.csv >/dev/null && alone "$@" --record alone.csv >/dev/null &&
  >     cmp gcc.csv alone.csv && echo equal
  > }
  $ for name in wall_follow bug patrol explore dock subsumption dock_tag line_by_camera corridor_stereo; do
  >   echo "$name: $(drive $name)"; done
  wall_follow: equal
  bug: equal
  patrol: equal
  explore: equal
  dock: equal
  subsumption: equal
  dock_tag: equal
  line_by_camera: equal
  corridor_stereo: equal

`frobc test` reports the same results:

  $ CC=gcc frobc test ../../../examples/bug/bug.test.frob > gcc.out 2>&1
  $ alone test ../../../examples/bug/bug.test.frob > alone.out 2>&1
  $ cmp gcc.out alone.out

The executable for a robot works too.

  $ alone build ../../../examples/wall_follow/wall_follow.frob -o wall_follow
  $ ./wall_follow --device /dev/null
  error: /dev/null is not a serial line
  [2]

frob-tcc does not compile your own C files, because frobc could not check which files they include.

  $ alone run ../../../examples/blob_tracker/blob_tracker.frob --with ../../../examples/blob_tracker/blob.c
  error: the program uses C files, but the only C compiler here is the one inside frobc, which compiles only what frobc generates; install one (on Debian: apt-get install gcc), or set the environment variable CC
  [2]

frobc uses it only if there is no other compiler: `cc`, `gcc` or `clang`.

  $ mkdir other; printf '#!/bin/sh\necho "called: $0"\nexit 1\n' > other/clang; chmod +x other/clang
  $ cat > add.frob <<END
  > main :: SF (Float, Float) Float
  > main = proc (x, y) -> x + y
  > END
  $ printf 'time,in.1,in.2\n0,1,2\n' > in.csv
  $ env -u CC PATH=$PWD/none:$PWD/other "$frobc" trace add.frob --input in.csv 2>&1 | head -n 1
  error: the C compiler `clang` failed with status 1:
  $ alone trace add.frob --input in.csv
  time,out
  0.000000000,3

It treats a call of an undeclared function as an error, and rejects unknown options.

  $ tcc=$(dirname "$(dirname "$frobc")")/lib/frobc/frob-tcc
  $ printf 'int main(void)\n{\n    return (int)undeclared(1);\n}\n' > wrong.c
  $ "$tcc" -o wrong wrong.c
  wrong.c:3: error: implicit declaration of function 'undeclared'
  [1]
  $ "$tcc" -ffast-math -o wrong wrong.c
  frob-tcc: the option -ffast-math is not supported
  [1]
  $ "$tcc" -E wrong.c
  frob-tcc: the option -E is not supported
  [1]
  $ "$tcc"
  frob-tcc: usage: frob-tcc [-c | -shared] [-I FOLDER] [-D NAME[=VALUE]] -o RESULT FILE...
  [1]
