Lines of C, Python, Rust, Elm and MATLAB. Every replacement that a message offers compiles when it is
pasted.

A comma for a decimal point:

  $ cat > comma.frob <<'FROB'
  > import Robot
  > drive = proc i -> roMake (setVelTR v 0) where
  >     v = 0,3[m/s] + 0 * velocity i
  > main = reactimateRobot drive
  > FROB
  $ frobc check comma.frob
  error[E0110]: expected an operator, an argument, or the end of this definition, found `,`
   --> comma.frob:3:10
    |
  3 |     v = 0,3[m/s] + 0 * velocity i
    |          ^
    |
    = hint: use `.` as the decimal point: `0.3[m/s]`
  
  1 error
  [1]
  $ sed 's:0,3:0.3:' comma.frob > pasted.frob && frobc check pasted.frob

Choices:

  $ cat > inline.frob <<'FROB'
  > import Robot
  > drive = proc i -> roMake (setVelTR v 0) where
  >     v = 0.3[m/s] if frontSonar i > 0.5[m] else 0
  > main = reactimateRobot drive
  > FROB
  $ frobc check inline.frob
  error[E0110]: expected an operator, an argument, or the end of the expression, found `if`
   --> inline.frob:3:18
    |
  3 |     v = 0.3[m/s] if frontSonar i > 0.5[m] else 0
    |                  ^^
    |
    = hint: use `if frontSonar i > 0.5[m] then 0.3[m/s] else 0`
  
  1 error
  [1]
  $ sed 's:v = .*:v = if frontSonar i > 0.5[m] then 0.3[m/s] else 0:' inline.frob > pasted.frob && frobc check pasted.frob

  $ cat > colons.frob <<'FROB'
  > import Robot
  > drive = proc i -> roMake (setVelTR v 0) where
  >     v = if bumped i: 0 else: 0.3[m/s]
  > main = reactimateRobot drive
  > FROB
  $ frobc check colons.frob
  error[E0103]: unexpected character `:`
   --> colons.frob:3:20
    |
  3 |     v = if bumped i: 0 else: 0.3[m/s]
    |                    ^
    |
    = hint: use `if bumped i then 0 else 0.3[m/s]`
  
  1 error
  [1]
  $ sed 's:v = .*:v = if bumped i then 0 else 0.3[m/s]:' colons.frob > pasted.frob && frobc check pasted.frob

  $ cat > when.frob <<'FROB'
  > import Robot
  > drive = proc i -> roMake (setVelTR v 0) where
  >     v = when bumped i then 0 else 0.3[m/s]
  > main = reactimateRobot drive
  > FROB
  $ frobc check when.frob
  error[E0110]: expected an operator, an argument, or the end of this definition, found `then`
   --> when.frob:3:23
    |
  3 |     v = when bumped i then 0 else 0.3[m/s]
    |                       ^^^^
    |
    = hint: use `if bumped i then 0 else 0.3[m/s]`
  
  1 error
  [1]
  $ sed 's:when bumped:if bumped:' when.frob > pasted.frob && frobc check pasted.frob

  $ cat > match.frob <<'FROB'
  > f :: Int -> Float
  > f n = match n with
  >     | 0 -> 1
  >     | _ -> 2
  > FROB
  $ frobc check match.frob
  error[E0110]: expected an operator, an argument, or the end of this definition, found `|`
   --> match.frob:3:5
    |
  3 |     | 0 -> 1
    |     ^
    |
    = hint: use `case n of`, and write each branch on a line below it, as in `0 -> …`
  
  1 error
  [1]
  $ sed -e 's:match n with:case n of:' -e 's:| ::' match.frob > pasted.frob && frobc check pasted.frob

  $ cat > match_of_rust.frob <<'FROB'
  > f :: Int -> Float
  > f n = match n {
  >     0 => 1,
  >     _ => 2,
  > }
  > FROB
  $ frobc check match_of_rust.frob
  error[E0110]: expected the name of a field, found the number `0`
   --> match_of_rust.frob:3:5
    |
  3 |     0 => 1,
    |     ^
    |
    = hint: use `case n of`, and write each branch on a line below it, as in `0 -> …`
  
  1 error
  [1]

  $ cat > chained.frob <<'FROB'
  > import Robot
  > drive = proc i -> roMake (setVelTR v 0) where
  >     v = if 0.2[m] < frontSonar i < 0.5[m] then 0 else 0.3[m/s]
  > main = reactimateRobot drive
  > FROB
  $ frobc check chained.frob
  error[E0113]: `<` and `<` cannot be combined without parentheses
   --> chained.frob:3:34
    |
  3 |     v = if 0.2[m] < frontSonar i < 0.5[m] then 0 else 0.3[m/s]
    |                   -              ^
    |                   |
    |                   after this one
    |
    = hint: compare two values at a time: `0.2[m] < frontSonar i && frontSonar i < 0.5[m]`
  
  1 error
  [1]
  $ sed 's:i <:i \&\& frontSonar i <:' chained.frob > pasted.frob && frobc check pasted.frob

  $ cat > absent.frob <<'FROB'
  > f :: Maybe Float -> Float
  > f m = m ?? 0
  > FROB
  $ frobc check absent.frob
  error[E0103]: unexpected character `?`
   --> absent.frob:2:9
    |
  2 | f m = m ?? 0
    |         ^
    |
    = hint: use `fromMaybe 0 m`
  
  1 error
  [1]
  $ sed 's:m ?? 0:fromMaybe 0 m:' absent.frob > pasted.frob && frobc check pasted.frob

