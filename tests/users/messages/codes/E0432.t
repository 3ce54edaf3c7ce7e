  $ ../../explain/message.exe E0432
  main.frob:
  import Display
  import Robot
  
  main = reactimateRobot (proc i -> out where
      out = draw (InWorld Red (Cross (place i))) (delay (roMake id) out))
  
  error[E0432]: `main` may draw more than 1000 marks in an instant
   --> main.frob:4:1
    |
  4 | main = reactimateRobot (proc i -> out where
    | ^^^^
    |
    = note: the maximum number of marks must be known before the program runs
    = hint: draw on a new output in each instant: an output that is stored, for example by `delay`, keeps its marks
  
  1 error
