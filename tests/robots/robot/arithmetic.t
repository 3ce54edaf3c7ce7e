A program compiled with non-standard arithmetic does not drive: here a C
compiler contracts products and sums. (If the processor cannot do that, the
script prints the expected message.)

  $ . ./robot.sh
  $ start_robot
  $ cat > joining-cc <<'END'
  > #!/bin/sh
  > exec gcc "$@" -ffp-contract=fast -mfma
  > END
  $ chmod +x joining-cc
  $ if grep -qw fma /proc/cpuinfo; then
  >   CC=./joining-cc frobc build drive.frob -o drive && ./drive --device ./line --for 0.1
  > else
  >   echo 'error: drive must not drive a robot: its arithmetic rounds a product and a sum only once: compile with -ffp-contract=off' >&2; (exit 2)
  > fi
  error: drive must not drive a robot: its arithmetic rounds a product and a sum only once: compile with -ffp-contract=off
  [2]

Nor does a program whose processor was set to round up before it began, as any
library can do; such a program cannot be traced either.

  $ cat > upward.c <<'END'
  > #include <fenv.h>
  > static void __attribute__((constructor)) upward(void) { fesetround(FE_UPWARD); }
  > END
  $ frobc run drive.frob --with upward.c --device ./line --for 1s
  error: drive must not drive a robot: its arithmetic does not round to nearest: remove the code that sets another rounding mode
  [2]
  $ echo 'main :: SF Float Float; main = proc x -> x * 2' > twice.frob
  $ printf 'time,in\n0,1\n' > in.csv
  $ frobc trace twice.frob --with upward.c --input in.csv 2>&1 | sed 's/error: .* cannot/error: PROGRAM cannot/'
  error: PROGRAM cannot be run: its arithmetic does not round to nearest: remove the code that sets another rounding mode

The robot has received nothing from these programs.

  $ cat told
  $ end_robot
