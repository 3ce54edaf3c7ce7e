  $ ../../explain/message.exe E0228
  main.frob:
  data Gains = Gains { kp :: Float, ki :: Float, kd :: Float }
  
  gains :: Gains
  gains = Gains { kp = 2 }
  
  error[E0228]: this `Gains` is missing the fields `ki` and `kd`
   --> main.frob:4:9
    |
  1 | data Gains = Gains { kp :: Float, ki :: Float, kd :: Float }
    |              ----- declared here
  ...
  4 | gains = Gains { kp = 2 }
    |         ^^^^^^^^^^^^^^^^
    |
    = hint: give every field a value: add `ki = …` and `kd = …`
  
  1 error
