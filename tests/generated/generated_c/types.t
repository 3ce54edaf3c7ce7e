The header declares the types that the interface uses: here the output's Seen. The source declares
the types that only functions use (Rule). Types that only dead code uses (Way) are not declared.

  $ cat > pick.frob <<'FROB'
  > data Seen = Lost | At Distance
  > 
  > data Rule = Below Distance | Above Distance
  > 
  > data Way = Forward | Backward
  > 
  > rule :: Distance -> Rule
  > rule x = if x < 2[m] then Below (x * x * x / 3[m^2]) else Above (x * x / 7[m] + x + 1[m])
  > 
  > holds :: Rule -> Distance -> Bool
  > holds r x = case r of
  >     Below limit -> x * x < limit * limit
  >     Above limit -> x > limit * 2
  > 
  > way :: Distance -> Way
  > way x = if x < 0 then Backward else Forward
  > 
  > main :: SF (Distance, Distance) (Seen, Bool)
  > main = proc (x, y) -> (if x > 5[m] then Lost else At x, holds r x || holds r (x + y)) where
  >     r = latest y
  > 
  > latest :: SF Distance Rule
  > latest = proc y -> if delay False (y > 3[m]) then rule (y + 1[m]) else rule (sin (y / 1[m]) * y)
  > FROB
  $ frobc compile pick.frob
  $ grep '^struct.*{' pick.h pick.c
  pick.h:struct pick_seen {
  pick.h:struct pick_input {
  pick.h:struct pick_output {
  pick.h:struct pick_state {
  pick.c:struct pick_rule {
  $ grep '^    PICK_' pick.h pick.c
  pick.h:    PICK_SEEN_LOST,
  pick.h:    PICK_SEEN_AT
  pick.c:    PICK_RULE_BELOW,
  pick.c:    PICK_RULE_ABOVE

The header also declares a type whose value the state contains. It also defines the tags of a type
inside such a value, because they are the values of its member `t0`.

  $ cat > kept.frob <<'FROB'
  > main :: SF Float (Maybe (Either Float Bool))
  > main = proc x -> delay Nothing (if x > 1 then Just (Left x) else if x < 0 then Just (Right (x < -2)) else Nothing)
  > FROB
  $ frobc compile kept.frob
  $ grep '^struct.*{' kept.h kept.c
  kept.h:struct kept_either_float_bool {
  kept.h:struct kept_maybe_either_float_bool {
  kept.h:struct kept_input {
  kept.h:struct kept_output {
  kept.h:struct kept_state {
  $ grep '^    KEPT_' kept.h
      KEPT_EITHER_FLOAT_BOOL_LEFT,
      KEPT_EITHER_FLOAT_BOOL_RIGHT
      KEPT_MAYBE_EITHER_FLOAT_BOOL_NOTHING,
      KEPT_MAYBE_EITHER_FLOAT_BOOL_JUST

In single precision, and with the user's C code, that code and the header have the types of imported
definitions.

  $ cat > own.frob <<'FROB'
  > data Seen = Lost | At Distance
  > foreign look :: Distance -> Seen = "look"
  > 
  > main :: SF Distance Bool
  > main = proc x -> case look x of
  >     Lost -> False
  >     At d -> d > x
  > FROB
  $ for real in double float; do frobc compile --real $real own.frob -o $real; grep '^struct.*{' $real/own.h $real/own.c; done
  double/own.h:struct frob_seen {
  double/own.h:struct own_input {
  double/own.h:struct own_output {
  double/own.h:struct own_state {
  float/own.h:struct frob_seen {
  float/own.h:struct own_input {
  float/own.h:struct own_output {
  float/own.h:struct own_state {
  float/own.c:struct own_seen {

The declarations suffice for C and C++.

  $ folder=$(dirname "$(dirname "$(command -v frobc)")")/share/frobc/include
  $ for file in pick kept double/own float/own; do
  >   for cc in "gcc -std=c99" "clang -std=c99" "g++ -x c++ -std=c++17"; do
  >     $cc -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -O2 -I "$folder" -c $file.c -o out.o || echo "$cc: $file"
  >   done
  > done
