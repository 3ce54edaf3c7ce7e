  $ ../../explain/message.exe E0413
  main.frob:
  twice :: (a -> a) -> a -> a
  twice f x = f (f x)
  
  main :: SF Float Float
  main = arr (twice twice twice twice twice step) where
      step x = x + 1
  
  error[E0413]: `main` needs functions that are nested too deeply
   --> main.frob:5:1
    |
  5 | main = arr (twice twice twice twice twice step) where
    | ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
  6 |     step x = x + 1
    |     ^^^^^^^^^^^^^^
    |
    = note: the functions or signal functions form a chain of thousands, and each contains the previous one
    = hint: compose fewer of them, or write one signal function that does the same
  
  1 error
