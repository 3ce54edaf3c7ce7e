The listings of section 3 of the paper, with units, gains and the definitions
that it omits. Every trace is run compiled and interpreted.

  $ trace() {
  >   cat > in.csv
  >   frobc trace --lint --engine interp "$1.frob" --input in.csv --output interpreted.csv
  >   frobc trace "$1.frob" --input in.csv | tee compiled.csv
  >   cmp compiled.csv interpreted.csv
  > }

Differentiation is an operation on a signal:

  $ printf 'time,in\n0,1\n0.5,2\n1,2\n1,5\n3,1\n' | trace s_dot
  time,out
  0.000000000,0
  0.500000000,2
  1.000000000,0
  1.000000000,0
  3.000000000,-2

The wall follower in arrow notation is the same program as its equations. The
speed is limited to 0.4, then 0.5 (0.3 - 0.2). The turn is 4 times the lesser of
sin 35 degrees times 0.2 and 2 (s - 0.2), less the slope of s: -0.6, then -0.2.

  $ cat > ranges.csv << ROWS
  > time,in.1,in.2,in.3
  > 0,0.2,3,0.5
  > 0.5,0.2,1,0.2
  > 1,0.2,0.3,0.1
  > ROWS
  $ trace wall_follow_as_equations < ranges.csv | tee equations.csv
  time,out.1,out.2
  0.000000000,0.40000000000000002,0.45886114908083686
  0.500000000,0.40000000000000002,2.3999999999999999
  1.000000000,0.049999999999999989,0.34113885091916318
  $ trace wall_follow_in_arrow_notation < ranges.csv | cmp - equations.csv
  $ awk 'BEGIN { w = 0.2 * sin(35 * atan2(0, -1) / 180); print 4 * w, 4 * (0 + 0.6), 4 * (-w + 0.2) }'
  0.458861 2.4 0.341139

  $ frobc compile wall_follow_as_equations.frob --dump=flow --stop-after=flow
  program wall_follow_as_equations
  signal function wallFollow (v_curr : Float, f : Float, s : Float)
    _1 : Float = negate(_5)
    _2 : Float = min(_5, _7)
    _3 : Float = max(_1, _2)
    _4 : Float = min(0.4, _10)
    v : Float = max(-0.4, _4)
    s_dot : Float = derivative s
    _5 : Float = 0.57357643635104605 * v_curr
    _6 : Float = s - 0.2
    _7 : Float = 2.0 * _6
    _8 : Float = _3 - s_dot
    omega : Float = 4.0 * _8
    _9 : Float = f - 0.2
    _10 : Float = 0.5 * _9
    -> (out.1 = v, out.2 = omega)

Control sources, which are signals of functions, are composed and applied within
the instant, so only numbers remain. The C code contains neither functions for
them nor closures.

  $ printf 'time,in.1,in.2,in.3\n0,1,3,true\n1,1,0.5,true\n2,0.3,0.2,false\n' | trace control_sources
  time,out.forward,out.turn
  0.000000000,1,0.5
  1.000000000,0.5,1.5
  2.000000000,0.20000000000000001,0.5
  $ frobc compile control_sources.frob --dump=flow --stop-after=flow
  program control_sources
  signal function controller (v : Float, f : Float, near : Bool)
    before : Bool = delay False near
    _1 : Bool = near && before
    turn : Float = if _1 then 1.5 else 0.5
    forward : Float = min(v, f)
    -> (out.forward = forward, out.turn = turn)

The paper's program: without an echo, the robot sees nothing within five metres,
so it drives, and turns towards the wall that it does not see. The speed follows
from the equations.

  $ columns='odometry.position.x odometry.position.y odometry.heading leftWheel rightWheel'
  $ columns="$columns $(seq -f 'sonar[%g]' 0 15) frontBumper rearBumper leftStall rightStall battery motorsOn key"
  $ { echo time $columns | sed 's/ /,in./g'
  >   for t in 0 0.1 0.2; do echo "$t,0,0,0,0.1,0.1,,,,,,,,,,,,,,,,,false,false,false,false,12,true,"; done
  > } > still.csv
  $ trace wall_follow_1 < still.csv
  time,out.forward,out.turn
  0.000000000,0.40000000000000002,0.22943057454041843
  0.100000000,0.40000000000000002,0.22943057454041843
  0.200000000,0.40000000000000002,0.22943057454041843
