`frobc selftest` checks whether a C compiler, called as the user calls it, compiles generated code
correctly.

  $ frobc selftest --cc gcc
  compiler: gcc -std=c99 -O2 -ffp-contract=off
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

  $ verdict () { frobc selftest "$@" 2> errors | grep -v ': correct' && cat errors; }
  $ verdict --cc clang --cflags "-O3 -ffp-contract=off -march=native -Wno-unknown-warning-option -Wno-invalid-feature-combination"
  compiler: clang -O3 -ffp-contract=off -march=native -Wno-unknown-warning-option -Wno-invalid-feature-combination
  verdict: fit
  $ verdict --cc tcc --cflags ""
  compiler: tcc
  verdict: fit
  $ CC="gcc -O1" verdict --cflags "-std=c99 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -fsanitize=address,undefined,float-cast-overflow -fno-sanitize-recover=all" | tail -1
  verdict: fit
  $ verdict --cc g++ --cflags "-std=c++17 -Wall -Wextra -Werror"
  compiler: g++ -std=c++17 -Wall -Wextra -Werror
  verdict: fit

The same in single precision:

  $ verdict --cc clang --real float
  compiler: clang -std=c99 -O2 -ffp-contract=off
  verdict: fit

Arithmetic that does not follow IEEE 754:

  $ frobc selftest --cc gcc --cflags "-O2 -ffast-math"
  compiler: gcc -O2 -ffast-math
  error: arithmetic compiled by `gcc -O2 -ffast-math` treats floating-point numbers as real numbers: compile without -ffast-math and its suboptions
  verdict: unfit
  [1]
  $ if grep -qw fma /proc/cpuinfo; then frobc selftest --cc gcc --cflags "-O2 -ffp-contract=fast -mfma" 2>&1 | tail -2; else
  >   echo 'error: arithmetic compiled by `gcc -O2 -ffp-contract=fast -mfma` rounds a product and a sum only once: compile with -ffp-contract=off
  > verdict: unfit'; fi
  error: arithmetic compiled by `gcc -O2 -ffp-contract=fast -mfma` rounds a product and a sum only once: compile with -ffp-contract=off
  verdict: unfit

A compiler with a bug, here in the square root: the test runs completely, and shows the first step
that differs.

  $ frobc selftest --cc gcc --cflags "-Dsqrt(x)=fabs(x)" 2>&1 | grep -v ': correct'
  compiler: gcc -Dsqrt(x)=fabs(x)
  functions: incorrect
  error: functions.frob, compiled by `gcc -Dsqrt(x)=fabs(x)`:
  step 1: out.1.1 is 1.127 but must be nan
  verdict: unfit

A compiler that rejects some of the code, and one that warns:

  $ cat > strict-cc <<'END'
  > #!/bin/sh
  > case "$*" in *tasks.c*) echo "tasks.c:1: no such luck" >&2; exit 7 ;; esac
  > case "$*" in *time.c*) echo "time.c:2: mind the time" >&2 ;; esac
  > exec gcc "$@"
  > END
  $ chmod +x strict-cc
  $ frobc selftest --cc ./strict-cc --cflags -O1 2>&1 | grep -v ': correct'
  compiler: ./strict-cc -O1
  warning: the C compiler reports:
  time.c:2: mind the time
  tasks: incorrect
  error: `./strict-cc -O1` failed with status 7:
  tasks.c:1: no such luck
  verdict: unfit
  $ sed -i /tasks/d strict-cc
  $ frobc selftest --cc ./strict-cc --cflags -O1 2>&1 | grep -v ': correct'
  compiler: ./strict-cc -O1
  warning: the C compiler reports:
  time.c:2: mind the time
  verdict: fit, with warnings

A compiler that cannot be tested has no verdict: it does not exist, it compiles
nothing, or it is for another machine.

  $ frobc selftest --cc nocc
  compiler: nocc -std=c99 -O2 -ffp-contract=off
  error: there is no C compiler `nocc`
  [2]
  $ frobc selftest --cc gcc --cflags --no-such-flag
  compiler: gcc --no-such-flag
  error: the C compiler cannot compile a one-line program: `gcc --no-such-flag` failed with status 1:
  gcc: error: unrecognized command-line option '--no-such-flag'; did you mean '--no-mudflap'?
  [2]
  $ cat > cross-cc <<'END'
  > #!/bin/sh
  > while [ $# -gt 0 ]; do [ "$1" = -o ] && result=$2; shift; done
  > printf '\177ELF of another machine' > "$result"; chmod +x "$result"
  > END
  $ chmod +x cross-cc
  $ frobc selftest --cc ./cross-cc
  compiler: ./cross-cc -std=c99 -O2 -ffp-contract=off
  error: a program compiled by `./cross-cc -std=c99 -O2 -ffp-contract=off` does not run here; use --runner to name a command that runs it: Exec format error
  [2]
  $ frobc selftest --cc gcc --runner no-emulator
  compiler: gcc -std=c99 -O2 -ffp-contract=off
  error: a program compiled by `gcc -std=c99 -O2 -ffp-contract=off` does not run here with `no-emulator`: `no-emulator` was not found
  [2]

A compiler for a board may have no way to print: the code is compiled, but not
linked.

  $ cat > board-cc <<'END'
  > #!/bin/sh
  > for argument in "$@"; do [ "$argument" = -c ] && exec gcc "$@"; done
  > exec gcc "$@" -nostartfiles -nodefaultlibs
  > END
  $ chmod +x board-cc
  $ frobc selftest --cc ./board-cc 2>&1 | head -3
  compiler: ./board-cc -std=c99 -O2 -ffp-contract=off
  error: `./board-cc -std=c99 -O2 -ffp-contract=off` compiles a one-line program but does not link it. If the compiler is for a board, add a library that prints through an emulator, and name the emulator; with newlib, for example: --cflags "-std=c99 -O2 -ffp-contract=off --specs=rdimon.specs" --runner qemu-arm
  `./board-cc -std=c99 -O2 -ffp-contract=off` failed with status 1:

An emulator, or any other command that runs a program:

  $ verdict --cc gcc --runner "env FROB=1"
  compiler: gcc -std=c99 -O2 -ffp-contract=off
  verdict: fit
