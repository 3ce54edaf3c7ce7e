Invalid types for foreign code:

  $ check() { cat > wrong.frob; frobc check wrong.frob; }
  $ check <<'EOF'
  > foreign apply :: (Float -> Float) -> Float = "apply"
  > EOF
  error[E0380]: `apply` cannot give C a value of type `Float -> Float`
   --> wrong.frob:1:18
    |
  1 | foreign apply :: (Float -> Float) -> Float = "apply"
    |                  ^^^^^^^^^^^^^^^^^^^^^^^^^
    |
    = note: functions, signal functions and labels exist only at compile time
  
  1 error
  [1]
  $ check <<'EOF'
  > data Named = Named { label :: String, value :: Float }
  > foreign show' :: Named -> Bool = "show"
  > EOF
  error[E0380]: `show'` cannot give C a value of type `String`
   --> wrong.frob:2:18
    |
  2 | foreign show' :: Named -> Bool = "show"
    |                  ^^^^^^^^^^^^^
    |
    = note: functions, signal functions and labels exist only at compile time
    = hint: pass an `Int` that tells C which string you mean
  
  1 error
  [1]
  $ check <<'EOF'
  > foreign first' :: a -> a = "first"
  > foreign size :: Array n Float -> Int = "size"
  > foreign norm :: n[u] -> n[u] = "norm"
  > foreign greater :: Ord a => a -> Float -> Float = "greater"
  > EOF
  error[E0380]: `first'` cannot give C a value of type `a`
   --> wrong.frob:1:19
    |
  1 | foreign first' :: a -> a = "first"
    |                   ^^^^^^
    |
    = note: a C function has one type
    = hint: import a separate C function for each type and size that you need
  
  error[E0380]: `size` cannot give C a value of type `n`
   --> wrong.frob:2:17
    |
  2 | foreign size :: Array n Float -> Int = "size"
    |                 ^^^^^^^^^^^^^^^^^^^^
    |
    = note: a C function has one type
    = hint: import a separate C function for each type and size that you need
  
  error[E0380]: `norm` cannot give C a value of type `n[u]`
   --> wrong.frob:3:17
    |
  3 | foreign norm :: n[u] -> n[u] = "norm"
    |                 ^^^^^^^^^^^^
    |
    = note: C has different functions for Int and Float
    = hint: write `Float[…]` or `Int[…]`
  
  error[E0380]: a foreign declaration cannot have class constraints
   --> wrong.frob:4:20
    |
  4 | foreign greater :: Ord a => a -> Float -> Float = "greater"
    |                    ^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    |
    = hint: import a separate C function for each type that you need
  
  4 errors
  [1]
  $ check <<'EOF'
  > foreign gravity :: Float = "gravity"
  > foreign filter :: SF Float Float = "filter"
  > EOF
  error[E0380]: `gravity` must have a function type, even if its C function takes no argument
   --> wrong.frob:1:20
    |
  1 | foreign gravity :: Float = "gravity"
    |                    ^^^^^
    |
    = hint: use `() -> Float`, and call it as `gravity ()`
  
  error[E0380]: `filter` has a signal function type, but is not declared with `sf`
   --> wrong.frob:2:19
    |
  2 | foreign filter :: SF Float Float = "filter"
    |                   ^^^^^^^^^^^^^^
    |
    = hint: if it has state in C, declare it as `foreign sf filter :: …`
  
  2 errors
  [1]
  $ check <<'EOF'
  > foreign include "filter.h"
  > foreign sf filter :: Float -> SF Float Float = "filter"
  > foreign sf square :: Float -> Float = "square"
  > foreign sf control :: SF (SF Float Float) Float = "control"
  > EOF
  error[E0380]: the foreign signal function `filter` cannot have parameters
   --> wrong.frob:2:22
    |
  2 | foreign sf filter :: Float -> SF Float Float = "filter"
    |                      ^^^^^^^^^^^^^^^^^^^^^^^
    |
    = hint: move the parameters into its input
  
  error[E0380]: `square` is a foreign signal function, but `Float -> Float` is not a signal function type
   --> wrong.frob:3:22
    |
  3 | foreign sf square :: Float -> Float = "square"
    |                      ^^^^^^^^^^^^^^
    |
    = hint: declare a function without `sf`: `foreign square :: Float -> Float = …`
  
  error[E0380]: `control` cannot give C a value of type `SF Float Float`
   --> wrong.frob:4:23
    |
  4 | foreign sf control :: SF (SF Float Float) Float = "control"
    |                       ^^^^^^^^^^^^^^^^^^^^^^^^^
    |
    = note: functions, signal functions and labels exist only at compile time
  
  3 errors
  [1]

