  $ ../../explain/message.exe E0411
  main.frob:
  main = identity
  
  error[E0411]: `main` cannot run: its type `SF a a` has variables, so the input or the output is not determined
   --> main.frob:1:1
    |
  1 | main = identity
    | ^^^^^^^^^^^^^^^
    |
    = hint: give it a signature without variables, such as `main :: SF Float Float`
  
  1 error
