Types in C: Frob code passes values on without examining them.

  $ export CPATH=$(dirname "$(command -v frobc)")/../share/frobc/include
  $ cat > camera.h <<'EOF'
  > #ifndef CAMERA_H
  > #define CAMERA_H
  > struct frame { const double *pixels; int count; double time; };
  > struct stamp { struct { int set; } flag; double time; };
  > #endif
  > EOF
  $ cat > eyes.frob <<'EOF'
  > foreign include "camera.h"
  > foreign type Frame = "struct frame"
  > foreign type Stamp = "struct stamp" copyable
  > 
  > foreign mean :: Frame -> Float = "frame_mean"
  > foreign half :: Bool -> Frame -> Frame = "frame_half"
  > foreign stamp :: Frame -> Stamp = "frame_stamp"
  > foreign never :: () -> Stamp = "stamp_never"
  > foreign between :: Stamp -> Stamp -> Time = "stamp_between"
  > 
  > data Eyes = Eyes { left :: Frame, flash :: Event Frame }
  > 
  > main :: SF Eyes (Float, Time, Float, Float, Maybe Stamp)
  > main = proc eyes -> (mean (half True eyes.left), between before at, held, rare, last) where
  >     at = stamp eyes.left
  >     before = delay (never ()) at
  >     held = hold 0 (mapE mean eyes.flash)
  >     rare = fromEvent 0 (onEvent (arr (\f -> mean (half False f))) eyes.flash)
  >     last = case eyes.flash of
  >         Event f -> Just (stamp f)
  >         NoEvent -> Nothing
  > EOF
  $ frobc check --lint eyes.frob
  $ frobc compile --lint eyes.frob
  $ cat > camera.c <<'EOF'
  > #include "eyes.h"
  > static struct frame halves[2];
  > double frame_mean(const struct frame *a) {
  >     double sum = 0;
  >     for (int i = 0; i < a->count; i++) sum += a->pixels[i];
  >     return sum / a->count;
  > }
  > const struct frame *frame_half(bool a, const struct frame *b) {
  >     halves[a] = *b;
  >     halves[a].count /= 2;
  >     halves[a].pixels += a ? 0 : halves[a].count;
  >     return &halves[a];
  > }
  > void frame_stamp(const struct frame *a, struct stamp *result) { result->flag.set = 1; result->time = a->time; }
  > void stamp_never(struct stamp *result) { result->flag.set = 0; result->time = 0; }
  > double stamp_between(const struct stamp *a, const struct stamp *b) {
  >     return a->flag.set ? b->time - a->time : -1;
  > }
  > EOF

