Deeply nested programs have a result, or a message if they exceed the limit of
10,000 levels; the stack never overflows. Each ends within 20 s of processor
time.

  $ within() { (ulimit -t "$1"; shift; exec "$@"); } # so many seconds of processor time
  $ compile() { { echo 'main :: SF Int Int'; cat; } > deep.frob; within 20 frobc compile deep.frob 2> message; }
  $ printf 'time,in\n0,1\n1,2\n' > in.csv
  $ trace() { compile && within 20 frobc trace deep.frob --engine interp --input in.csv 2> message | cut -d, -f2 | xargs; }
  $ repeat() { awk -v n="$1" -v s="$2" 'BEGIN { while (n-- > 0) printf "%s", s }'; }

A chain of 9,000 operators:

  $ { printf 'main = proc x -> '; repeat 9000 'x + '; echo x; } | trace
  out 9001 18002

9,000 parentheses:

  $ { printf 'main = proc x -> '; repeat 9000 '('; printf x; repeat 9000 ')'; echo; } | trace
  out 1 2

4,000 nested calls, and 9,000 with `$`:

  $ { printf 'main = proc x -> '; repeat 4000 'negate ('; printf x; repeat 4000 ')'; echo; } | trace
  out 1 2
  $ { printf 'main = proc x -> '; repeat 9000 'negate $ '; echo x; } | trace
  out 1 2

9,000 `let`s, 9,000 `if`s, 3,000 `case`s:

  $ awk 'BEGIN { printf "main = proc x -> let a0 = x in "
  >   for (i = 1; i < 9000; i++) printf "let a%d = a%d + 1 in ", i, i - 1
  >   print "a8999" }' | trace
  out 9000 9001
  $ awk 'BEGIN { printf "main = proc x -> "
  >   for (i = 3; i < 9000; i++) printf "if x == %d then %d else ", i, i + 1
  >   print "x * 7" }' | trace
  out 7 14
  $ awk 'BEGIN { n = 3000; printf "main = proc x -> "
  >   for (i = 2; i < n; i++) printf "(case x of %d -> %d ; _ -> ", i, i + 1
  >   printf "x * 7"; for (i = 2; i < n; i++) printf ")"; print "" }' | trace
  out 7 3

2,000 nested procs, 5,000 signal functions in a row:

  $ awk 'BEGIN { n = 2000; printf "main = proc a0 -> "
  >   for (i = 1; i < n; i++) printf "(proc a%d -> ", i
  >   printf "identity a%d", n - 1
  >   for (i = n - 1; i > 0; i--) printf ") a%d", i - 1
  >   print "" }' | trace
  out 1 2
  $ { printf 'main = '; repeat 5000 'arr (+ 1) >>> '; echo 'identity'; } | trace
  out 5001 5002

Patterns and types nested 50 levels deep:

  $ { printf 'f p = case p of\n    '; repeat 50 'Just ('; printf p; repeat 50 ')'; printf ' -> p\n    _ -> 2\n'
  >   printf 'main = proc x -> f ('; repeat 50 'Just ('; printf x; repeat 50 ')'; echo ')'; } | trace
  out 1 2

Types that grow too large to write out:

  $ { printf 'main = proc x -> '; repeat 9000 'id '; echo x; } | compile; echo $?; head -1 message
  1
  error[E0316]: the type of this expression is too large
  $ { printf 'main = proc x -> fromMaybe x (Just ('; repeat 2000 'Just ('; printf x; repeat 2000 ')'; echo '))'; } | compile; echo $?; grep -c E0316 message
  1
  1
  $ awk 'BEGIN { print "type T0 = (Int, Int)"
  >   for (i = 0; i < 100; i++) printf "type T%d = (T%d, T%d)\n", i + 1, i, i
  >   print "main :: SF Int Int\nmain = proc x -> x\ndata D = D T100" }' > doubles.frob
  $ within 20 frobc check doubles.frob
  error[E0316]: the type of a field is too large
     --> doubles.frob:104:12
      |
  104 | data D = D T100
      |            ^^^^
      |
      = note: a type can have at most 20000 parts, nested at most 500 levels deep
  
  1 error
  [1]

Beyond the limit:

  $ { printf 'main = proc x -> '; repeat 200000 '('; printf x; repeat 200000 ')'; echo; } | compile; echo $?; head -1 message
  1
  error[E0106]: this is nested more than 10000 levels deep
  $ { printf 'main = proc x -> '; repeat 200000 'x + '; echo x; } | compile; echo $?; head -1 message
  1
  error[E0106]: this is nested more than 10000 levels deep
  $ { printf 'main = proc x -> '; repeat 200000 'if x > 0 then x else '; echo x; } | compile; echo $?; head -1 message
  1
  error[E0106]: this is nested more than 10000 levels deep
  $ { printf 'main = '; repeat 200000 'proc x -> '; echo x; } | compile; echo $?; head -1 message
  1
  error[E0106]: this is nested more than 10000 levels deep
