A function of hundreds of scalars receives them individually, as C compilers support. Here with 300
inputs and outputs: at the root, for an inner signal function, for a mode's parameters, for an event
with a record, and for a function whose only result is used in a choice.

  $ row() { awk -v n="$1" -v s="$2" 'BEGIN { for (i = 1; i <= n; i++) { t = s; gsub(/#/, i, t); gsub(/@/, i % n + 1, t); printf "%s%s", (i > 1 ? ", " : ""), t } }'; }
  $ alternating() { awk -v n="$1" -v odd="$2" -v even="$3" 'BEGIN { for (i = 1; i <= n; i++) { t = i % 2 ? odd : even; gsub(/#/, i, t); printf "%s%s", (i > 1 ? ", " : ""), t } }'; }
  $ types=$(alternating 300 Float Int)
  $ cat > wide.frob <<EOF
  > data Wide = Wide { $(row 40 'x# :: Float') }
  > 
  > both :: Bool -> SF ($types) ($types)
  > both up = proc ($(row 300 'v#')) -> ($(alternating 300 'delay # (w#)' 'w#')) where
  >     ($(row 300 'w#')) = ($(alternating 300 'if up then v# + 1 else 2 * v#' 'v# + #'))
  > 
  > keep :: $(row 40 'Float' | sed 's/, / -> /g') -> SF (Float, Bool) Float
  > keep $(row 40 'p#' | sed 's/,//g') = switch (proc (x, b) -> ($(row 40 'p# * x' | sed 's/,/ +/g'), tag (edge b) (wide x $(row 39 'p#' | sed 's/,//g')))) resume
  > 
  > resume :: Wide -> SF (Float, Bool) Float
  > resume w = keep $(row 40 'w.x@' | sed 's/,//g')
  > 
  > wide :: $(row 40 'Float' | sed 's/, / -> /g') -> Wide
  > wide $(row 40 'y#' | sed 's/,//g') = Wide { $(row 40 'x# = y#') }
  > 
  > mixed :: Wide -> Float -> Float
  > mixed w z = sin w.x1 * z + $(row 40 'cos (w.x# + z) * w.x@' | sed 's/,/ +/g')
  > 
  > main :: SF ($types) ($types, Float, Float)
  > main = proc (i@($(row 300 'v#' | sed 's,v,_v,4g'))) -> ($(row 300 'o#'), keep $(row 40 '#' | sed 's/,//g') (v1, v2 > 0), z) where
  >     ($(row 300 'o#')) = both False (both True i)
  >     held = hold NoEvent (tag (edge (v2 > 1)) (Event (wide $(row 40 'v1' | sed 's/,//g'))))
  >     z = if v2 > 2 then fromEvent 0 (mapE (\w -> mixed w v1) held) else mixed (wide $(row 40 'v3' | sed 's/,//g')) 1
  > EOF
  $ frobc compile wide.frob -o .

The results are those of the interpreter, and C compilers have no warnings.

  $ { printf time; row 300 ',in.#' | sed 's/, //g'; echo; for k in 0 1 2 3 4 5 6; do printf '%d' $k; awk -v k=$k 'BEGIN { for (i = 1; i <= 300; i++) printf ",%d", (i * 7 + k * k * (i % 5)) % 23 - 9 + (i == 2 ? k : 0) }'; echo; done; } > in.csv
  $ frobc trace wide.frob --input in.csv > compiled.csv
  $ frobc trace wide.frob --input in.csv --engine interp > interpreted.csv
  $ cmp compiled.csv interpreted.csv && awk -F, 'END { print NR, NF }' compiled.csv
  8 303
  $ strict="-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -ffp-contract=off -I ../../../runtime/include"
  $ gcc -std=c99 -O2 $strict -c wide.c -o wide.o && clang -std=c99 -O1 $strict -c wide.c -o wide.o
  $ g++ -x c++ -std=c++17 $strict -c wide.c -o wide.o && clang++ -x c++ -std=c++17 $strict -c wide.c -o wide.o

The same with the user's C, of whose results the program uses few.

  $ cat > shaken.frob <<EOF
  > data Wide = Wide { $(row 40 'x# :: Float') }
  > 
  > foreign shake :: Wide -> Wide = "shake"
  > 
  > main :: SF (Float, Bool) Float
  > main = proc (x, b) -> if b then y.x1 + y.x40 else 0 where
  >     y = shake (shake Wide { $(row 40 'x# = x + #') })
  > EOF
  $ frobc compile shaken.frob -o .
  $ gcc -std=c99 -O2 $strict -c shaken.c && clang -std=c99 -O1 $strict -c shaken.c

The stack that the report states is sufficient.

  $ sh ../../generated/report/measure.sh wide.frob
  all measured

A mode that ends leaves its results unwritten, and nothing reads them then.

  $ cat > ends.frob <<EOF
  > main :: SF Float ($(row 40 'Float'))
  > main = switch (proc x -> (($(row 40 '# * x')), edge (x > 2))) (\_ -> proc x -> ($(row 40 'delay # (# + x)')))
  > EOF
  $ frobc compile ends.frob -o .
  $ printf 'time,in\n0,1\n1,2.5\n2,3\n3,0\n' > in.csv
  $ frobc trace ends.frob --input in.csv > compiled.csv
  $ frobc trace ends.frob --input in.csv --engine interp | cmp - compiled.csv
  $ gcc -std=c99 -O2 $strict -c ends.c -o ends.o && g++ -x c++ -std=c++17 $strict -c ends.c -o ends.o