A value of a foreign type is an address; a value of a copyable type is a struct, and may be stored:

  $ sed -n '/^struct eyes_input/,/^};/p; /^struct eyes_state/,/^};/p' eyes.h | sed 's/Prelude.frob:.*/Prelude.frob/'
  struct eyes_input {
      const struct frame *left;
      struct eyes_event_frame flash;
  };
  struct eyes_state {
      struct stamp before; /* delay at eyes.frob:16 */
      double held_prev;    /* delay at Prelude.frob
  };
  $ cat > run.c <<'EOF'
  > #include "eyes.h"
  > #include <stdio.h>
  > int main(void) {
  >     struct eyes_state state;
  >     eyes_reset(&state);
  >     for (int i = 0; i < 4; i++) {
  >         const double pixels[4] = {i, i, 2 * i, 4 * i};
  >         const struct frame frame = {pixels, 4, 0.5 * i};
  >         const struct eyes_input in = {&frame, {(uint8_t)(i % 2), i % 2 ? &frame : NULL}};
  >         struct eyes_output out;
  >         eyes_step(&state, 0.5, &in, &out);
  >         printf("%g %g %g %g %d\n", out.f1, out.f2, out.f3, out.f4, out.f5.tag);
  >     }
  >     return 0;
  > }
  > EOF
  $ flags="-I. -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror"
  $ for cc in "gcc -O2" "clang -fsanitize=address,undefined"; do
  >   $cc -std=c99 $flags -ffp-contract=off eyes.c camera.c run.c -lm -o run && ./run || exit
  > done
  0 -1 0 0 0
  1 0.5 2 3 1
  2 0.5 2 0 0
  3 0.5 6 9 1
  0 -1 0 0 0
  1 0.5 2 3 1
  2 0.5 2 0 0
  3 0.5 6 9 1
  $ for cc in g++ clang++; do $cc -x c++ -std=c++17 $flags -c -o out.o eyes.c; done

C never receives the address of a missing value: `mean` was not called for a flash that did not
occur.

  $ grep '!= 0' eyes.c | grep -vc '^#'
  3

A trace cannot contain such values:

  $ printf 'time\n0\n' > in.csv
  $ frobc trace eyes.frob --with camera.c --input in.csv
  error: the input or output of `main` has a foreign type, which frobc cannot read or print; compile the program to C, and call it from your own C code
  [2]
  $ frobc trace eyes.frob --with camera.c --input in.csv --engine interp
  error[E0505]: the interpreter cannot run this program: `stamp` is written in C
   --> eyes.frob:7:9
    |
  7 | foreign stamp :: Frame -> Stamp = "frame_stamp"
    |         ^^^^^
    |
    = hint: run it with `--engine c`
  
  1 error
  [2]

Foreign values cannot be compared, or stored in any way unless they are
copyable:

  $ cat > compared.frob <<'EOF'
  > foreign include "camera.h"
  > foreign type Stamp = "struct stamp" copyable
  > same :: Stamp -> Stamp -> Bool
  > same a b = a == b
  > EOF
  $ frobc check compared.frob
  error[E0307]: `Stamp` has no equality
   --> compared.frob:4:14
    |
  4 | same a b = a == b
    |              ^^ `==` needs it
    |
    = hint: only C can compare two values of type `Stamp`: import a C function that does
  
  1 error
  [1]
  $ cat > held.frob <<'EOF'
  > foreign type Frame = "struct frame"
  > foreign mean :: Frame -> Float = "frame_mean"
  > foreign blank :: () -> Frame = "frame_blank"
  > main :: SF (Event Frame) Float
  > main = proc e -> mean (hold (blank ()) e)
  > EOF
  $ frobc check held.frob
  error[E0430]: a value of the foreign type `Frame` cannot be kept from one instant to the next
   --> held.frob:5:24
    |
  5 | main = proc e -> mean (hold (blank ()) e)
    |                        ^^^^^^^^^^^^^^^^^
    |
    = note: a `Frame` from C is valid for one instant; the C code may reuse its memory after that
    = hint: keep only the numbers that you need, or declare the type `copyable` if a copy of the struct works like the original
  
  1 error
  [1]
  $ cat > captured.frob <<'EOF'
  > foreign type Frame = "struct frame"
  > foreign likeness :: Frame -> Frame -> Float = "frame_likeness"
  > main :: SF (Event Frame, Frame) Float
  > main = switch (proc (e, _) -> (0, e)) (\first -> proc (_, f) -> likeness first f)
  > EOF
  $ frobc check captured.frob
  error[E0430]: a value of the foreign type `Frame` cannot be kept from one instant to the next
   --> captured.frob:4:50
    |
  4 | main = switch (proc (e, _) -> (0, e)) (\first -> proc (_, f) -> likeness first f)
    | -------------------------------------------------^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^- `main` is called here
    |
    = note: a `Frame` from C is valid for one instant; the C code may reuse its memory after that
    = hint: keep only the numbers that you need, or declare the type `copyable` if a copy of the struct works like the original
  
  1 error
  [1]
  $ cat > started.frob <<'EOF'
  > foreign type Frame = "struct frame"
  > foreign likeness :: Frame -> Frame -> Float = "frame_likeness"
  > foreign blank :: () -> Frame = "frame_blank"
  > compareWith :: Frame -> SF Frame Float
  > compareWith known = proc f -> likeness known f
  > main :: SF Frame Float
  > main = proc f -> compareWith (blank ()) f
  > EOF
  $ frobc check started.frob
  error[E0430]: a value of the foreign type `Frame` cannot be kept from one instant to the next
   --> started.frob:7:18
    |
  7 | main = proc f -> compareWith (blank ()) f
    |                  ^^^^^^^^^^^^^^^^^^^^^^^^
    |
    = note: a `Frame` from C is valid for one instant; the C code may reuse its memory after that
    = hint: keep only the numbers that you need, or declare the type `copyable` if a copy of the struct works like the original
  
  1 error
  [1]

They may pass through functions, instances and switches within the instant:

  $ cat > passed.frob <<'EOF'
  > foreign type Frame = "struct frame"
  > foreign mean :: Frame -> Float = "frame_mean"
  > main :: SF (Frame, Frame) Frame
  > main = switch (proc (l, r) -> (l, edge (mean l > mean r))) (\_ -> arr snd)
  > EOF
  $ frobc compile --lint passed.frob && gcc -std=c99 $flags -c passed.c