Units may be polymorphic, because C does not see them.

  $ check <<'EOF'
  > foreign larger :: Float[u] -> Float[u] -> Float[u] = "larger"
  > both :: (Distance, Time)
  > both = (larger 1[m] 2[m], larger 1[s] 2[s])
  > EOF

Names that are invalid in C, one C function with two types, a missing header:

  $ check <<'EOF'
  > foreign include ""
  > foreign type Frame = "struct frame *"
  > foreign mean :: Frame -> Float = "frame mean"
  > foreign return' :: Frame -> Float = "return"
  > EOF
  error[E0232]: an empty string is not the name of a header in C
   --> wrong.frob:1:17
    |
  1 | foreign include ""
    |                 ^^
    |
    = hint: write the path relative to this file's folder, as in `"blob.h"`
  
  error[E0232]: `struct frame *` is not the name of a type in C
   --> wrong.frob:2:22
    |
  2 | foreign type Frame = "struct frame *"
    |                      ^^^^^^^^^^^^^^^^
    |
    = hint: write a struct, as in `"struct frame"`, or the name of a `typedef`
  
  error[E0232]: `frame mean` is not a name in C
   --> wrong.frob:3:34
    |
  3 | foreign mean :: Frame -> Float = "frame mean"
    |                                  ^^^^^^^^^^^^
    |
    = hint: write only the name of the function, as in `"cbrt"`
  
  error[E0232]: `return` is not a name in C
   --> wrong.frob:4:37
    |
  4 | foreign return' :: Frame -> Float = "return"
    |                                     ^^^^^^^^
    |
    = hint: write only the name of the function, as in `"cbrt"`
  
  4 errors
  [1]
  $ check <<'EOF'
  > foreign area :: Float -> Float = "area"
  > foreign areaOf :: Int -> Float = "area"
  > foreign inMetres :: Float[m] -> Float[m] = "area"
  > EOF
  error[E0381]: the C function `area` is imported here with the type `Int -> Float`
   --> wrong.frob:2:9
    |
  1 | foreign area :: Float -> Float = "area"
    |         ---- and here with the type `Float -> Float`
  2 | foreign areaOf :: Int -> Float = "area"
    |         ^^^^^^
    |
    = note: a C function has one type
  
  1 error
  [1]
  $ check <<'EOF'
  > foreign sf tracker :: SF Float Float = "tracker"
  > foreign type Stamp = "struct stamp" copyable
  > EOF
  error[E0233]: no included C header defines `struct tracker_state`
   --> wrong.frob:1:12
    |
  1 | foreign sf tracker :: SF Float Float = "tracker"
    |            ^^^^^^^
    |
    = note: it is part of the program's state, so the C compiler must know its size
    = hint: include the header in this module, as in `foreign include "blob.h"`
  
  error[E0233]: no included C header defines `struct stamp`
   --> wrong.frob:2:14
    |
  2 | foreign type Stamp = "struct stamp" copyable
    |              ^^^^^
    |
    = note: it is part of the program's state, so the C compiler must know its size
    = hint: include the header in this module, as in `foreign include "blob.h"`
  
  2 errors
  [1]

Other errors about names:

  $ check <<'EOF'
  > foreign Mean :: Float -> Float = "mean"
  > EOF
  error[E0110]: expected a name, `type`, `include`, or `sf` and a name, found `Mean`
   --> wrong.frob:1:9
    |
  1 | foreign Mean :: Float -> Float = "mean"
    |         ^^^^
    |
    = hint: write, for example, `foreign cubeRoot :: Float -> Float = "cbrt"` or `foreign include "blob.h"`
  
  1 error
  [1]
  $ check <<'EOF'
  > foreign mean :: Float -> Float = "mean"
  > mean x = x
  > EOF
  error[E0211]: the name `mean` is defined twice
   --> wrong.frob:2:1
    |
  1 | foreign mean :: Float -> Float = "mean"
    |         ---- first defined here
  2 | mean x = x
    | ^^^^
    |
    = hint: write one equation for the function, and distinguish its arguments with `case`
  
  1 error
  [1]
  $ check <<'EOF'
  > foreign (+) :: Float -> Float -> Float = "add"
  > EOF
  error[E0227]: a program cannot define operators
   --> wrong.frob:1:10
    |
  1 | foreign (+) :: Float -> Float -> Float = "add"
    |          ^
    |
    = hint: give the function a name; with backticks you can write it between its arguments: a `f` b
  
  1 error
  [1]
