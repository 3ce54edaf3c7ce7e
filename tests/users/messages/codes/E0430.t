  $ ../../explain/message.exe E0430
  main.frob:
  foreign type Frame = "struct frame"
  
  foreign difference :: Frame -> Frame -> Float = "frame_difference"
  foreign makeBlank :: () -> Frame = "frame_blank"
  
  blank :: Frame
  blank = makeBlank ()
  
  main :: SF Frame Float
  main = proc frame -> difference (delay blank frame) frame
  
  error[E0430]: a value of the foreign type `Frame` cannot be kept from one instant to the next
    --> main.frob:10:34
     |
  10 | main = proc frame -> difference (delay blank frame) frame
     |                                  ^^^^^^^^^^^^^^^^^
     |
     = note: a `Frame` from C is valid for one instant; the C code may reuse its memory after that
     = hint: keep only the numbers that you need, or declare the type `copyable` if a copy of the struct works like the original
  
  1 error
