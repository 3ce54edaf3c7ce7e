  $ ../../explain/message.exe E0321
  main.frob:
  wheel :: Float[mm]
  wheel = 195[mm]
  
  error[E0321]: a type cannot contain a scaled unit, because values are stored in base units
   --> main.frob:1:16
    |
  1 | wheel :: Float[mm]
    |                ^^
    |
    = hint: write `m` here; use scaled units only after literals
  
  1 error
