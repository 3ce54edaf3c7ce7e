Names that begin like macros of the headers, in a program whose name does so:

  $ export CPATH=$(dirname "$(command -v frobc)")/../share/frobc/include
  $ cat > m.frob <<EOF
  > main :: SF Int (Maybe Int)
  > main = arr Just
  > EOF
  $ cp m.frob integer.frob
  $ frobc compile m.frob -o .
  $ frobc compile integer.frob -o .
  $ cc -std=c99 -Wall -Werror -c m.c integer.c
