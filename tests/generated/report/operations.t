The report counts operations by kind. Here: two additions, a multiplication, a
division, a comparison, a call of sin, and the reads and writes of `delay`.

  $ operations() { frobc report "$1" | sed -n '/^operations/,/^$/p' | grep -v ' 0$'; }
  $ cat > sum.frob <<EOF
  > main :: SF (Float, Float) (Float, Bool)
  > main = proc (x, y) -> (x + 2 * y - delay 0 y / 3, sin x < y)
  > EOF
  $ operations sum.frob
  operations of a step, at most
    additions                2
    multiplications          1
    divisions                1
    comparisons and choices  1
    loads of state           1
    stores of state          1
    calls of sin             1
  

For two branches, the larger number of each kind counts.

  $ cat > branches.frob <<EOF
  > main :: SF Float Float
  > main = proc x -> if x > 0 then sin x + cos x + 1 else sin (x * 2) * sin (x * 3) * 4
  > EOF
  $ operations branches.frob
  operations of a step, at most
    additions                2
    multiplications          4
    comparisons and choices  2
    calls of cos             1
    calls of sin             2
  

Callees count each time that they are called.

  $ cat > calls.frob <<EOF
  > norm :: Float -> Float -> Float
  > norm x y = sqrt (x * x + y * y)
  > 
  > main :: SF (Float, Float, Float) Float
  > main = proc (x, y, z) -> norm x (norm y z)
  > EOF
  $ operations calls.frob
  operations of a step, at most
    additions                2
    multiplications          4
    calls of sqrt            2
  

Large numbers are exact: a million additions.

  $ cat > million.frob <<EOF
  > f0 :: SF Float Float
  > f0 = proc x -> x + delay 0 x
  > EOF
  $ for n in $(seq 1 20); do echo "f$n = f$((n - 1)) >>> f$((n - 1))" >> million.frob; done
  $ echo 'main = f20' >> million.frob
  $ operations million.frob
  operations of a step, at most
    additions                1048576
    loads of state           1048576
    stores of state          1048576
  

A program whose state exceeds the memory of any machine is rejected.

  $ sed -i '/^main/d' million.frob
  $ for n in $(seq 21 60); do echo "f$n = f$((n - 1)) >>> f$((n - 1))" >> million.frob; done
  $ echo 'main = f60' >> million.frob
  $ operations million.frob
  error[E0413]: the program would store 1.15e+18 values from one instant to the next; the maximum is 134217728
     --> million.frob:63:1
      |
   63 | main = f60
      | ^^^^^^^^^^
      |
     ::: stdlib/Prelude.frob:252:26
      |
  252 | (>>>) f g = proc x -> g (f x)
      |                          --- `>>>` contains 2 of `>>>`
      |
      = note: each use of a signal function has its own copy of the state, including the state of all signal functions inside it
      = hint: to run a signal function only once, name its output in an equation, and use that name wherever you need the output
  
  1 error
  [1]

Time has a cost: the caller's dt is rounded to a whole number of nanoseconds.

  $ cat > clock.frob <<EOF
  > main :: SF () Time
  > main = time
  > EOF
  $ operations clock.frob
  operations of a step, at most
    additions                4
    multiplications          1
    divisions                1
    comparisons and choices  6
    conversions              2
    loads of state           3
    stores of state          2
  

A machine may step several modes within one instant: from far to near, and immediately back to far,
where `edge` ends the chain. For each kind, the largest number of all such chains counts: two
cosines in each step of far, one sine in a step of near.

  $ cat > modes.frob <<EOF
  > main :: SF Float Float
  > main = near
  > 
  > near :: SF Float Float
  > near = switch (proc x -> (sin x, when (x > 5))) (\_ -> far)
  > 
  > far :: SF Float Float
  > far = switch (proc x -> (cos x + cos (2 * x), edge (x < 4))) (\_ -> near)
  > EOF
  $ frobc report modes.frob | sed -n '/^modes/,$p'
  modes
    main, modes.frob:2: 2 modes (near, far); maximum number of steps within one instant: 3
  
  switching events in the first instant of their mode
    from near to far    may occur             modes.frob:5
    from far to near    cannot occur: `edge`  modes.frob:8
  $ operations modes.frob | grep calls
    calls of cos              4
    calls of sin              1
