A local definition that hides the function it applies: the hint is another name.

  $ cat > distance.frob <<'FROB'
  > import Geometry
  > import Robot
  > 
  > goal :: Point2
  > goal = Vec2 { x = 2[m], y = 0 }
  > 
  > main :: SF RobotInput Velocity
  > main = proc i -> v where
  >     distance = distance (place i) goal
  >     v        = 0.5[1/s] * distance
  > FROB
  $ frobc check distance.frob
  error[E0302]: `distance` is `Float[m]`, not a function
   --> distance.frob:9:16
    |
  9 |     distance = distance (place i) goal
    |     --------   ^^^^^^^^  ------- it is applied to an argument here
    |     |
    |     this local `distance` hides the function `distance` of `Geometry`
    |
    = hint: give the local definition another name, such as `distance1`, so that `distance` is the function here
  
  1 error
  [1]
  $ sed 's/^    distance =/    distance1 =/;s/[*] distance/* distance1/' distance.frob > cured.frob
  $ frobc check cured.frob

A function of the program, and a signal function of the prelude:

  $ cat > speed.frob <<'FROB'
  > half :: Float -> Float
  > half x = x / 2
  > 
  > main :: SF Float Float
  > main = proc x -> half where
  >     half = 1 + half x
  > FROB
  $ frobc check speed.frob 2>&1 | grep 'hides\|hint'
    |     this local `half` hides the function `half` of this program
    = hint: give the local definition another name, such as `half1`, so that `half` is the function here
  $ sed 's/    half = 1/    half1 = 1/;s/-> half where/-> half1 where/' speed.frob > cured.frob
  $ frobc check cured.frob
  $ cat > integral.frob <<'FROB'
  > main :: SF Float Float[s]
  > main = proc x -> integral where
  >     integral = integral x
  > FROB
  $ frobc check integral.frob 2>&1 | grep 'hides\|hint'
    |     this local `integral` hides the signal function `integral` of `Prelude`
    = hint: give the local definition another name, such as `integral1`, so that `integral` is the signal function here

A function of a module that is not imported is not meant:

  $ cat > other.frob <<'FROB'
  > main :: SF Float Float
  > main = proc x -> distance where
  >     distance = x + distance x
  > FROB
  $ frobc check other.frob 2>&1 | grep 'local\|hint'
    |     the name refers to this local `distance`
    = hint: write an operator between the two values, as in `distance * x`; for a tuple, `(distance, x)`
