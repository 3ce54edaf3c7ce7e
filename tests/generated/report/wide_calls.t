A function that is given its arguments in a struct has four parameters beside it: its
state, the small fields of that, seconds and nanoseconds. The struct is in the frame of
who calls it, and so in the bound.

Of this program's functions the two modes and the machine are wide as soon as there are
27 numbers; from then on one more is one more place in a few frames, and no struct.

  $ list () { seq -s "$1" -f "$2%g$3" $n; }
  $ program () {
  >   n=$1
  >   cat <<END
  > data Numbers = Numbers { $(list ', ' a ' :: Float') }
  > 
  > machine :: SF Numbers (Float, Float)
  > machine = switch (proc i -> (($(list ' + ' 'abs i.a'), i.a1), mapE (\\_ -> 1) (mergeE (after 2[s] ()) (edge (i.a1 > 3))))) next
  > 
  > next :: Float -> SF Numbers (Float, Float)
  > next k = switch (proc i -> ((derivative i.a1 * 1[s] + k * $(list ' * ' i.a), i.a2), edge (i.a2 < 1 && i.a3 > 2))) (\\_ -> machine)
  > 
  > main :: SF (Float, Bool) ((Float, Float), (Float, Float))
  > main = proc (x, _) -> (machine (Numbers { $(list ', ' a ' = x') }), machine (Numbers { $(list ', ' a ' = x * 2') }))
  > END
  > }
  $ for n in 24 27 28 29; do
  >   program $n > p$n.frob
  >   frobc compile p$n.frob
  >   frobc report p$n.frob | awk '/^stack/ { stack = 1 } stack && $1 == "step" { print $2; exit }' > bound$n
  >   echo "$n: $(grep -c '_in {$' p$n.c)"
  > done
  24: 0
  27: 3
  28: 3
  29: 3
  $ echo "$(($(cat bound28) - $(cat bound27))) $(($(cat bound29) - $(cat bound28)))"
  128 128
