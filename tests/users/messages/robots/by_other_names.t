A robot's sensors and commands under names from elsewhere.

A function that is written as a field, whether or not the program uses it elsewhere:

  $ cat > field.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (proc i -> roMake (setVelTR (if i.bumped then 0 else 0.2[m/s]) 0))
  > FROB
  $ frobc check field.frob
  error[E0310]: no type in scope has a field `bumped`
   --> field.frob:2:58
    |
  2 | main = reactimateRobot (proc i -> roMake (setVelTR (if i.bumped then 0 else 0.2[m/s]) 0))
    |                                                          ^^^^^^
    |
    = hint: `bumped` is a function: write `bumped i`
  
  1 error
  [1]
  $ sed 's/i.bumped/bumped i/' field.frob > function.frob
  $ frobc check function.frob

Names from other systems:

  $ cat > words.frob <<'FROB'
  > import Robot
  > away :: SF RobotInput AngularVelocity
  > away = proc i -> 1[1/s] * (heading i + laser i) * i.pose.x
  > 
  > go = do
  >     moveForward 1[m]
  >     turnLeft 90[deg]
  >     stop
  > FROB
  $ frobc check words.frob
  error[E0205]: unknown name `heading`
   --> words.frob:3:28
    |
  3 | away = proc i -> 1[1/s] * (heading i + laser i) * i.pose.x
    |                            ^^^^^^^
    |
    = hint: write `(robotPose i).heading`
  
  error[E0205]: unknown name `laser`
   --> words.frob:3:40
    |
  3 | away = proc i -> 1[1/s] * (heading i + laser i) * i.pose.x
    |                                        ^^^^^
    |
    = hint: for the distance ahead, write `frontSonar i`; to the left, `sideSonar i`; to the right, `rightSonar i`
  
  error[E0205]: unknown name `moveForward`
   --> words.frob:6:5
    |
  6 |     moveForward 1[m]
    |     ^^^^^^^^^^^
    |
    = hint: to drive straight ahead in a task, write `forward 1[m]`
  
  error[E0205]: unknown name `turnLeft`
   --> words.frob:7:5
    |
  7 |     turnLeft 90[deg]
    |     ^^^^^^^^
    |
    = hint: to turn in place in a task, write `turnBy 90[deg]`; a positive angle turns left
  
  error[E0205]: unknown name `stop`
   --> words.frob:8:5
    |
  8 |     stop
    |     ^^^^
    |
    = hint: to stop the robot, use the output `restingOutput`; in a task, `sleepT 1[s] restingOutput` stops it for 1 s
  
  5 errors
  [1]
  $ cat > field_of_none.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (proc i -> roMake (setVelTR (0.1[1/s] * i.pose.x) 0))
  > FROB
  $ frobc check field_of_none.frob
  error[E0310]: no type in scope has a field `pose`
   --> field_of_none.frob:2:66
    |
  2 | main = reactimateRobot (proc i -> roMake (setVelTR (0.1[1/s] * i.pose.x) 0))
    |                                                                  ^^^^
    |
    = hint: for the robot's position, write `place i`, which has the fields `x` and `y`, or `robotPose i`, which has `position` and `heading`
  
  1 error
  [1]

A misspelt name of the program itself is suggested first:

  $ cat > misspelt.frob <<'FROB'
  > import Robot
  > headin = 90[deg]
  > main = reactimateRobot (proc _ -> roMake (setVelTR 0 (1[1/s] * heading)))
  > FROB
  $ frobc check misspelt.frob
  error[E0205]: unknown name `heading`
   --> misspelt.frob:3:64
    |
  3 | main = reactimateRobot (proc _ -> roMake (setVelTR 0 (1[1/s] * heading)))
    |                                                                ^^^^^^^
    |
    = hint: did you mean `headin`?
  
  1 error
  [1]
