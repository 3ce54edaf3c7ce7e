  $ ../../explain/message.exe E0347
  main.frob:
  pick :: Int -> Array 4 Float -> Float
  pick k xs = xs ! k
  
  error[E0347]: the index of `!` must be constant, but `k` is not
   --> main.frob:2:18
    |
  2 | pick k xs = xs ! k
    |      -           ^
    |      |
    |      `k` is bound here
    |
    = note: an index can be a number, the name of a constant, or arithmetic on these
    = hint: use `at k 0 xs`, which takes any index and returns `0` if there is no such element
  
  1 error
