Two comparisons of a number that are never both true, or never both false: clang
would warn about `&&` or `||` between them, so the C calls a function instead.

  $ export CPATH=$(dirname "$(command -v frobc)")/../share/frobc/include
  $ cat > contrary.frob <<'END'
  > main :: SF Int (Bool, Bool, Bool)
  > main = proc n -> (n <= 1 && n > 3, n /= 3 || n /= 0, n < 0 || n > 5)
  > END
  $ frobc compile contrary.frob
  $ grep 'out->' contrary.c | sed "s, */\*.*,,"
      out->f1 = frob_both(n <= 1, n > 3);
      out->f2 = frob_either(n != 3, n != 0);
      out->f3 = n < 0 || n > 5;
  $ for cc in gcc clang; do $cc -std=c99 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -c contrary.c; done
  $ printf 'time,in\n0,0\n1,1\n2,2\n3,3\n4,4\n5,6\n' > in.csv
  $ frobc trace contrary.frob --input in.csv > c.csv
  $ frobc trace contrary.frob --input in.csv --engine interp | cmp - c.csv
