Modes share memory. A mode that is entered again starts afresh, and leaves
nothing to the next one.

  $ both () { frobc trace "$1" --input "$2" > c.csv && frobc trace "$1" --input "$2" --engine interp | diff c.csv - && cat c.csv; }
  $ cat > afresh.frob <<'EOF'
  > a, b :: SF Float Float
  > a = switch (proc x -> (integral x / 1[s] + delay 0.5 x, edge (x > 2))) (\_ -> b)
  > b = switch (proc x -> (1000 + time () / 1[s] + delay 0.25 x, edge (x > 2))) (\_ -> a)
  > 
  > main = a
  > EOF
  $ printf 'time,in\n0,1\n1,2\n2,3\n3,4\n4,1\n5,5\n6,1\n7,3\n8,1\n9,3\n10,6\n11,1\n12,4\n13,5\n14,2\n' > afresh.csv
  $ both afresh.frob afresh.csv
  time,out
  0.000000000,0.5
  1.000000000,2
  2.000000000,1000.25
  3.000000000,1004
  4.000000000,1006
  5.000000000,0.5
  6.000000000,10
  7.000000000,1000.25
  8.000000000,1004
  9.000000000,0.5
  10.000000000,6
  11.000000000,15
  12.000000000,1000.25
  13.000000000,1005
  14.000000000,1007

A machine has the size of its largest mode, plus the number of the mode.

  $ cat > memory.frob <<'EOF'
  > a, b :: SF Float Float
  > a = switch (proc x -> (delay 1 (delay 2 (delay 3 x)), edge (x > 2))) (\_ -> b)
  > b = switch (proc x -> (integral x / 1[s], edge (x < 2))) (\_ -> a)
  > 
  > main = a
  > EOF
  $ frobc compile memory.frob
  $ cat > size.c <<'EOF'
  > #include <stdio.h>
  > #include "memory.h"
  > int main(void) { printf("%zu doubles\n", sizeof(struct memory_state) / sizeof(double)); return 0; }
  > EOF
  $ gcc size.c -o size && ./size
  4 doubles

The first mode ends immediately. gcc must not read its parameter where the
second mode stores its own (at -O2 it assumed that the two were independent):

  $ cat > overlaid.frob <<'EOF'
  > main :: SF Int (Either Int Float)
  > main = proc i -> v where
  >   v = (switch ((proc _ -> drSwitch (constant (Left (-1))) (0, mapE (\_ -> arr (\_ -> Left 100)) ((NoEvent :: Event Int)))) &&& (proc _ -> mapE (\_ -> Event (NoEvent :: Event Bool)) (when True))) (\_ -> (proc _ -> mapE (\_ -> 2) (when False)) >>> dAccumHoldBy (\_ _ -> Right 1) (Right (-0.0)))) i
  > EOF
  $ printf 'time,in\n0,1\n1,1\n' > ones.csv
  $ both overlaid.frob ones.csv
  time,out
  0.000000000,Right (-0)
  1.000000000,Right (-0)
