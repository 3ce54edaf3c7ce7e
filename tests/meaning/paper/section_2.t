The listings of section 2 of the paper, with the changes that the reference
(section 1) allows. The values below were computed by hand; every trace is run
compiled and interpreted.

  $ trace() {
  >   cat > in.csv
  >   frobc trace --lint --engine interp "$1.frob" --input in.csv --output interpreted.csv
  >   frobc trace "$1.frob" --input in.csv | tee compiled.csv
  >   cmp compiled.csv interpreted.csv
  > }

A tuple constant:

  $ printf 'time\n0\n' | trace tuple_constant
  time,out.1,out.2
  0.000000000,1,false

The form of a definition: delayed sums, doubled, and swapped by a delay.

  $ printf 'time,in\n0,1\n1,2\n2,3\n' | trace syntax_of_definitions
  time,out.1,out.2
  0.000000000,5,0
  1.000000000,0,4
  2.000000000,2,6

The wiring diagram: c is a times the vector of length 2 along the x axis,
reversed if a is odd; d is True if b grows.

  $ printf 'time,in.1,in.2\n0,2,0\n1,0,1\n2,4,1\n' | trace wiring_diagram
  time,out.1.x,out.1.y,out.2
  0.000000000,4,-9.7971743931788257e-16,false
  1.000000000,0,0,true
  2.000000000,8,-3.9188697572715303e-15,false

The paper's integral lags by one step, because its loop has a delay: it adds (t
- t') v one instant later. The library's integral adds dt times the previous
input.

  $ printf 'time,in\n0,1\n1,2\n3,3\n3.5,0\n' | trace integral
  time,out.1,out.2
  0.000000000,0,0
  1.000000000,0,1
  3.000000000,2,5
  3.500000000,8,6.5
  $ printf 'time,in.1,in.2\n0,1,0\n1,2,1\n3,3,3\n3.5,0,3.5\n' | trace integral_without_units
  time,out
  0.000000000,0
  1.000000000,0
  3.000000000,2
  3.500000000,8

The event functions. An event of the program's own type is an ordinary value.

  $ trace events << ROWS
  > time,in.1,in.2
  > 0,NoEvent,NoEvent
  > 1,Event 1,NoEvent
  > 2,NoEvent,Event 7
  > 3,Event 2,Event 8
  > ROWS
  time,out.1,out.2,out.3,out.4,out.5
  0.000000000,NoEvent,NoEvent,NoEvent,NoEvent,NoEvent
  1.000000000,Event 2,Event true,Event 1,NoEvent,NoEvent
  2.000000000,NoEvent,NoEvent,Event 7,NoEvent,NoEvent
  3.000000000,Event 4,Event true,Event 2,"Event (2, 8)",Event 2

A signature alone, with a definition written for it:

  $ frobc check --lint wall_distance.frob
