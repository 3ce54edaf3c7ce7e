The time to compile large programs is proportional to their size; a minute of
processor time is far more than they need.

  $ within() { (ulimit -t "$1"; shift; exec "$@"); } # so many seconds of processor time
  $ trace() { printf 'time,in\n0,1\n' | within 60 frobc trace "$1.frob" --input -; }

100,000 lines with one definition each, all of which the program needs:

  $ awk 'BEGIN { print "f0 :: Int -> Int\nf0 x = x"
  >   for (i = 1; i < 99996; i++) printf "f%d x = f%d x + %d\n", i, int(i / 2), i
  >   print "main :: SF Int Int\nmain = proc x -> f99995 x" }' > lines.frob
  $ wc -l < lines.frob
  99999
  $ trace lines
  time,out
  0.000000000,199982
  $ awk 'BEGIN { for (i = 99995; i > 0; i = int(i / 2)) sum += i; print sum + 1 }'
  199982

20,000 equations of one signal function, the last one first, and a chain of as
many delays:

  $ awk 'BEGIN { print "main :: SF Int Int\nmain = proc x -> y19999 where"
  >   for (i = 19999; i > 0; i--) printf "    y%d = y%d + x * %d\n", i, i - 1, i
  >   print "    y0 = x" }' > equations.frob
  $ within 60 frobc compile equations.frob
  $ awk 'BEGIN { print "main :: SF Int Int\nmain = proc x -> y19999 where\n    y0 = x"
  >   for (i = 1; i < 20000; i++) printf "    y%d = delay %d y%d\n", i, i, i - 1 }' > delays.frob
  $ within 60 frobc compile delays.frob

5 MB of documented definitions with signatures:

  $ awk 'BEGIN { for (i = 1; i < 25; i++) words = words " words"
  >   print "main :: SF Float Float\nmain = proc x -> f25000 x\nf0 x = x"
  >   for (i = 1; i <= 25000; i++)
  >     printf "-- |%s\nf%d :: Float -> Float\nf%d x = if x > %d then x * %d.5 else f%d (x - %d)\n", \
  >       words, i, i, i, i, int(i / 2), i }' > megabytes.frob
  $ test $(wc -c < megabytes.frob) -gt 5000000
  $ trace megabytes
  time,out
  0.000000000,-49993
  $ awk 'BEGIN { x = 1; for (i = 25000; i > 0; i = int(i / 2)) { if (x > i) { x *= i + 0.5; break } x -= i } print x }'
  -49993

A sum of 3,000 constructors, a record of 3,000 fields, a tuple of 3,000
components:

  $ awk 'BEGIN { n = 3000; printf "data T = C0"; for (i = 1; i < n; i++) printf " | C%d", i
  >   print "\nmain :: SF T Int\nmain = proc t -> case t of"
  >   for (i = 0; i < n; i++) printf "    C%d -> %d\n", i, i * i }' > constructors.frob
  $ within 60 frobc compile constructors.frob
  $ printf 'time,in\n0,C1234\n' | within 60 frobc trace constructors.frob --input -
  time,out
  0.000000000,44100
  $ awk 'BEGIN { n = 3000; printf "data T = T { f0"; for (i = 1; i < n; i++) printf ", f%d", i
  >   printf " :: Int }\nmain :: SF Int T\nmain = proc x -> T { f0 = x"
  >   for (i = 1; i < n; i++) printf ", f%d = x + %d", i, i; print " }" }' > fields.frob
  $ printf 'time,in\n0,1\n' | within 60 frobc trace fields.frob --input - | tail -1 | cut -d, -f3000-
  2999,3000
  $ awk 'BEGIN { n = 3000; printf "main = proc x -> (x + 1"; for (i = 1; i < n; i++) printf ", x"; print ")"
  >   printf "main :: SF Int (Int"; for (i = 1; i < n; i++) printf ", Int"; print ")" }' > tuple.frob
  $ printf 'time,in\n0,1\n' | within 60 frobc trace tuple.frob --input - | tail -1 | cut -d, -f1-3
  0.000000000,2,1

As many mistakes as lines:

  $ awk 'BEGIN { for (i = 0; i < 100000; i++) printf "v%d = 1[m] + 2[s]\n", i }' > mistakes.frob
  $ within 60 frobc check mistakes.frob 2> message; echo $?; tail -1 message
  1
  100000 errors; the first 100 are shown

20,000 equations in one loop are checked as fast as without it:

  $ awk 'BEGIN { n = 20000; print "main :: SF Float Float\nmain = proc _ -> y0 where"
  >   for (i = 0; i < n; i++) printf "    y%d = y%d + 1\n", i, (i + 1) % n }' > ring.frob
  $ within 20 frobc check ring.frob 2> message; echo $?; head -1 message
  1
  error[E0401]: the signal `y0` needs its own value in the same instant

5,000 equations in one loop, and 5,000 functions that call each other, are
rejected in a few lines:

  $ awk 'BEGIN { n = 5000; print "main :: SF Int Int\nmain = proc x -> y0 where"
  >   for (i = 0; i < n; i++) printf "    y%d = y%d + x\n", i, (i + 1) % n }' > loop.frob
  $ within 60 frobc check loop.frob 2> message; echo $?; head -1 message; test $(wc -l < message) -lt 100
  1
  error[E0401]: the signal `y0` needs its own value in the same instant
  $ awk 'BEGIN { n = 5000; for (i = 0; i < n; i++) printf "f%d x = f%d x + 1\n", i, (i + 1) % n
  >   print "main :: SF Int Int\nmain = proc x -> f0 x" }' > calls.frob
  $ within 60 frobc check calls.frob 2> message; echo $?; head -1 message; test $(wc -l < message) -lt 100
  1
  error[E0410]: `f0` calls itself through other definitions
