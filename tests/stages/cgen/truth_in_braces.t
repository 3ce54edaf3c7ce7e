In an array initializer, C++ requires a truth value to be a `bool`: if a compiler would warn that it
knows the value of a condition, the condition is a function call.

  $ export CPATH=$(dirname "$(command -v frobc)")/../share/frobc/include
  $ check () {
  >   for c in "gcc -std=c99" "clang -std=c99" "g++ -x c++ -std=c++17" "clang++ -x c++ -std=c++17"; do
  >     $c -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -ffp-contract=off -fsyntax-only $1.c
  >   done
  >   frobc trace $1.frob --input $1.csv > c.csv
  >   frobc trace $1.frob --input $1.csv --engine interp | cmp - c.csv
  > }
  $ cat > array.frob <<'END'
  > main :: SF (Int, Bool, Bool, Bool, Int) Bool
  > main = proc (n, b, c, d, k) -> at k False
  >     [n <= 1 && n > 3, b && c, if d then b && d else n > 7, if c then n < 2 && n > 4 else b]
  > END
  $ frobc compile array.frob && grep '{{' array.c | sed "s, */\*.*,,"
      const struct array_bool_4 t1 = {{frob_both(n <= 1, n > 3), b && c, d ? b && d : n > 7,
  $ cat > array.csv <<'END'
  > time,in.1,in.2,in.3,in.4,in.5
  > 0,2,true,true,true,0
  > 1,2,true,true,true,1
  > 2,8,false,true,true,2
  > 3,3,true,true,false,3
  > 4,3,true,false,true,3
  > END
  $ check array
