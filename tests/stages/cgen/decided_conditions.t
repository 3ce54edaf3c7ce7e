Generated code does not test a condition again inside a branch that has decided it. The first mode
leaves its outputs unwritten if it ends, so they are computed inside `if (!ends)`.

  $ export CPATH=$(dirname "$(command -v frobc)")/../share/frobc/include
  $ cat > early.frob <<'END'
  > main :: SF Float (Float, Bool)
  > main = switch (proc x -> ((if ends x then 0 else 2 * x, ends x && x < 9), when (ends x) `tag` x)) (\k -> proc x -> (k, x > 0))
  > 
  > ends :: Float -> Bool
  > ends x = sin x > 0.5
  > END
  $ frobc compile --lint early.frob && python3 decided.py early.c
  $ sed -n '/^static.*early_main_main(/,/^}/p' early.c | sed 's, */\*.*,,'
  static inline void early_main_main(double x, double *out_1, bool *out_2, bool *out_3,
          double *out_x)
  {
      const bool t1 = frob_sin(x) > 0.5;
      *out_3 = t1;
      *out_x = x;
      if (!t1) {
          *out_1 = 2.0 * x;
          *out_2 = false;
      }
  }

The constructor of a value is known inside a branch that has tested it.

  $ cat > opened.frob <<'END'
  > main :: SF (Maybe Float) Float
  > main = switch (proc m -> (y m, when (maybe False (const True) m) `tag` 7)) (\k -> constant k)
  > 
  > y :: Maybe Float -> Float
  > y m = case m of
  >     Nothing -> 1
  >     Just v -> cos v * sin v
  > END
  $ frobc compile --lint opened.frob
  $ sed -n '/^static.*opened_main_main(/,/^}/p' opened.c | sed 's, */\*.*,,'
  static inline void opened_main_main(struct opened_maybe_float m, double *out_2, bool *out_3)
  {
      const bool t1 = m.tag == OPENED_MAYBE_FLOAT_NOTHING;
      const bool t2 = !t1;
      *out_3 = t2;
      if (!t2) {
          *out_2 = 1.0;
      }
  }
  $ for cc in gcc clang; do
  >   $cc -std=c99 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -c early.c opened.c
  > done
