  $ ../../explain/message.exe E0402
  main.frob:
  main :: SF Float Float
  main = switch (proc x -> (x, when (x > 1))) (\_ -> main)
  
  error[E0402]: `main → main` may repeat endlessly within one instant
   --> main.frob:2:16
    |
  2 | main = switch (proc x -> (x, when (x > 1))) (\_ -> main)
    |                ^^^^^^^^^^^^^^^^^^^^^^^^^^^         ---- `main` may start itself again at its own first instant
    |                              |
    |                              `when` may occur at the first instant of `main`
    |
    = note: no time passes between these steps when `when` occurs as soon as `main` starts
    = hint: apply `notYet` to the event to ignore it at the first instant; `edge` would wait forever if the condition were true from the start
  
  1 error
