  $ ../../explain/message.exe E0234
  main.frob:
  double :: Float -> Float
  double x = y where
      y = 2 * x
      assert "grows" (y > x)
  
  error[E0234]: an `assert` is only allowed among the equations of a `proc`
   --> main.frob:4:5
    |
  4 |     assert "grows" (y > x)
    |     ^^^^^^^^^^^^^^^^^^^^^^
    |
    = hint: move it into a `proc`, as in `proc x -> y where` with `assert "label" (y > 0)` on a line below
  
  1 error
