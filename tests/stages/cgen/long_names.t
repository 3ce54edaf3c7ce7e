Long names of deeply nested types are cut at a word and numbered; a comment above contains the
complete name.

  $ export CPATH=$(dirname "$(command -v frobc)")/../share/frobc/include
  $ cat > deep.frob <<'FROB'
  > type Two a = Maybe (Maybe a)
  > type Eight a = Two (Two (Two (Two a)))
  > 
  > main :: SF (Two (Eight Float)) (Two (Eight Float))
  > main = delay Nothing
  > FROB
  $ frobc compile deep.frob
  $ grep "^struct deep_maybe" deep.h | tail -4
  struct deep_maybe_maybe_maybe_maybe_maybe_maybe_maybe_float {
  struct deep_maybe_maybe_maybe_maybe_maybe_maybe_maybe_maybe {
  struct deep_maybe_maybe_maybe_maybe_maybe_maybe_maybe_maybe_2 {
  struct deep_maybe_maybe_maybe_maybe_maybe_maybe_maybe_maybe_3 {
  $ grep -B12 "^struct deep_maybe_maybe_maybe_maybe_maybe_maybe_maybe_maybe_2 {" deep.h | grep "Maybe"
  /* Maybe (Maybe (Maybe (Maybe (Maybe (Maybe (Maybe (Maybe (Maybe Float)))))))) */
  $ gcc -std=c99 -Wall -Wextra -Werror -c deep.c
  $ printf 'time,in\n0,Nothing\n1,Just (Just (Just Nothing))\n2,Nothing\n' > in.csv
  $ frobc trace deep.frob --input in.csv | cut -d, -f2
  out
  Nothing
  Nothing
  Just (Just (Just Nothing))
