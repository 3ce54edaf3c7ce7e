A component in C is a signal function: its state is part of the program's state, it is reset when it
starts, and it receives the time since it last ran.

  $ cat > filter.h <<'EOF'
  > #ifndef FILTER_H
  > #define FILTER_H
  > #ifdef __cplusplus
  > extern "C" {
  > #endif
  > struct filter_state { int steps; double sum; };
  > #ifdef __cplusplus
  > }
  > #endif
  > #endif
  > EOF
  $ cat > filter.c <<'EOF'
  > #include "filters.h"
  > void filter_reset(struct filter_state *self) { self->steps = 0; self->sum = 0; }
  > void filter_step(struct filter_state *self, double dt, const struct filter_input *in,
  >                  struct filter_output *out) {
  >     self->sum += dt * in->value;
  >     out->f1 = ++self->steps;
  >     out->f2.tag = self->steps % 2 ? FROB_EVENT_FLOAT_EVENT : FROB_EVENT_FLOAT_NO_EVENT;
  >     out->f2.f0 = self->sum;
  > }
  > EOF

Two components run side by side, one starts afresh in each mode, one runs at its own rate, and one
runs for each element of an array:

  $ cat > filters.frob <<'EOF'
  > foreign include "filter.h"
  > foreign sf filter :: SF Float (Int, Event Float) = "filter"
  > 
  > steps :: SF Float Int
  > steps = filter >>> arr fst
  > 
  > two :: SF Float (Int, Event Float, Event Float)
  > two = proc x -> (n, a, b) where
  >     (n, a) = filter x
  >     (_, b) = filter (2 * x)
  > 
  > modes :: SF Float Int
  > modes = switch (proc x -> (steps x, edge (x > 2))) (\_ -> proc x -> 100 + steps x)
  > 
  > main :: SF Float ((Int, Event Float, Event Float), Int, Event Int, Int)
  > main = proc x -> (two x, modes x, sampleEvery 1[s] steps x, foldl (+) 0 (mapSF steps [x, x]))
  > EOF
  $ frobc check --lint filters.frob
  $ printf 'time,in\n0,1\n0.5,2\n1,3\n1.5,4\n2,5\n' > in.csv
  $ frobc trace --lint filters.frob --with filter.c --with filter.h --input in.csv
  time,out.1.1,out.1.2,out.1.3,out.2,out.3,out.4
  0.000000000,1,0,0,1,1,2
  0.500000000,2,,,2,,4
  1.000000000,3,2.5,5,101,2,6
  1.500000000,4,,,102,,8
  2.000000000,5,7,14,103,3,10

The state is part of the program's state. The report states what it cannot
count:

  $ frobc report filters.frob | grep -e '^state' -e 'calls of'
  state, in bytes, without struct filter_state from the user's C code
    calls of filter_reset     1
    calls of filter_step      7

A clash with names in the program's own C:

  $ cp filters.frob filter.frob
  $ frobc compile filter.frob
  error[E0431]: the program and the C component `filter` have the same name
   --> filter.frob:2:12
    |
  2 | foreign sf filter :: SF Float (Int, Event Float) = "filter"
    |            ^^^^^^
    |
    = note: both would define `struct filter_state`, `filter_reset` and `filter_step`
    = hint: rename the program's file
  
  1 error
  [1]

A component's header with the name of the program's header:

  $ sed 's/filter.h/same.h/' filters.frob > same.frob
  $ frobc compile same.frob
  error[E0431]: the program includes `same.h`, but the header that frobc generates has the same name
   --> same.frob:1:1
    |
  1 | foreign include "same.h"
    | ^
    |
    = hint: rename the program's file or the header
  
  1 error
  [1]

In a loop a component is treated as a unit: every output depends on every input.

  $ cat > loop.frob <<'EOF'
  > foreign include "filter.h"
  > foreign sf filter :: SF Float (Int, Event Float) = "filter"
  > main :: SF Float Int
  > main = proc x -> n where
  >     (n, _) = filter (x + toFloat n)
  > EOF
  $ frobc compile loop.frob
  error[E0401]: the signal `n` needs its own value in the same instant
   --> loop.frob:5:6
    |
  5 |     (n, _) = filter (x + toFloat n)
    |      ^                   --------- `n` reads `n` here, through `filter`
    |
    = hint: let `n` read its own previous value: add the equation `before = delay 0 n`, where 0 is the initial value, and read `before` here
  
  1 error
  [1]

The output of a component is unknown when a program starts, so it may switch
immediately:

  $ cat > endless.frob <<'EOF'
  > foreign include "filter.h"
  > foreign sf filter :: SF Float (Int, Event Float) = "filter"
  > main :: SF Float Int
  > main = switch filter (\_ -> main)
  > EOF
  $ frobc compile endless.frob
  error[E0402]: `main → main` may repeat endlessly within one instant
   --> endless.frob:4:1
    |
  4 | main = switch filter (\_ -> main)
    | ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    | |                           |
    | |                           `main` may start itself again at its own first instant
    | `filter` may occur at the first instant of `main`
    |
    = note: no time passes between these steps when `filter` occurs as soon as `main` starts
    = hint: apply `notYet` to the event to ignore it at the first instant; `edge` would wait forever if the condition were true from the start
  
  1 error
  [1]

A program can be a component of another one, through its own header, if its input and output consist
of numbers, Bools, records, tuples and arrays of these.

  $ cat > inner.frob <<'FROB'
  > import Geometry
  > 
  > data Seen = Seen { at :: Pose, near :: Array 2 Distance, sure :: Bool }
  > 
  > main :: SF Seen (Pose, Distance)
  > main = proc i -> (compose i.at i.at, if i.sure then way + i.near ! 1 else 0) where
  >     way = integral (i.near ! 0 / 1[s])
  > FROB
  $ cat > outer.frob <<'FROB'
  > import Geometry
  > 
  > foreign include "inner.h"
  > 
  > data Seen = Seen { at :: Pose, near :: Array 2 Distance, sure :: Bool }
  > 
  > foreign sf inner :: SF Seen (Pose, Distance) = "inner"
  > 
  > main :: SF Distance (Distance, Distance)
  > main = proc d -> ((fst both').position.x, snd both') where
  >     both' = inner (Seen { at = Pose { position = Vec2 { x = d, y = 0 }, heading = 0 }, near = [d, 1[m]], sure = d > 0 })
  > FROB
  $ frobc compile inner.frob
  $ grep DEFINED inner.h
  #define INNER_INPUT_DEFINED
  #define INNER_OUTPUT_DEFINED
  $ printf 'time,in\n0,1\n1,2\n2,0\n3,3\n' > in.csv
  $ frobc trace outer.frob --with inner.c --input in.csv
  time,out.1,out.2
  0.000000000,2,1
  1.000000000,4,2
  2.000000000,0,0
  3.000000000,6,4
