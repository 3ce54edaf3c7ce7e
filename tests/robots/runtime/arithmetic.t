The check finds each fault of the arithmetic, under each compiler option that
causes one. It finds none if the arithmetic is correct.

  $ cat > ask.c <<'END'
  > #include <frob/arithmetic.h>
  > #include <stdio.h>
  > int main(void)
  > {
  >     unsigned faults = frob_arithmetic_faults();
  >     const unsigned of_settings = FROB_ARITHMETIC_ROUNDING | FROB_ARITHMETIC_CONTRACTION |
  >                                  FROB_ARITHMETIC_SUBNORMAL;
  >     if ((frob_arithmetic_float_faults() & of_settings) != (faults & of_settings))
  >         printf("floats have faults %x\n", frob_arithmetic_float_faults());
  >     static const char *const names[] = { "format", "rounding", "precision", "contraction",
  >                                          "algebra", "subnormal", "special" };
  >     for (unsigned i = 0; i < 7; i++)
  >         if ((faults >> i & 1u) != 0)
  >             printf("%s ", names[i]);
  >     puts(faults == 0 ? "fine" : frob_arithmetic_reason(faults));
  >     return 0;
  > }
  > END
  $ warnings="-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror"
  $ ask () { "$@" $warnings -I ../../../runtime/include -o ask ask.c -lm && ./ask; }
  $ for compiler in "gcc -std=c99 -O0" "gcc -std=c99 -O2" "gcc -O3 -ffp-contract=off -march=native" \
  >   "clang -std=c99 -O0" "clang -O3 -ffp-contract=off -march=native -Wno-unknown-warning-option -Wno-invalid-feature-combination" "g++ -x c++ -std=c++17 -O2" \
  >   "clang++ -x c++ -std=c++17 -O2" "gcc -std=c99 -O2 -fsanitize=address,undefined" tcc; do ask $compiler; done
  fine
  fine
  fine
  fine
  fine
  fine
  fine
  fine
  fine

  $ ask gcc -O2 -ffast-math
  precision algebra subnormal special treats floating-point numbers as real numbers: compile without -ffast-math and its suboptions
  $ ask clang -O2 -ffast-math
  precision algebra subnormal special treats floating-point numbers as real numbers: compile without -ffast-math and its suboptions
  $ ask gcc -O2 -freciprocal-math
  algebra treats floating-point numbers as real numbers: compile without -ffast-math and its suboptions
  $ ask gcc -O2 -ffinite-math-only
  special treats floating-point numbers as real numbers: compile without -ffast-math and its suboptions
  $ ask clang -O2 -fno-signed-zeros
  special treats floating-point numbers as real numbers: compile without -ffast-math and its suboptions

Products and sums are contracted if the processor can do that; otherwise the
script prints the expected results.

  $ can () { grep -qw fma /proc/cpuinfo; }
  $ if can; then ask gcc -O2 -ffp-contract=fast -mfma && ask clang -O1 -ffp-contract=fast -mfma; else for i in 1 2; do
  >   echo "contraction rounds a product and a sum only once: compile with -ffp-contract=off"; done; fi
  contraction rounds a product and a sum only once: compile with -ffp-contract=off
  contraction rounds a product and a sum only once: compile with -ffp-contract=off

Registers with more bits than a double make products appear contracted.

  $ if [ "$(uname -m)" = x86_64 ]; then ask gcc -O0 -mfpmath=387 && ask gcc -O2 -mfpmath=387; else for i in 1 2; do
  >   echo "uses more than 53 bits of precision: compile for SSE2 or another unit for doubles"; done; fi | sed 's/.* uses/uses/'
  uses more than 53 bits of precision: compile for SSE2 or another unit for doubles
  uses more than 53 bits of precision: compile for SSE2 or another unit for doubles

Settings of the processor: linking with -ffast-math flushes subnormal numbers to zero from the start
of the process, and any code can set a rounding mode.

  $ gcc -O2 -I ../../../runtime/include -c ask.c && gcc -ffast-math ask.o -o linked && ./linked
  subnormal flushes small numbers to zero: compile and link without -ffast-math
  $ for mode in UPWARD DOWNWARD TOWARDZERO; do
  >   echo "#include <fenv.h>
  >   static void __attribute__((constructor)) set(void) { fesetround(FE_$mode); }" > set.c
  >   gcc ask.o set.c -lm -o set && ./set | sed 's/rounding .* does/rounding … does/'
  > done
  rounding … does not round to nearest: remove the code that sets another rounding mode
  rounding … does not round to nearest: remove the code that sets another rounding mode
  rounding … does not round to nearest: remove the code that sets another rounding mode