A name in capitals:

  $ cat > capitals.frob <<'FROB'
  > import Robot
  > MAX_SPEED = 0.4[m/s]
  > main = reactimateRobot (proc _ -> roMake (setVelTR MAX_SPEED 0))
  > FROB
  $ frobc check capitals.frob
  error[E0226]: a top-level definition defines one name, not a pattern
   --> capitals.frob:2:1
    |
  2 | MAX_SPEED = 0.4[m/s]
    | ^^^^^^^^^^^^^^^^^^^^
    |
    = hint: start the name of a value with a lower-case letter: `maxSpeed`
  
  1 error
  [1]
  $ sed 's:MAX_SPEED:maxSpeed:g' capitals.frob > pasted.frob && frobc check pasted.frob

Mathematical functions with a module:

  $ cat > module.frob <<'FROB'
  > f :: Float -> Float
  > f x = Math.max(x, 0) + math.sin(x)
  > FROB
  $ frobc check module.frob
  error[E0215]: no module `Math` is imported here
   --> module.frob:2:7
    |
  2 | f x = Math.max(x, 0) + math.sin(x)
    |       ^^^^
    |
    = hint: mathematical functions are built in: write `max x 0`
  
  error[E0205]: unknown name `math`
   --> module.frob:2:24
    |
  2 | f x = Math.max(x, 0) + math.sin(x)
    |                        ^^^^
    |
    = hint: write `sin x`, without `math.`
  
  2 errors
  [1]
  $ sed -e 's:Math.max(x, 0):(max x 0):' -e 's:math.sin(x):(sin x):' module.frob > pasted.frob && frobc check pasted.frob

Modules of Python:

  $ cat > python_modules.frob <<'FROB'
  > import rclpy
  > import time
  > from geometry_msgs.msg import Twist
  > from robot import Robot
  > FROB
  $ frobc check python_modules.frob
  error[E0110]: expected the name of a module, starting with a capital letter, found `rclpy`
   --> python_modules.frob:1:8
    |
  1 | import rclpy
    |        ^^^^^
    |
    = hint: remove this line: `frobc run --ros2` runs a program as a ROS 2 node
  
  error[E0110]: expected the name of a module, starting with a capital letter, found `time`
   --> python_modules.frob:2:8
    |
  2 | import time
    |        ^^^^
    |
    = hint: remove this line: time is built in; write `time ()` for the time since the start of the program
  
  error[E0110]: Frob has no `from`
   --> python_modules.frob:3:1
    |
  3 | from geometry_msgs.msg import Twist
    | ^^^^
    |
    = hint: remove this line: `frobc run --ros2` runs a program as a ROS 2 node
  
  error[E0110]: Frob has no `from`
   --> python_modules.frob:4:1
    |
  4 | from robot import Robot
    | ^^^^
    |
    = hint: use `import Robot (Robot)`
  
  4 errors
  [1]

