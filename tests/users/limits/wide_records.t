Each number of a record is a separate signal, so many values of a large record are too much to
compile. The message names the record, the number of its numbers, and what to do. Steps are counted,
not time.

  $ check() { cat > "$1.frob"; (ulimit -t 30; exec frobc check "$1.frob" 2>&1) | cut -c 1-120; }
  $ list() { python3 -c 'import sys; n, s, between = sys.argv[1:]; print(between.replace("\\n", "\n").join(s.replace("#", str(i)).replace("@", str(i + 1)) for i in range(int(n))), end="")' "$@"; }
  $ record() { printf 'data R = R { '; list 5000 'f#' ', '; printf ' :: Float }\n'; }

1,000 updates of a record with 5,000 fields, in a signal function and in a function:

  $ { record; printf 'main :: SF R Float\nmain = proc r0 -> r1000.f0 where\n'; list 1000 '    r@ = r# { f# = 1 }' '\n'; echo; } | check updates
  error[E0413]: the record updates up to here write more than 1000000 fields, which is too many to compile
     --> updates.frob:204:12
      |
  204 |     r201 = r200 { f200 = 1 }
      |            ^^^^^^^^^^^^^^^^^
      |
      = note: an update writes all fields of its record; `R` has 5000 fields and 201 updates so far
      = hint: change several fields in one update: `r { a = 1, b = 2 }`
      = hint: put fields that change together into a smaller record, or keep them in an array
  
  1 error
  $ { record; printf 'main :: SF R Float\nmain = proc r -> (f r).f0\nf :: R -> R\nf r0 = let\n'; list 1000 '    r@ = r# { f# = 1 }' '\n'; printf '\n  in r1000\n'; } | check pure | head -1
  error[E0413]: the record updates up to here write more than 1000000 fields, which is too many to compile

Fewer updates, but as many values; choices between records, and calls:

  $ { record; printf 'main :: SF R Float\nmain = proc r0 -> r190.f0 where\n'; list 190 '    r@ = r# { f# = 1 }' '\n'; echo; } | check fewer | head -1
  error[E0413]: more than 161 equations and calls define values of the type `R`
  $ { record; printf 'main :: SF R Float\nmain = proc r0 -> r1000.f0 where\n'; list 1000 '    r@ = if r0.f0 > # then r# else r0' '\n'; echo; } | check choices
  error[E0413]: more than 165 equations and calls define values of the type `R`
      --> choices.frob:3:1
       |
     3 | main = proc r0 -> r1000.f0 where
       | ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
  ...
  1003 |     r1000 = if r0.f0 > 999 then r999 else r0
       |     ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
       |
       = note: each of these values consists of 5000 numbers, and each number gets its own equation
       = hint: change several fields at once: `r { a = 1, b = 2 }`
       = hint: keep many numbers of one type in an array: `Array 1000 Float` is one value
  
  1 error
  $ { record; printf 's :: SF R R\ns = proc r -> if r.f0 > 1 then r else r { f1 = 2 }\nmain :: SF R Float\nmain = proc r0 -> r1000.f0 where\n'; list 1000 '    r@ = s r#' '\n'; echo; } | check calls | head -1
  error[E0413]: more than 162 equations and calls define values of the type `R`

One update of all fields, and a few dozen updates of a record, are accepted:

  $ { record; printf 'main :: SF R R\nmain = proc r -> r { '; list 5000 'f# = #' ', '; printf ' }\n'; } | check all
  $ { record; printf 'main :: SF R Float\nmain = proc r0 -> r50.f0 where\n'; list 50 '    r@ = r# { f# = 1 }' '\n'; echo; } | check dozens

Reading and writing each field of a record takes time in proportion to their number:

  $ { printf 'data T = T { '; list 60000 'f#' ', '; printf ' :: Float }\nread :: T -> Array 60000 Float\nread t = ['; list 60000 't.f#' ', '
  >   printf ']\nwrite :: T -> T\nwrite t = t { '; list 60000 'f# = #' ', '; printf ' }\nmain :: SF Float Float\nmain = proc x -> x\n'; } | check fields

Nested records, 1,500 levels deep:

  $ { printf 'data R0 = R0 { a0 :: Float }\n'; list 1500 'data R@ = R@ { a@ :: Float, r# :: R# }' '\n'; printf '\nmain :: SF R1500 Float\nmain = proc r -> r.a1500\n'; } | check levels
  error[E0316]: a value of the type `R500` would contain data nested more than 500 levels deep
      --> levels.frob:1503:1
       |
  1503 | main = proc r -> r.a1500
       | ^^^^^^^^^^^^^^^^^^^^^^^^
       |
       = hint: nest the records less deeply
  
  1 error

A task that keeps the results of 3,000 others until its end, and switches in each other's first
modes:

  $ { printf 'main :: SF Float (Either Float Float)\nmain = runTask (do\n'; list 3000 '    x# <- t' '\n'; printf '\n    return (x0'; list 2999 ' + x@' ''
  >   printf '))\nt :: Task Float Float Float\nt = mkTask (proc x -> (x, tag (edge (x > 1)) x))\n'; } | check results | head -1
  error[E0413]: the state machine of `main` has too many modes: more than 946
  $ { printf 'main :: SF Float Float\nmain = s1000\ns0 :: SF Float Float\ns0 = delay 0\n'
  >   list 1000 's@ = switch (proc x -> (y, edge (x > #)) where y = s# x) (\_ -> s#)' '\n'; echo; } | check switches | head -1
  error[E0413]: the state machine of `s403` has too many modes: more than 142

Long programs that do not grow are compiled: 5,000 signal functions in a chain, 3,000 tasks in a
sequence.

  $ { printf 'main :: SF Float Float\nmain = '; list 5000 'delay #' ' >>> '; echo; } | check chain
  $ { printf 'main :: SF Float (Either Float ())\nmain = runTask (do\n'; list 3000 '    t' '\n'; printf '\n    return ())\nt :: Task Float Float Float\nt = mkTask (proc x -> (x, tag (edge (x > 1)) x))\n'; } | check tasks
