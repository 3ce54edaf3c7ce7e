Functions in C take and return numbers, Bools, sums, records, tuples and arrays.

  $ export CPATH=$(dirname "$(command -v frobc)")/../share/frobc/include
  $ cat > shapes.frob <<'EOF'
  > data Point = Point { x :: Distance, y :: Distance }
  > 
  > foreign apart :: Point -> Point -> Distance = "point_apart"
  > foreign mirror :: Point -> Point = "point_mirror"
  > foreign root :: Float -> Maybe Float = "maybe_root"
  > foreign total :: Array 3 Float -> Float = "total"
  > foreign steps :: Float -> Array 3 Float = "steps"
  > foreign both :: (Int, Bool) -> (Int, Float) = "both"
  > foreign far :: Array 2 Point -> Bool = "far_points"
  > foreign seven :: () -> Int = "seven"
  > 
  > data Out = Out
  >   { distance :: Distance, mirrored :: Point, roots :: Maybe Float, sum :: Float
  >   , pair :: (Int, Float), isFar :: Bool, constant :: Int }
  > 
  > main :: SF Float Out
  > main = proc t -> Out { distance = apart p q, mirrored = mirror p, roots = root t, sum = total (steps t)
  >                      , pair = both (round t, t > 2), isFar = far [p, q], constant = seven () } where
  >     p = Point { x = t * 1[m], y = 2[m] }
  >     q = Point { x = 1[m], y = 0 }
  > EOF
  $ frobc check --lint shapes.frob
  $ frobc compile --lint shapes.frob

The generated header declares the types, under names that do not depend on the program, and the
functions that it expects. Including it in a C file checks the file against it.

  $ sed -n '/Imported functions/,/^struct/p' shapes.h
  /* Imported functions. */
  
  double point_apart(const struct frob_point *a, const struct frob_point *b);
  
  void point_mirror(const struct frob_point *a, struct frob_point *result);
  
  void maybe_root(double a, struct frob_maybe_float *result);
  
  double total(const double *a);
  
  void steps(double a, double *result);
  
  void both(const struct both_a *a, struct both_result *result);
  
  bool far_points(const struct far_points_a *a);
  
  int32_t seven(void);
  
  struct shapes_state {
  $ cat > shapes_c.c <<'EOF'
  > #include "shapes.h"
  > #include <math.h>
  > double point_apart(const struct frob_point *a, const struct frob_point *b) {
  >     return hypot(a->x - b->x, a->y - b->y);
  > }
  > void point_mirror(const struct frob_point *a, struct frob_point *result) {
  >     result->x = -a->x;
  >     result->y = a->y;
  > }
  > void maybe_root(double a, struct frob_maybe_float *result) {
  >     result->tag = a < 0 ? FROB_MAYBE_FLOAT_NOTHING : FROB_MAYBE_FLOAT_JUST;
  >     result->f0 = a < 0 ? 0 : sqrt(a);
  > }
  > double total(const double *a) { return a[0] + a[1] + a[2]; }
  > void steps(double a, double *result) {
  >     for (int i = 0; i < 3; i++) result[i] = a * i;
  > }
  > void both(const struct both_a *a, struct both_result *result) {
  >     result->f1 = a->f2 ? a->f1 : -a->f1;
  >     result->f2 = a->f1 + 0.5;
  > }
  > bool far_points(const struct far_points_a *a) { return a->value[0].x > a->value[1].x + 2; }
  > int32_t seven(void) { return 7; }
  > EOF
  $ printf 'time,in\n0,1\n1,-8\n2,27\n' > in.csv
  $ frobc trace shapes.frob --with shapes_c.c --input in.csv
  time,out.distance,out.mirrored.x,out.mirrored.y,out.roots,out.sum,out.pair.1,out.pair.2,out.isFar,out.constant
  0.000000000,2,-1,2,Just 1,3,-1,1.5,false,7
  1.000000000,9.2195444572928871,8,2,Nothing,-24,8,-7.5,false,7
  2.000000000,26.076809620810597,-27,2,Just 5.196152422706632,81,27,27.5,true,7

Generated C has no warnings, as C and as C++:

  $ flags="-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -c -o out.o"
  $ for cc in gcc clang; do $cc -std=c99 $flags shapes.c; $cc -std=c99 $flags shapes_c.c; done
  $ for cc in g++ clang++; do $cc -x c++ -std=c++17 $flags shapes.c; done

A function of the C library needs only its header, and no file:

  $ cat > cube.frob <<'EOF'
  > foreign include "math.h"
  > foreign cubeRoot :: Float -> Float = "cbrt"
  > main :: SF Float Float
  > main = arr cubeRoot
  > EOF
  $ frobc compile cube.frob && g++ -x c++ -std=c++17 $flags cube.c
  $ frobc trace cube.frob --input in.csv | head -2
  time,out
  0.000000000,1

If a file is not given, the message asks for it; a missing file is reported:

  $ frobc trace shapes.frob --input in.csv 2>&1 | tail -1
  error: the program calls `point_apart`, `point_mirror`, `maybe_root`, `steps`, `total`, `both`, `far_points`, `seven` in C, but there is no C file: add the C files with `--with FILE.c` (only the functions of <math.h> that docs/foreign.md lists need no file)
  $ frobc trace shapes.frob --with shapes.cc --input in.csv
  error: there is no file shapes.cc
  [2]

Whatever the C function does, an unused result costs nothing, and a call with constant arguments is
made once, at the start:

  $ cat > start.frob <<'EOF'
  > foreign look :: Float -> Float = "look_up"
  > main :: SF Float Float
  > main = proc x -> x * gain where
  >     gain = look 3
  >     _unused = look x
  > EOF
  $ frobc compile start.frob && grep 'start_look(' start.c
  static inline double start_look(double a)
      const double gain = start_look(3.0);                    /* line 4 */

The slots of a sum:

  $ cat > entries.frob <<'FROB'
  > data Mode = Idle | Driving | Blocked
  > data Entry = Entry { x, y :: Distance, mode :: Mode, note :: Maybe Float }
  > foreign written :: Event Entry -> Float = "written"
  > main :: SF (Event Entry) Float
  > main = arr written
  > FROB
  $ cat > entries.c <<'C'
  > #include "entries.h"
  > double written(const struct frob_event_entry *e)
  > {
  >     const bool noted = e->t1 == ENTRIES_MAYBE_FLOAT_JUST;
  >     if (e->tag != FROB_EVENT_ENTRY_EVENT)
  >         return 0;
  >     return e->f0 + 10 * e->f1 + 100 * e->t0 + (noted ? 1000 * e->f2 : 0);
  > }
  > C
  $ cat > entries.csv <<'CSV'
  > time,in
  > 0,
  > 1,"Entry { x = 1, y = 2, mode = Blocked, note = Just 3 }"
  > 2,"Entry { x = 4, y = 5, mode = Driving, note = Nothing }"
  > CSV
  $ frobc trace entries.frob --with entries.c --input entries.csv
  time,out
  0.000000000,0
  1.000000000,3221
  2.000000000,154
