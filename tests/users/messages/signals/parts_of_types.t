A label says which part of an argument, a signature or a field has the expected type.

  $ try () { # SIGNATURE EXPRESSION
  >   printf 'data P = P { x :: SF Float Bool }\nmain :: %s\nmain = %s\n' "$1" "$2" > program.frob
  >   frobc check program.frob 2>&1 | grep -v '^ *$\|hint\|^[0-9]'
  > }

  $ try 'SF Float Float' 'switch (proc x -> (x, when (x > 1))) (\_ -> 1)'
  error[E0301]: expected `SF n[1] n[1]`, found a number
   --> program.frob:3:52
    |
    |        ------                                      ^
    |        |
    |        the result of argument 2 of `switch` is `SF n[1] n[1]`
    |
  $ try 'SF Float Float' 'switch (proc x -> (x, x)) (\_ -> arr id)'
  error[E0301]: expected `SF Float Float`, found `SF (Event a) (Event a)`
   --> program.frob:3:8
    |
    |         -------------- the signature of `main` requires `SF Float Float`
    |        ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
  $ try 'SF Float (Array 2 Bool)' 'proc x -> [x > 1, x]'
  error[E0301]: expected `Bool`, found `Float`
   --> program.frob:3:26
    |
    |                   -----  ^
    |                   |
    |                   the first element is `Bool`
    |
  $ try 'SF Float (Bool, Bool)' 'proc x -> (x > 1, x)'
  error[E0301]: expected `Bool`, found `Float`
   --> program.frob:3:26
    |
    |         --------------------- by the signature of `main`, the second component of the output is `Bool`
    |                          ^
  $ try 'SF Float Bool' 'proc x -> (((\y -> y) :: Float -> Bool) x)'
  error[E0301]: expected `Bool`, found `Float`
   --> program.frob:3:27
    |
    |                           ^     ------------- the annotation requires `Bool`
  $ try 'SF Float Float' 'proc x -> let p = P { x = proc y -> y } in x'
  error[E0301]: expected `Bool`, found `Float`
   --> program.frob:3:44
    |
    |                              -             ^
    |                              |
    |                              the output of the field `x` is `Bool`

The type of an argument is the declared one, without parts of the wrong argument:

  $ cat > speed.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateRobot (proc _ -> roMake (setVelTR 0.3[m/s]))
  > FROB
  $ frobc check speed.frob
  error[E0301]: expected a function that takes one argument, found one that takes 2: `AngularVelocity -> a -> a`
   --> speed.frob:3:43
    |
  3 | main = reactimateRobot (proc _ -> roMake (setVelTR 0.3[m/s]))
    |                                   ------  ^^^^^^^^^^^^^^^^^
    |                                   |
    |                                   argument 1 of `roMake` is `o -> o`
    |
    = hint: `setVelTR` lacks its second argument, `AngularVelocity` (1/s): write `setVelTR 0.3[m/s] 0`, for example
  
  1 error
  [1]
