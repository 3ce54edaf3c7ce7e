One function computes a minimum and a maximum. With constant limits, it is `frob_clamp`, unless a
limit is 0: then the sign of a zero matters. With a limit that cannot be negative, because it is only
used as a limit, it is `frob_limit_above_zero`.

  $ export CPATH=$(dirname "$(command -v frobc)")/../share/frobc/include
  $ cat > limits.frob <<'FROB'
  > import Control
  > 
  > main :: SF (Float, Float) (Array 8 Float)
  > main = proc (x, y) -> [limit (x * y) y, limit 2 x, clamp (-1) 3 y, min 3 (max (-1) x),
  >     max 4 (min 3 y), clamp 0 1 x, max (-most) (min most y) + most, limit (-2) y] where
  >     most = max 0 (x + y)
  > FROB
  $ frobc compile limits.frob --lint 2> warnings
  $ grep -o 'frob_[a-z_]*' limits.c | sort | uniq -c | sed 's/^ *//'
  2 frob_above_zero
  2 frob_at_least
  2 frob_at_most
  1 frob_below_zero
  2 frob_clamp
  1 frob_limit
  1 frob_limit_above_zero
  1 frob_max
  1 frob_negative_zero

The results are the interpreter's, also for NaN and zeros of both signs.

  $ awk 'BEGIN {
  >     n = split("0 -0.0 1 -1 0.5 -3 4 nan inf -inf 1e-320", v)
  >     print "time,in.1,in.2"
  >     for (i = 1; i <= n; i++) for (j = 1; j <= n; j++) { printf "%.2f,%s,%s\n", t, v[i], v[j]; t += 0.02 }
  > }' > in.csv
  $ frobc trace limits.frob --input in.csv > c.csv 2> warnings
  $ frobc trace limits.frob --input in.csv --engine interp 2> warnings | cmp - c.csv
  $ wc -l < c.csv
  122

A test for the first instant is omitted if the other condition cannot hold then. Ticks cannot,
unless they come in every instant.

  $ cat > marks.frob <<'FROB'
  > main :: SF Float (Event (), Event (), Bool, Bool)
  > main = proc x -> (every 0.1[s] (), every 0 (), started && elapsed 2[s] (), started && x > 0) where
  >     started = delay False True
  > FROB
  $ frobc compile marks.frob --dump=flow | grep '&&'
    _10 : Bool = started && _9
