`integral` and `derivative` with a time step, as in other languages: the hint removes it.

  $ try () { # EXPRESSION CORRECTED-EXPRESSION
  >   printf 'import Control\n\nmain = proc v -> y where\n    dt = stepTime ()\n    y  = %s\n' "$1" > program.frob
  >   frobc check program.frob 2>&1 | grep '^error\|hint'
  >   printf 'main = proc v -> y where\n    y  = %s\n' "$2" > corrected.frob; frobc check corrected.frob 2>&1 | grep '^error'
  > }

  $ try 'integral (2 * v) dt' 'integral (2 * v)'
  error[E0302]: `integral` takes 1 argument, but is given 2
    = hint: remove `dt`, because `integral` already multiplies by the time between two instants: write `integral (2 * v)`
  [1]
  $ try 'derivative v (stepTime ())' 'derivative v'
  error[E0302]: `derivative` takes 1 argument, but is given 2
    = hint: remove `stepTime ()`, because `derivative` already divides by the time between two instants: write `derivative v`
  [1]
  $ try 'integral v 20[ms]' 'integral v'
  error[E0302]: `integral` takes 1 argument, but is given 2
    = hint: remove `20[ms]`, because `integral` already multiplies by the time between two instants: write `integral v`
  [1]

Another extra argument may be an initial value:

  $ try 'integral v v' 'integral v'
  error[E0302]: `integral` takes 1 argument, but is given 2
    = hint: `integral` starts at 0: for another initial value, write `x0 + integral v`; to restart it when an event occurs, write `resetOn integral (v, e)`
  [1]
  $ try 'integral 1 v v' 'integral v'
  error[E0302]: `integral` takes 1 argument, but is given 3
    = hint: `integral` starts at 0: for another initial value, write `1 + integral v`; to restart it when an event occurs, write `resetOn integral (v, e)`
  [1]
