A definition becomes at most one C function for each specialization, however often
it is used: numbers and units are no reason for another, other signal functions and
functions are.

  $ steps() { awk '/^\/\* .*, .*\.frob:[0-9]+ \*\/$/ { def = $2 " " $3; next }
  >   /^[a-z].*\(/ && def != "" && !/_reset\(/ { print def } { def = "" }' "$1" | sed 's/:.*//' | sort | uniq -c; }
  $ cat > uses.frob <<'FROB'
  > import Control
  > 
  > smoothed :: SF Float Float -> SF Float Float
  > smoothed sf = proc x -> lowPass 0.3[s] (sf (rateLimit 1[1/s] (sf x)))
  > 
  > main :: SF (Float, Float[m], Bool) (Float, Float, Float[m], Bool)
  > main = proc (x, d, b) ->
  >     ( smoothed previous x + smoothed previous (x + 1)
  >     , smoothed (arr abs) x + smoothed (arr abs) (x + 1)
  >     , lowPass 1[s] (lowPass 2[s] d)
  >     , debounce 1[s] b || debounce 2[s] (debounce 3[s] b)
  >     )
  > FROB
  $ frobc compile uses.frob
  $ steps uses.c
        1 debounce, Control.frob
        1 lowPass, Control.frob
        1 main, uses.frob
        1 rateLimit, Control.frob
        2 smoothed, uses.frob

A definition that uses another twice, twenty times over, has a million of the first
one's states, and no more code for it: one function for each level.

  $ { echo 'f0 :: SF Float Float'; echo 'f0 = proc x -> x + delay 0 x'
  >   for n in $(seq 1 20); do echo "f$n = f$((n - 1)) >>> f$((n - 1))"; done
  >   echo 'main = f20'; } > levels.frob
  $ frobc compile levels.frob
  $ grep -c '^[a-z].*_step(' levels.c
  10
  $ frobc report levels.frob | sed -n '2s/Prelude.*/Prelude/p'
    >>>                            8388608                 Prelude
  $ sed 's/^main = f20/main = f10/' levels.frob > ten.frob
  $ frobc compile ten.frob
  $ echo $(($(wc -l < levels.c) - $(wc -l < ten.c))) more lines for ten more levels
  95 more lines for ten more levels
