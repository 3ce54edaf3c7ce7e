  $ ../../explain/message.exe E0508
  main.frob:
  import Ros
  
  param rate :: Float[Hz] = 20[Hz]
  
  data In = In { enable :: Event Bool }
  data Out = Out { enabled :: Bool }
  
  main :: Program In Out
  main = node rate (proc i -> Out { enabled = hold False i.enable })
  
  error[E0508]: the rate of a node must be known at compile time
   --> main.frob:9:8
    |
  9 | main = node rate (proc i -> Out { enabled = hold False i.enable })
    |        ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    |
    = hint: write a rate such as `50[Hz]`
  
  1 error
