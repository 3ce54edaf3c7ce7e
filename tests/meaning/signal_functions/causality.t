Equations may depend on each other in the same instant if no part of a signal
depends on itself. Parts are the components of tuples and the fields of records,
also through signal functions. Every trace is run compiled and interpreted, and
was computed by hand.

  $ trace() {
  >   cat > in.csv
  >   frobc trace --lint --engine interp "$1.frob" --input in.csv --output interpreted.csv
  >   frobc trace --lint "$1.frob" --input in.csv | tee compiled.csv
  >   cmp compiled.csv interpreted.csv
  > }
  $ counted() { printf 'time,in\n0,1\n1,2\n2,3\n' | trace "$1"; }

  $ counted causal_through_tuples
  time,out.1,out.2
  0.000000000,1,2
  1.000000000,2,3
  2.000000000,3,4

  $ counted causal_through_records
  time,out
  0.000000000,1
  1.000000000,3
  2.000000000,8

  $ counted causal_through_inner_procs
  time,out.1,out.2
  0.000000000,1,2
  1.000000000,2,3
  2.000000000,3,4

  $ counted node_called_twice
  time,out.1,out.2
  0.000000000,1,1
  1.000000000,3,4
  2.000000000,5,8

  $ counted loop_of_wires
  time,out.1,out.2
  0.000000000,2,1
  1.000000000,3,2
  2.000000000,4,3

  $ printf 'time\n0\n0.5\n1\n' | trace equations_through_integrals
  time,out.1,out.2
  0.000000000,1,0
  0.500000000,1,-0.5
  1.000000000,0.75,-1

A part that depends on itself is rejected, and the message shows the loop:

  $ frobc check loop_through_inner_proc.frob
  error[E0401]: the signal `x` needs its own value in the same instant
   --> loop_through_inner_proc.frob:7:6
    |
  7 |     (x, y) = crossed (n, x + y)
    |      ^                   ----- `x` reads `x` here, through `crossed`
    |
    = hint: let `x` read its own previous value: add the equation `before = delay 0 x`, where 0 is the initial value, and read `before` here
  
  1 error
  [1]

  $ frobc check loop_through_two_instances.frob
  error[E0401]: the signal `u` needs its own value in the same instant
   --> loop_through_two_instances.frob:7:6
    |
  7 |     (u, v) = step (w, n)
    |     -^------------------ `u` reads `w` here, through `step`
  8 |     (w, _) = step (u, v)
    |     -------------------- `w` reads `u` here, through `step`
    |
    = hint: let `w` read the previous value of `u`: add the equation `before = delay 0 u`, where 0 is the initial value, and read `before` here
  
  1 error
  [1]

  $ frobc check loop_by_turns.frob
  error[E0401]: the signal `x` needs its own value in the same instant
   --> loop_by_turns.frob:4:5
    |
  4 |     x = if b then y else 0
    |     ^   ------------------ `x` reads `y` here
  5 |     y = if b then 0 else x
    |         ------------------ `y` reads `x` here
    |
    = hint: let `y` read the previous value of `x`: write `before = delay 0 x` and `y = if b then 0 else before`, where 0 is the initial value
  
  1 error
  [1]

A loop is an error even if the value of an operand or branch would break it:

  $ cat > needless.frob <<EOF
  > data P = P { f :: Float, g :: Float }
  > main :: SF (Bool, P) (Bool, P)
  > main = proc (_, p) -> (x, q) where
  >     x = x && False
  >     q = if q.g > 0 then p { f = 1 } else p
  > EOF
  $ frobc check needless.frob
  error[E0401]: the signal `x` needs its own value in the same instant
   --> needless.frob:4:5
    |
  4 |     x = x && False
    |     ^   ---------- `x` reads `x` here
    |
    = hint: let `x` read its own previous value: write `x = delay False x && False`, where False is the initial value
  
  error[E0401]: the signal `q.g` needs its own value in the same instant
   --> needless.frob:5:5
    |
  5 |     q = if q.g > 0 then p { f = 1 } else p
    |     ^      ------- `q.g` reads `q.g` here
    |
    = hint: let `q.g` read its own previous value: add the equation `before = delay 0 q.g`, where 0 is the initial value, and read `before` here
  
  2 errors
  [1]

If the program only runs a loop that the library closes, the message shows the library's code:

  $ cat > closed.frob <<EOF
  > main :: SF Float Float
  > main = loop (arr (\(x, z) -> (x + z, x + z)))
  > EOF
  $ frobc check closed.frob 2>&1 | grep -A5 :::
     ::: closed.frob:2:1
      |
    2 | main = loop (arr (\(x, z) -> (x + z, x + z)))
      | --------------------------------------------- `loop` runs here
      |
      = hint: put a `delay` or an `integral` into the signal function inside the loop
