With `--batch` a program has a function that takes many steps in one call.

  $ export CPATH=$(dirname "$(command -v frobc)")/../share/frobc/include
  $ cat > modes.frob <<'END'
  > data Command = Command { speed :: Velocity, stopped :: Event Time }
  > 
  > main :: SF (Bool, Array 2 Velocity) Command
  > main = proc (stop, wanted) -> Command { speed = v, stopped = e } where
  >     v = drive (stop, wanted ! 0 + wanted ! 1)
  >     e = edge stop `tag` t
  >     t = time ()
  > 
  > drive = switch (proc (stop, w) -> (2 * w, edge stop)) (\_ -> rest)
  > rest  = switch (proc (stop, w) -> (integral w / 1[s], falling stop)) (\_ -> drive)
  > END
  $ frobc compile modes.frob --batch
  $ grep -B 2 -A 4 'void modes_steps' modes.h
  /* Runs count steps. Each takes its times and its input from these arrays, as modes_step_ns does,
   * and writes its output to out. */
  void modes_steps(struct modes_state *self,
                   int32_t count,
                   const int64_t *dt_ns,
                   const double *dt,
                   const struct modes_input *in,
  $ sed -n '/^void modes_steps/,$p' modes.c
  void modes_steps(struct modes_state *self,
                   int32_t count,
                   const int64_t *dt_ns,
                   const double *dt,
                   const struct modes_input *in,
                   struct modes_output *out)
  {
      for (int32_t i = 0; i < count; i++) {
          modes_step_ns(self, dt_ns[i], dt[i], &in[i], &out[i]);
      }
  }

Its outputs are those of single steps, bit for bit, and it continues from the current state.

  $ cat > main.c <<'END'
  > #include "modes.h"
  > #include <stdio.h>
  > #include <string.h>
  > 
  > #ifdef SINGLE
  > typedef float real;
  > #else
  > typedef double real;
  > #endif
  > 
  > enum { N = 1000 };
  > 
  > int main(void)
  > {
  >     static struct modes_input in[N];
  >     static struct modes_output one[N], many[N];
  >     static int64_t dt_ns[N];
  >     static real dt[N];
  >     struct modes_state a, b;
  >     int32_t changes = 0;
  >     for (int32_t i = 0; i < N; i++) {
  >         dt_ns[i] = i % 7 * 15625000;
  >         dt[i] = (real)dt_ns[i] / (real)1e9;
  >         in[i].f1 = i % 11 < 4;
  >         in[i].f2[0] = (float)(i % 5) * 0.25f;
  >         in[i].f2[1] = (float)(i % 3) * -0.5f;
  >     }
  >     modes_reset(&a);
  >     modes_reset(&b);
  >     for (int32_t i = 0; i < N; i++)
  >         modes_step_ns(&a, dt_ns[i], dt[i], &in[i], &one[i]);
  >     modes_steps(&b, 0, dt_ns, dt, in, many);
  >     modes_steps(&b, 400, dt_ns, dt, in, many);
  >     modes_steps(&b, N - 400, dt_ns + 400, dt + 400, in + 400, many + 400);
  >     for (int32_t i = 0; i < N; i++) {
  >         if (one[i].speed != many[i].speed || one[i].stopped.tag != many[i].stopped.tag ||
  >             one[i].stopped.f0 != many[i].stopped.f0)
  >             return printf("step %d differs\n", (int)i);
  >         changes += one[i].stopped.tag != 0;
  >     }
  >     printf("%d steps, %d stops\n", N, (int)changes);
  >     return 0;
  > }
  > END
  $ flags="-O2 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -ffp-contract=off"
  $ gcc -std=c99 $flags modes.c main.c -o with_gcc && ./with_gcc
  1000 steps, 90 stops
  $ clang -std=c99 $flags modes.c main.c -o with_clang && ./with_clang
  1000 steps, 90 stops
  $ g++ -std=c++17 -x c++ $flags modes.c main.c -o with_gxx && ./with_gxx
  1000 steps, 90 stops

The same in single precision.

  $ frobc compile modes.frob --batch --real float
  $ gcc -std=c99 -DSINGLE $flags modes.c main.c -o single && ./single
  1000 steps, 90 stops

Without `--batch`, there is no such function.

  $ frobc compile modes.frob
  $ grep -c modes_steps modes.h modes.c
  modes.h:0
  modes.c:0
  [1]
