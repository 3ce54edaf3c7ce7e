The report lists the events that cause switches. It shows which of them cannot
occur at the first instant of the mode that they end, and which signal function
is the reason. Events of the library:

  $ events() { frobc report "$1" | sed -n '/^switching events/,$p'; }
  $ cat > library.frob <<'FROB'
  > a, b, c, d, e, f :: SF (Float, Time) Float
  > a = switch (proc (x, _) -> (x, edge (x > 1))) (\_ -> b)
  > b = switch (proc (x, _) -> (2 * x, after 1[s] ())) (\_ -> c)
  > c = switch (proc (x, _) -> (3 * x, every 1[s] ())) (\_ -> d)
  > d = switch (proc (x, _) -> (4 * x, notYet (when (x > 3)))) (\_ -> e)
  > e = switch (proc (x, _) -> (5 * x, change (x > 3))) (\_ -> f)
  > f = switch (proc (x, _) -> (6 * x, when (x > 3))) (\_ -> a)
  > main = a
  > FROB
  $ events library.frob
  switching events in the first instant of their mode
    from a to b    cannot occur: `edge`    library.frob:2
    from b to c    cannot occur: `after`   library.frob:3
    from c to d    cannot occur: `every`   library.frob:4
    from d to e    cannot occur: `notYet`  library.frob:5
    from e to f    cannot occur: `change`  library.frob:6
    from f to a    may occur               library.frob:7

Events that a program builds from them, or only from `delay` and `time`:

  $ cat > own.frob <<'FROB'
  > later :: SF (Event a) (Event a)
  > later = proc e -> gate e (delay False True)
  > 
  > rest :: Time -> SF a (Event ())
  > rest q = proc _ -> if time () > q then Event () else NoEvent
  > 
  > a, b, c :: SF Float Float
  > a = switch (proc x -> (x, later (when (x > 1)))) (\_ -> b)
  > b = switch (proc x -> (2 * x, rest 1[s] ())) (\_ -> c)
  > c = switch (proc x -> (3 * x, if delay False (x > 3) then Event () else NoEvent)) (\_ -> a)
  > main = a
  > FROB
  $ events own.frob
  switching events in the first instant of their mode
    from a to b    cannot occur: `later`  own.frob:8
    from b to c    cannot occur: `rest`   own.frob:9
    from c to a    cannot occur           own.frob:10

Events that depend on parameters: the range of a time that is passed on is known.

  $ cat > parameters.frob <<'FROB'
  > wait, hurry :: Time -> SF Float Float
  > wait q = switch (proc x -> (x, after (max 1[ms] q) ())) (\_ -> hurry (q / 2))
  > hurry q = switch (proc x -> (-x, after (q - 3[s]) ())) (\_ -> wait (q + 1[s]))
  > main = wait 1[s]
  > FROB
  $ events parameters.frob
  switching events in the first instant of their mode
    from wait to hurry    cannot occur: `after`  parameters.frob:2
    from hurry to wait    may occur              parameters.frob:3
