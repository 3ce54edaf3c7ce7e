`mergeE` with events of different values: the hint gives both events a value.

  $ try () { # EVENT CORRECTED-EVENT
  >   head='data Cmd = Stop | Go\n\nmain = proc (a, b) -> e where\n'
  >   printf "$head    e = %s\n" "$1" > program.frob
  >   frobc check program.frob 2>&1 | grep '^error\|hint'
  >   printf "$head    e = %s\n" "$2" > corrected.frob; frobc check corrected.frob
  > }

  $ try 'mergeE (edge a) (tag (edge b) Go)' 'mergeE (tag (edge a) Stop) (tag (edge b) Go)'
  error[E0301]: expected `Event ()`, found `Event Cmd`
    = hint: both events must carry values of the same type: give the first event a value of type `Cmd`, as in `mergeE (tag (edge a) Stop) (tag (edge b) Go)`
  $ try 'mergeE (tag (edge a) Stop) (edge b)' 'mergeE (tag (edge a) Stop) (tag (edge b) Go)'
  error[E0301]: expected `Event Cmd`, found `Event ()`
    = hint: both events must carry values of the same type: give the second event a value of type `Cmd`, as in `mergeE (tag (edge a) Stop) (tag (edge b) Go)`
  $ try 'mergeE (edge a) (tag (edge b) True)' 'mergeE (tag (edge a) False) (tag (edge b) True)'
  error[E0301]: expected `Event ()`, found `Event Bool`
    = hint: both events must carry values of the same type: give the first event a value of type `Bool`, as in `mergeE (tag (edge a) False) (tag (edge b) True)`
  $ try 'mergeE (tag (edge a) 1) (tag (edge b) Stop)' 'mergeE (tag (edge a) Go) (tag (edge b) Stop)'
  error[E0301]: expected `Event n[1]`, found `Event Cmd`
    = hint: both events must carry values of the same type: convert the values of one event with `mapE`, or declare a data type with a case for each