The first lines of a program:

  $ cat > main.frob <<'FROB'
  > def main():
  >     pass
  > FROB
  $ frobc check main.frob
  error[E0103]: unexpected character `:`
   --> main.frob:1:11
    |
  1 | def main():
    |           ^
    |
    = hint: define `main` by an equation: `main = reactimateRobot (proc i -> …)` for a robot that follows signals, or `main = reactimateTask t` for one that runs a task `t`
  
  1 error
  [1]

  $ cat > main_of_c.frob <<'FROB'
  > int main() {
  >     return 0;
  > }
  > FROB
  $ frobc check main_of_c.frob
  error[E0110]: this function definition is not valid Frob syntax
   --> main_of_c.frob:1:1
    |
  1 | int main() {
    | ^^^^^^^^^^
    |
    = hint: define `main` by an equation: `main = reactimateRobot (proc i -> …)` for a robot that follows signals, or `main = reactimateTask t` for one that runs a task `t`
  
  1 error
  [1]

Samples of the past:

  $ cat > sample.frob <<'FROB'
  > import Robot
  > drive = proc i -> roMake (setVelTR v 0) where
  >     v = 0.1[1/s] * d[t-1]
  >     d = frontSonar i
  > main = reactimateRobot drive
  > FROB
  $ frobc check sample.frob
  error[E0110]: a `[` directly after a name is neither an index nor an array
   --> sample.frob:3:21
    |
  3 |     v = 0.1[1/s] * d[t-1]
    |                     ^
    |
    = hint: for the value one instant ago, write `delay 0 d`, where 0 is the initial value
  
  1 error
  [1]
  $ sed 's:d.t-1.:delay 0 d:' sample.frob > pasted.frob && frobc check pasted.frob

  $ cat > sample_of_matlab.frob <<'FROB'
  > import Robot
  > drive = proc i -> roMake (setVelTR v 0) where
  >     v = 0.1[1/s] * d(k-1)
  >     d = frontSonar i
  > main = reactimateRobot drive
  > FROB
  $ frobc check sample_of_matlab.frob
  error[E0205]: unknown name `k`
   --> sample_of_matlab.frob:3:22
    |
  3 |     v = 0.1[1/s] * d(k-1)
    |                      ^
    |
    = hint: for the value of a signal `x` one instant ago, write `delay 0 x`, where 0 is the initial value
  
  1 error
  [1]
  $ sed 's:d(k-1):delay 0 d:' sample_of_matlab.frob > pasted.frob && frobc check pasted.frob

  $ cat > previous.frob <<'FROB'
  > import Robot
  > drive = proc i -> roMake (setVelTR v 0) where
  >     v = 0.1[1/s] * (d - d_prev)
  >     d = frontSonar i
  > main = reactimateRobot drive
  > FROB
  $ frobc check previous.frob
  error[E0205]: unknown name `d_prev`
   --> previous.frob:3:25
    |
  3 |     v = 0.1[1/s] * (d - d_prev)
    |                         ^^^^^^
    |
    = hint: for the value of `d` one instant ago, write `delay 0 d`, where 0 is the initial value
  
  1 error
  [1]
  $ sed 's:d_prev:delay 0 d:' previous.frob > pasted.frob && frobc check pasted.frob

  $ cat > difference.frob <<'FROB'
  > import Robot
  > drive = proc i -> roMake (setVelTR v 0) where
  >     v = 0.1 * (d - delay 0 d) / dt
  >     d = frontSonar i
  > main = reactimateRobot drive
  > FROB
  $ frobc check difference.frob
  error[E0205]: unknown name `dt`
   --> difference.frob:3:33
    |
  3 |     v = 0.1 * (d - delay 0 d) / dt
    |                                 ^^
    |
    = hint: write `derivative d` instead of `(d - delay 0 d) / dt`
  
  1 error
  [1]
  $ sed 's:(d - delay 0 d) / dt:derivative d:' difference.frob > pasted.frob && frobc check pasted.frob

Sensors by other names:

  $ cat > sensors.frob <<'FROB'
  > import Robot
  > drive = proc i -> roMake (setVelTR v 0) where
  >     v = 0.1 * speed i
  > main = reactimateRobot drive
  > FROB
  $ frobc check sensors.frob
  error[E0205]: unknown name `speed`
   --> sensors.frob:3:15
    |
  3 |     v = 0.1 * speed i
    |               ^^^^^
    |
    = hint: write `velocity i`
  
  1 error
  [1]
  $ sed 's:speed i:velocity i:' sensors.frob > pasted.frob && frobc check pasted.frob

  $ cat > arrow.frob <<'FROB'
  > import Robot
  > drive = proc i -> roMake (setVelTR v 0) where
  >     v = 0.1 * i->velocity
  > main = reactimateRobot drive
  > FROB
  $ frobc check arrow.frob
  error[E0110]: expected an operator, an argument, or the end of this definition, found `->`
   --> arrow.frob:3:16
    |
  3 |     v = 0.1 * i->velocity
    |                ^^
    |
    = hint: to read a sensor, write `velocity i`; for a field, `i.velocity`
  
  1 error
  [1]
  $ sed 's:i->velocity:velocity i:' arrow.frob > pasted.frob && frobc check pasted.frob

  $ cat > field.frob <<'FROB'
  > import Robot
  > drive = proc i -> roMake (setVelTR v 0) where
  >     v = 0.1[1/s] * i.scan
  > main = reactimateRobot drive
  > FROB
  $ frobc check field.frob
  error[E0310]: no type in scope has a field `scan`
   --> field.frob:3:22
    |
  3 |     v = 0.1[1/s] * i.scan
    |                      ^^^^
    |
    = hint: a robot's sensors are signal functions of its input: write `frontSonar i` for the distance in front, or `sonars i` for all sonars
  
  1 error
  [1]
  $ sed 's:i.scan:frontSonar i:' field.frob > pasted.frob && frobc check pasted.frob

A pair as a point:

  $ cat > pair.frob <<'FROB'
  > import Geometry
  > f :: Point2 -> Angle
  > f p = atan2 (goal.y - p.y) (goal.x - p.x) where
  >     goal = (2[m], 1[m])
  > FROB
  $ frobc check pair.frob
  error[E0310]: `(n[m], n1[m])` has no field `y`
   --> pair.frob:3:19
    |
  3 | f p = atan2 (goal.y - p.y) (goal.x - p.x) where
    |              ---- ^
    |              |
    |              this is `(n[m], n1[m])`
    |
    = hint: a pair has no fields: write a point as `Vec2 { x = 2[m], y = 1[m] }`, with `import Geometry`
  
  error[E0310]: `(n[m], n1[m])` has no field `x`
   --> pair.frob:3:34
    |
  3 | f p = atan2 (goal.y - p.y) (goal.x - p.x) where
    |                             ---- ^
    |                             |
    |                             this is `(n[m], n1[m])`
    |
    = hint: a pair has no fields: write a point as `Vec2 { x = 2[m], y = 1[m] }`, with `import Geometry`
  
  2 errors
  [1]
  $ sed 's:goal = .*:goal = Vec2 { x = 2[m], y = 1[m] }:' pair.frob > pasted.frob && frobc check pasted.frob

The least of an array:

  $ cat > least.frob <<'FROB'
  > import Robot
  > drive = proc i -> roMake (setVelTR v 0) where
  >     v = if min [frontSonar i, sideSonar i] < 0.5[m] then 0 else 0.3[m/s]
  > main = reactimateRobot drive
  > FROB
  $ frobc check least.frob
  error[E0301]: `min` takes two values, not an array
   --> least.frob:3:12
    |
  3 |     v = if min [frontSonar i, sideSonar i] < 0.5[m] then 0 else 0.3[m/s]
    |            ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    |
    = hint: for the least of all elements, write `minimumBy id [frontSonar i, sideSonar i]`
  
  1 error
  [1]
  $ sed 's:min \[:minimumBy id [:' least.frob > pasted.frob && frobc check pasted.frob

`=` in a test:

  $ cat > test.frob <<'FROB'
  > test "half" = half 2 = 1
  > half :: Float -> Float
  > half x = x / 2
  > FROB
  $ frobc check test.frob
  error[E0110]: expected an operator, an argument, or the end of this definition, found `=`
   --> test.frob:1:22
    |
  1 | test "half" = half 2 = 1
    |                      ^
    |
    = hint: to compare, write `== 1`
  
  1 error
  [1]
  $ sed 's:half 2 =:half 2 ==:' test.frob > pasted.frob && frobc check pasted.frob

A constructor that starts with a small letter, if a function has that name:

  $ cat > constructor.frob <<'FROB'
  > import Robot
  > data Mode = Forward | Turning
  > drive = proc i -> roMake (setVelTR v 0) where
  >     mode = if bumped i then Turning else Forward
  >     v = if mode == forward then 0.3[m/s] else 0
  > main = reactimateRobot drive
  > FROB
  $ frobc check constructor.frob
  error[E0301]: expected `Mode`, found `Distance -> Task a b Bool`
   --> constructor.frob:5:20
    |
  5 |     v = if mode == forward then 0.3[m/s] else 0
    |            ----    ^^^^^^^
    |            |
    |            this is `Mode`
    |
    = hint: did you mean `Forward`?
  
  1 error
  [1]
  $ sed 's:== forward:== Forward:' constructor.frob > pasted.frob && frobc check pasted.frob

Records that lack a part:

  $ cat > braces.frob <<'FROB'
  > import Geometry
  > goal :: Point2
  > goal = { x = 1[m], y = 2[m] }
  > FROB
  $ frobc check braces.frob
  error[E0110]: expected the value of the definition after `=`, found `{`
   --> braces.frob:3:8
    |
  3 | goal = { x = 1[m], y = 2[m] }
    |        ^
    |
    = hint: put the constructor of the type before the braces, as in `Vec2 { x = 1[m], y = 2[m] }`
  
  1 error
  [1]
  $ sed 's:= {:= Vec2 {:' braces.frob > pasted.frob && frobc check pasted.frob

  $ cat > own_record.frob <<'FROB'
  > data Gains = Gains { left :: Float, right :: Float }
  > gains = { left = 1, right = 2 }
  > FROB
  $ frobc check own_record.frob
  error[E0110]: expected the value of the definition after `=`, found `{`
   --> own_record.frob:2:9
    |
  2 | gains = { left = 1, right = 2 }
    |         ^
    |
    = hint: put the constructor of the type before the braces, as in `Gains { left = 1, right = 2 }`
  
  1 error
  [1]
  $ sed 's:^gains = {:gains = Gains {:' own_record.frob > pasted.frob && frobc check pasted.frob

  $ cat > without_constructor.frob <<'FROB'
  > data Gains = { left :: Float, right :: Float }
  > FROB
  $ frobc check without_constructor.frob
  error[E0110]: expected the name of a constructor, starting with a capital letter, found `{`
   --> without_constructor.frob:1:14
    |
  1 | data Gains = { left :: Float, right :: Float }
    |              ^
    |
    = hint: put the constructor before the braces: `data Gains = Gains { left :: Float, right :: Float }`
  
  1 error
  [1]
  $ sed 's:= {:= Gains {:' without_constructor.frob > pasted.frob && frobc check pasted.frob

  $ cat > type_first.frob <<'FROB'
  > data Gains = Gains { Float left, Float right }
  > FROB
  $ frobc check type_first.frob
  error[E0110]: expected the name of a field, found `Float`
   --> type_first.frob:1:22
    |
  1 | data Gains = Gains { Float left, Float right }
    |                      ^^^^^
    |
    = hint: in a field, the type comes after the name: `left :: Float`
  
  1 error
  [1]
  $ sed -e 's:Float left:left \:\: Float:' -e 's:Float right:right \:\: Float:' type_first.frob > pasted.frob && frobc check pasted.frob

  $ cat > new.frob <<'FROB'
  > import Geometry
  > goal = new Vec2(1[m], 2[m])
  > FROB
  $ frobc check new.frob
  error[E0205]: unknown name `new`
   --> new.frob:2:8
    |
  2 | goal = new Vec2(1[m], 2[m])
    |        ^^^
    |
    = hint: remove `new`: the constructor creates the value, as in `Vec2 1[m] 2[m]`
  
  1 error
  [1]
  $ sed 's:new Vec2(1.m., 2.m.):Vec2 1[m] 2[m]:' new.frob > pasted.frob && frobc check pasted.frob

A loop with a counter:

  $ cat > counter.frob <<'FROB'
  > import Robot
  > mission = do
  >     n = 0
  >     while n < 4 do
  >         forward 1[m]
  >         n = n + 1
  > main = reactimateTask (watching mission)
  > FROB
  $ frobc check counter.frob
  error[E0110]: expected `<-`, `-<`, or the end of this statement, found `=`
   --> counter.frob:3:7
    |
  3 |     n = 0
    |       ^
    |
    = hint: variables cannot change in a task: to repeat the tasks 4 times, write `repeatT 4 $ do` instead of the `while`, and remove this line
  
  1 error
  [1]
  $ sed -e '/ n = /d' -e 's:while.*:repeatT 4 $ do:' counter.frob > pasted.frob && frobc check pasted.frob

A record for a function that takes one:

  $ cat > gains.frob <<'FROB'
  > import Control
  > f :: SF Float Float
  > f = proc e -> pid { kp = 1, ki = 0, kd = 0, largest = 1 } e
  > FROB
  $ frobc check gains.frob
  error[E0310]: `Pid[u, v] -> SF Float[u] Float[v]` has no field `kp`
   --> gains.frob:3:21
    |
  3 | f = proc e -> pid { kp = 1, ki = 0, kd = 0, largest = 1 } e
    |               ---   ^^
    |               |
    |               this is `Pid[u, v] -> SF Float[u] Float[v]`
    |
    = hint: `pid` takes the record as an argument: use `pid (Pid { kp = … })`
  
  error[E0301]: expected `Pid[u, v]`, found `Float`
   --> gains.frob:3:59
    |
  3 | f = proc e -> pid { kp = 1, ki = 0, kd = 0, largest = 1 } e
    |               ------------------------------------------- ^
    |               |
    |               argument 1 of this is `Pid[u, v]`
    |
    = hint: write the record: `Pid { kp = …, ki = …, kd = …, largest = … }`
  
  2 errors
  [1]
  $ sed 's:pid {\(.*\)} e:pid (Pid {\1}) e:' gains.frob > pasted.frob && frobc check pasted.frob

A ramp:

  $ cat > ramp.frob <<'FROB'
  > f :: SF Float Float
  > f = proc x -> ramp 0 x
  > FROB
  $ frobc check ramp.frob
  error[E0205]: unknown name `ramp`
   --> ramp.frob:2:15
    |
  2 | f = proc x -> ramp 0 x
    |               ^^^^
    |
    = hint: to limit how fast `x` changes, use `rateLimit 0.5[m/s^2] x`, with `import Control`; its output starts at the first value of `x`
  
  1 error
  [1]
  $ sed -e '1i import Control' -e 's:ramp 0 x:rateLimit 1[1/s] x:' ramp.frob > pasted.frob && frobc check pasted.frob
