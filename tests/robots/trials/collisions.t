A collision is the same in `frobc run`, in a trial and in a sweep: an object came to touch the
robot. Each reports the object, the place, the time, and the clearance.

  $ cat > ahead.frob << 'FROB'
  > import Robot
  > import Trial
  > main :: DiffDrive o => Program i o
  > main = reactimateRobot (proc _ -> roMake (setVelTR 0.3[m/s] 0))
  > trial "touches nothing" = Trial { world = "thing.toml", lasts = 6[s], seeds = 1 `to` 1, judge = neverTouches }
  > trial "whatever it touches" = Trial { world = "thing.toml", lasts = 6[s], seeds = 1 `to` 1, judge = comesFar' }
  > comesFar' :: SF Truth Verdict
  > comesFar' = proc t -> verdict (t.driven < 100[m])
  > FROB
  $ printf 'program = "ahead.frob"\ntrial = "whatever it touches"\nrobots = ["pioneer"]\n' > plan.toml
  $ cat > meet << 'SH'
  > cat > thing.toml; printf '[start]\nx = 0\ny = 0\n' >> thing.toml
  > rate=${rate:-50}
  > frobc run ahead.frob --robot pioneer --world thing.toml --for 6s --rate $rate | grep '^coll' > run
  > frobc test ahead.frob --robot pioneer --rate $rate > test
  > cat run
  > grep -q '^FAIL' test && sed -n 's/^ *\(coll.*\)/\1/p' test | diff - run
  > grep '^ok\|^FAIL' test
  > rm -rf plan.rows; frobc sweep plan.toml > said
  > test $rate != 50 || cut -d, -f14- plan.csv
  > SH

  $ printf '[[wall]]\npoints = [[1, -1], [1, 1]]\n' | sh meet
  collisions: 1
  collision at 2.965 s: the wall (thing.toml, line 1), x 0.950 m, y -0.094 m, clearance 0.211 m
  FAIL  touches nothing: 1 of 1 seed; seed 1: failed at 2.980 s
  ok    whatever it touches: 1 seed, 6 s
  odometry_error,collisions,collision_at,collision_x,collision_y,collision_clearance,collision_with
  0.00149692796,1,2.965000000,0.950205088,-0.0939347222,0.21124692,"the wall (thing.toml, line 1)"
  $ printf 'name = "posts"\n\n[[circle]]\ncenter = [1, 0]\nradius = 0.1\n' | sh meet
  collisions: 1
  collision at 2.800 s: the circle (thing.toml, line 3), x 0.900 m, y 0.000 m, clearance 0.211 m
  FAIL  touches nothing: 1 of 1 seed; seed 1: failed at 2.800 s
  ok    whatever it touches: 1 seed, 6 s
  odometry_error,collisions,collision_at,collision_x,collision_y,collision_clearance,collision_with
  0.00149726581,1,2.800000000,0.900454938,0,0.210747266,"the circle (thing.toml, line 3)"
  $ printf '[[polygon]]\npoints = [[1, -1], [2, -1], [2, 1]]\n' | sh meet
  collisions: 1
  collision at 4.640 s: the polygon (thing.toml, line 1), x 1.451 m, y -0.098 m, clearance 0.231 m
  FAIL  touches nothing: 1 of 1 seed; seed 1: failed at 4.640 s
  ok    whatever it touches: 1 seed, 6 s
  odometry_error,collisions,collision_at,collision_x,collision_y,collision_clearance,collision_with
  0.0183857969,1,4.640000000,1.45144033,-0.0981806517,0.231437129,"the polygon (thing.toml, line 1)"
  $ printf '[[cone]]\ncenter = [1, 0]\n' | sh meet
  collisions: 1
  collision at 2.635 s: the cone (thing.toml, line 1), x 0.851 m, y 0.000 m, clearance 0.210 m
  FAIL  touches nothing: 1 of 1 seed; seed 1: failed at 2.640 s
  ok    whatever it touches: 1 seed, 6 s
  odometry_error,collisions,collision_at,collision_x,collision_y,collision_clearance,collision_with
  0.001497612,1,2.635000000,0.850704789,0,0.210247612,"the cone (thing.toml, line 1)"

Objects that can be pushed count too, and so do objects that roll against the
robot.

  $ printf '[[box]]\ncenter = [1, 0]\nsize = [0.2, 0.2]\n' | sh meet
  collisions: 1
  collision at 2.800 s: the box (thing.toml, line 1), x 0.902 m, y -0.094 m, clearance inf m
  FAIL  touches nothing: 1 of 1 seed; seed 1: failed at 2.800 s
  ok    whatever it touches: 1 seed, 6 s
  odometry_error,collisions,collision_at,collision_x,collision_y,collision_clearance,collision_with
  0.0176932702,1,2.800000000,0.901659906,-0.0939347222,inf,"the box (thing.toml, line 1)"
  $ printf '[[ball]]\ncenter = [1, 0]\n' | sh meet
  collisions: 1
  collision at 2.800 s: the ball (thing.toml, line 1), x 0.902 m, y 0.000 m, clearance inf m
  FAIL  touches nothing: 1 of 1 seed; seed 1: failed at 2.800 s
  ok    whatever it touches: 1 seed, 6 s
  odometry_error,collisions,collision_at,collision_x,collision_y,collision_clearance,collision_with
  0.000100214005,1,2.800000000,0.901922286,0,inf,"the ball (thing.toml, line 1)"
  $ printf '[[ball]]\nway = [[1, 3], [1, -3]]\nspeed = 1\n' | sh meet
  collisions: 1
  collision at 2.855 s: the ball (thing.toml, line 1), x 0.915 m, y 0.094 m, clearance inf m
  FAIL  touches nothing: 1 of 1 seed; seed 1: failed at 2.860 s
  ok    whatever it touches: 1 seed, 6 s
  odometry_error,collisions,collision_at,collision_x,collision_y,collision_clearance,collision_with
  0.0544742447,1,2.855000000,0.914737642,0.0944424495,inf,"the ball (thing.toml, line 1)"

No collision between two instants of a slow program is missed, and none is reported without an
object.

  $ printf '[[ball]]\nway = [[1, 3], [1, -3]]\nspeed = 2.5\nradius = 0.02\n' | rate=1 sh meet
  collisions: 1
  collision at 3.515 s: the ball (thing.toml, line 1), x 0.996 m, y -0.197 m, clearance inf m
  FAIL  touches nothing: 1 of 1 seed; seed 1: failed at 4.000 s
  ok    whatever it touches: 1 seed, 6 s
  $ printf '[[wall]]\npoints = [[1, 1], [2, 1]]\n' | sh meet
  collisions: 0
  ok    touches nothing: 1 seed, 6 s
  ok    whatever it touches: 1 seed, 6 s
  odometry_error,collisions,collision_at,collision_x,collision_y,collision_clearance,collision_with
  9.45854186e-06,0,,,,,

The output for tools contains the same data.

  $ printf '[[wall]]\npoints = [[1, -1], [1, 1]]\n[start]\nx = 0\ny = 0\n' > thing.toml
  $ frobc test ahead.frob --robot pioneer --json -k nothing | grep -o '"collisions".*"clearance":[0-9.]*}'
  "collisions":1,"first_collision":{"time":2.965,"with":"the wall (thing.toml, line 1)","x":0.950205088,"y":-0.0939347222,"clearance":0.21124692}

With several robots, each reports what it touched.

  $ printf '[[start]]\nx = 0\ny = 0\n[[start]]\nx = 2\ny = 0\nheading_deg = 180\n' > two.toml
  $ frobc run ahead.frob --robot pioneer --world two.toml --for 6s | grep coll
  robot 1 collisions: 1
  robot 1 collision at 3.135 s: robot 2, x 1.000 m, y 0.094 m, clearance inf m
  robot 2 collisions: 1
  robot 2 collision at 3.135 s: robot 1, x 1.000 m, y 0.094 m, clearance inf m
  collisions: 2

With `--strict` a collision is a fault.

  $ frobc run ahead.frob --robot pioneer --world thing.toml --for 6s --strict > said
  error: the robot collided with something
  [4]
  $ grep coll said
  collisions: 1
  collision at 2.965 s: the wall (thing.toml, line 1), x 0.950 m, y -0.094 m, clearance 0.211 m
