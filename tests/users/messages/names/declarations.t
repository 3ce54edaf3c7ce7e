Declarations with the punctuation or the capitals of another language.

  $ cat > record.frob <<'FROB'
  > data Stick = { ahead :: Float }
  > FROB
  $ frobc check record.frob
  error[E0110]: expected the name of a constructor, starting with a capital letter, found `{`
   --> record.frob:1:14
    |
  1 | data Stick = { ahead :: Float }
    |              ^
    |
    = hint: put the constructor before the braces: `data Stick = Stick { ahead :: Float }`
  
  1 error
  [1]

  $ cat > signature.frob <<'FROB'
  > f : Float -> Float
  > f x = x
  > FROB
  $ frobc check signature.frob
  error[E0103]: unexpected character `:`
   --> signature.frob:1:3
    |
  1 | f : Float -> Float
    |   ^
    |
    = hint: put `::` before a type: `f :: Float -> Float`
  
  1 error
  [1]

  $ cat > capital.frob <<'FROB'
  > Gain :: Float
  > Gain = 3
  > FROB
  $ frobc check capital.frob
  error[E0110]: expected `=` after the left-hand side of a definition, found `::`
   --> capital.frob:1:6
    |
  1 | Gain :: Float
    |      ^^
    |
    = hint: start the name of a value with a lower-case letter
  
  1 error
  [1]

  $ cat > field.frob <<'FROB'
  > data Stick = Stick { ahead :: Float }
  > s = Stick { ahead :: 1 }
  > FROB
  $ frobc check field.frob
  error[E0110]: expected `=`, `,` or `}` after the name of a field, found `::`
   --> field.frob:2:19
    |
  2 | s = Stick { ahead :: 1 }
    |                   ^^
    |
    = hint: set a field with `=`
  
  1 error
  [1]
