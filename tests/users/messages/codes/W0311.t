  $ ../../explain/message.exe W0311
  main.frob:
  main :: SF Float Float
  main = proc x -> y where
      y = switch (proc (u, _) -> (u, edge (u > 1))) (\_ -> late) (x, y)
  
  late :: SF (Float, Float) Float
  late = proc (u, v) -> 2 * u where
      assert "bounded" (v < 10)
  
  warning[W0311]: this assertion is not checked
   --> main.frob:7:12
    |
  7 |     assert "bounded" (v < 10)
    |            ^^^^^^^^^
    |
    = note: it is inside a switch whose output is fed back to it, and showing an inner signal would make all outputs of the switch depend on that signal
    = hint: move the assertion to where the output of the switch is used
  
  1 warning
