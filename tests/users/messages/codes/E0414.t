  $ ../../explain/message.exe E0414
  main.frob:
  main :: SF Float Float
  main = loop (arr step) where
      step (x, f) = (f x, f)
  
  error[E0414]: `` contains a function that depends on itself
     --> stdlib/Prelude.frob:278:5
      |
  278 |     (y, z) = f (x, z)
      |     ^^^^^^
      |
      = note: functions, signal functions and tasks are evaluated at compile time
      = hint: feed back the numbers that the function depends on, not the function
  
  1 error
