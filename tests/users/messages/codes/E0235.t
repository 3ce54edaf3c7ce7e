  $ ../../explain/message.exe E0235
  main.frob:
  main :: SF Float Float
  main = proc x -> x where
      assert "" (x >= 0)
  
  error[E0235]: this label is empty or contains a line break
   --> main.frob:3:12
    |
  3 |     assert "" (x >= 0)
    |            ^^
    |
    = hint: describe in a few words what must hold; the summary of a run shows the label
  
  1 error
