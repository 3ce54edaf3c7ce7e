In the braces of an array or of a struct a truth value has to be a `bool`, or C++ does not
take it: it is no `&` there, which is an `int`, nor a choice with one in a branch.

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
      const struct array_bool_4 t1 = {{((n <= 1) & (n > 3)) != 0, b && c, d ? b && d : n > 7,
  $ cat > array.csv <<'END'
  > time,in.1,in.2,in.3,in.4,in.5
  > 0,2,true,true,true,0
  > 1,2,true,true,true,1
  > 2,8,false,true,true,2
  > 3,3,true,true,false,3
  > 4,3,true,false,true,3
  > END
  $ check array

A function of so many parameters is given them in a struct.

  $ list () { seq -s "$1" -f "$2%g" 33; }
  $ cat > struct.frob <<END
  > f :: Bool -> Bool -> $(list ' -> ' 'Vec ' | sed 's,Vec [0-9]*,Float,g') -> Float
  > f p q $(list ' ' a) = if p then (if q then a1 else $(list ' + ' 'abs a')) else $(list ' * ' a)
  > 
  > main :: SF (Bool, Bool, Int, $(list ', ' 'Vec ' | sed 's,Vec [0-9]*,Float,g')) (Float, Float)
  > main = proc (b, c, n, $(list ', ' x)) -> (f (b && c) (if n > 3 then b && n < 7 else c) $(list ' ' x), f (n <= 1 && n > 3) c $(list ' ' x))
  > END
  $ frobc compile struct.frob && grep 'given = {' struct.c | sed "s/, x1, .*//"
      struct struct_f_in struct_f_given = {b && c, t1 ? b && n < 7 : c
  $ {
  >   echo "time,$(seq -s , -f in.%g 36)"
  >   for k in 0 1 2 3; do echo "$k,true,false,$((3 * k)),$(list , $k.)"; done
  > } > struct.csv
  $ check struct
