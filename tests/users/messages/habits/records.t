Records in the syntax of other languages.

  $ cat > assigned.frob <<'FROB'
  > import Robot
  > data Config = Config { speed :: Velocity, gain :: Float }
  > slow :: Config -> Config
  > slow c = c.speed = 0.1[m/s]
  > main = reactimateRobot (proc i -> roMake (setVelTR 0.1[m/s] 0))
  > FROB
  $ frobc check assigned.frob
  error[E0110]: expected an operator, an argument, or the end of this definition, found `=`
   --> assigned.frob:4:18
    |
  4 | slow c = c.speed = 0.1[m/s]
    |                  ^
    |
    = hint: a record cannot be changed: `c { speed = … }` is a copy with a new `speed`
  
  1 error
  [1]

  $ cat > colons.frob <<'FROB'
  > import Robot
  > data Config = Config { speed :: Velocity, gain :: Float }
  > c = Config { speed: 0.1[m/s], gain: 2 }
  > main = reactimateRobot (proc i -> roMake (setVelTR c.speed 0))
  > FROB
  $ frobc check colons.frob
  error[E0103]: unexpected character `:`
   --> colons.frob:3:19
    |
  3 | c = Config { speed: 0.1[m/s], gain: 2 }
    |                   ^
    |
    = hint: set a field with `=`: `Config { speed = 0.1[m/s], gain = 2 }`
  
  1 error
  [1]

  $ cat > by_position.frob <<'FROB'
  > import Robot
  > data Config = Config { speed :: Velocity, gain :: Float }
  > c = Config { 0.1[m/s], 2 }
  > main = reactimateRobot (proc i -> roMake (setVelTR c.speed 0))
  > FROB
  $ frobc check by_position.frob
  error[E0110]: expected the name of a field, found the number `0.1`
   --> by_position.frob:3:14
    |
  3 | c = Config { 0.1[m/s], 2 }
    |              ^^^
    |
    = hint: write the name of the field before each value: `Config { speed = 0.1[m/s], gain = 2 }`
  
  1 error
  [1]

  $ cat > struct.frob <<'FROB'
  > import Robot
  > struct Config {
  >     speed : Velocity
  > }
  > main = reactimateRobot (proc i -> roMake (setVelTR 0.1[m/s] 0))
  > FROB
  $ frobc check struct.frob
  error[E0103]: unexpected character `:`
   --> struct.frob:3:11
    |
  3 |     speed : Velocity
    |           ^
    |
    = hint: declare a record with `data` and a constructor: `data Config = Config { speed :: Velocity }`
  
  1 error
  [1]
