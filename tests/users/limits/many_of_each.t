Programs with very many definitions of one kind, or with very wide ones, are compiled, or rejected
in a few lines. Each call may take 30 s of processor time, about ten times what it needs. An
algorithm that is quadratic in the number takes longer than that.

  $ within() { (ulimit -t "$1"; shift; exec "$@"); } # so many seconds of processor time
  $ check() { cat > "$1.frob"; within 30 frobc check "$1.frob" > message 2>&1; echo "status $?"; cut -c 1-100 message | sed -n "${2:-1,2}p"; }
  $ main='main :: SF Float Float\nmain = proc x -> x\n'
  $ list() { python3 -c 'import sys; n, s, between = sys.argv[1:]; print(between.replace("\\n", "\n").join(s.replace("#", str(i)) for i in range(int(n))), end="")' "$@"; }

5,000 parameters:

  $ { list 5000 'param p# :: Float = #' '\n'; printf '\nmain :: SF Float Float\nmain = proc x -> x'; list 5000 ' + p#' ''; echo; } | check params
  status 0

Mistakes on one line: 40,000 with the same name, and 9,000 with different names. Text output shows
the first 100 of them, JSON the first 1,000, and then the number of omitted ones.

  $ { printf 'main :: SF Float Float\nmain = proc x -> [x'; list 40000 ', z' ''; echo ']'; } | check same
  status 1
  error[E0205]: unknown name `z`
   --> same.frob:2:22
  $ { printf 'main :: SF Float Float\nmain = proc x -> x'; list 9000 ' + z#' ''; echo; } | check names '$'
  status 1
  9000 errors; the first 100 are shown
  $ grep -c '^error' message
  100
  $ within 30 frobc check --format json names.frob 2>&1 | wc -l
  1001
  $ { printf 'main :: SF Float Float\nmain = proc x -> z where\n'; list 150 '    y# = x' '\n'; echo; } | check unread '$'
  status 1
  1 error
  $ { printf 'main :: SF Float Float\nmain = proc x -> x where\n'; list 150 '    y# = x' '\n'; echo; } | check unread '$'
  status 0
  150 warnings; the first 100 are shown

5,000 modules that do not exist, 100,000 clauses of one function, and a name of a million letters:

  $ { list 5000 'import M#' '\n'; printf "\n$main"; } | check modules '$'
  status 1
  5000 errors; the first 100 are shown
  $ { list 100000 'f # = #' '\n'; printf "\n$main"; } | check clauses
  status 1
  error[E0115]: `f` is defined by several clauses
    --> clauses.frob:2:1
  $ { printf 'x'; list 1000000 y ''; printf ' = 1\n'; printf "$main"; } | check letters
  status 1
  error[E0105]: a name has at most 1000 characters, but this one has 1000001
   --> letters.frob:1:1

5,000 existing modules, each of which imports the previous one:

  $ mkdir chain && (cd chain && echo 'v0 = 1' > M0.frob && for i in $(seq 4999); do echo "import M$((i - 1))
  > v$i = v$((i - 1)) + 1" > M$i.frob; done)
  $ (cd chain && printf 'import M4999\nmain :: SF Float Float\nmain = proc x -> x + v4999\n' | check main)
  status 0

200,000 branches, guards, fields and items of an import:

  $ { printf 'f :: Int -> Int\nf x = case x of\n'; list 200000 '    # -> #' '\n'; printf '\n    _ -> 1\n'; printf "$main"; } | check cases
  status 0
  $ { printf 'f :: Int -> Int\nf x\n'; list 200000 '    | x > # = #' '\n'; printf '\n    | otherwise = 1\n'; printf "$main"; } | check guards
  status 0
  $ { printf 'data T = T'; list 200000 ' Float' ''; printf "\n$main"; } | check fields
  status 0
  $ { printf 'import Control ('; list 200000 'a#' ', '; printf ")\n$main"; } | check imports '$'
  status 1
  200000 errors; the first 100 are shown

If the stack is not allowed to grow, the message has a place and says what to do:

  $ (ulimit -S -s 1024; ulimit -H -s 1024; OCAMLRUNPARAM=l=100000 within 30 frobc check cases.frob)
  error[E0106]: the program is too large, or nested too deeply, for the stack of frobc
   --> cases.frob:2:1
    |
  2 | f x = case x of
    | ^^^^^^^^^^^^^^^
    |
    = note: this is its largest definition, with 3977807 characters
    = hint: split it into several definitions
    = hint: or run `ulimit -s unlimited` to allow a larger stack
  
  1 error
  [1]

Programs that frobc starts have the stack limit with which frobc was started. The cache is empty, so
frobc starts the C compiler:

  $ (export XDG_CACHE_HOME="$PWD/cache"; ulimit -S -s 4096; frobc run --help > help.txt; cat > cc <<'END'
  > #!/bin/sh
  > ulimit -s >> stack
  > exec gcc "$@"
  > END
  > chmod +x cc; printf "$main" > own.frob; CC="$PWD/cc" frobc build --shared own.frob -o own.so && sort -u stack)
  4096

A cycle of 6,000 modes, and 1,000 nested switches:

  $ { list 6000 's# :: SF Float Float' '\n'; echo; awk 'BEGIN { for (i = 0; i < 6000; i++) printf "s%d = switch (proc x -> (x + %d, edge (x > %d))) (\\_ -> s%d)\n", i, i, i, (i + 1) % 6000 }'
  >   printf 'main :: SF Float Float\nmain = s0\n'; } > circle.frob
  $ within 30 frobc compile circle.frob
  $ { printf 'main :: SF Float Float\nmain = '; list 1000 'switch (proc x -> (x + #, edge (x > #))) (\_ -> ' ''; printf identity; list 1000 ')' ''; echo; } > switches.frob
  $ within 30 frobc compile switches.frob
