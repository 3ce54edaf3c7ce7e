  $ ../../explain/message.exe E0322
  main.frob:
  noise :: Float[m^(1/2)]
  noise = 2.0[mm^(1/2)]
  
  error[E0322]: `mm` is a scaled unit, so its exponent must be an integer, not 1/2
   --> main.frob:2:13
    |
  2 | noise = 2.0[mm^(1/2)]
    |             ^^^^^^^^
    |
    = hint: write the number in base units
  
  1 error
