A name whose doc comment says that it is deprecated still works, with a warning.

  $ cat > Old.frob <<'END'
  > module Old where
  > 
  > -- | Twice the number. Deprecated: renamed to `doubled`.
  > twice :: Float -> Float
  > twice x = doubled x
  > 
  > -- | Twice the number.
  > doubled :: Float -> Float
  > doubled x = 2 * x
  > 
  > -- | Three times the number.
  > --
  > -- Deprecated: write
  > -- `3 * x`.
  > thrice :: Float -> Float
  > thrice x = twice x + x
  > END
  $ cat > uses.frob <<'END'
  > import Old
  > import qualified Old as O
  > 
  > main :: SF Float (Float, Float, Float)
  > main = proc x -> (twice x + twice 1, thrice x, O.twice x)
  > END
  $ frobc check uses.frob
  warning[W0317]: `twice` is deprecated
   --> uses.frob:5:19
    |
  5 | main = proc x -> (twice x + twice 1, thrice x, O.twice x)
    |                   ^^^^^
    |
    = hint: write `doubled`, its new name
  
  warning[W0317]: `twice` is deprecated
   --> uses.frob:5:29
    |
  5 | main = proc x -> (twice x + twice 1, thrice x, O.twice x)
    |                             ^^^^^
    |
    = hint: write `doubled`, its new name
  
  warning[W0317]: `thrice` is deprecated
   --> uses.frob:5:38
    |
  5 | main = proc x -> (twice x + twice 1, thrice x, O.twice x)
    |                                      ^^^^^^
    |
    = hint: write `3 * x`
  
  warning[W0317]: `twice` is deprecated
   --> uses.frob:5:48
    |
  5 | main = proc x -> (twice x + twice 1, thrice x, O.twice x)
    |                                                ^^^^^^^
    |
    = hint: write `doubled`, its new name
  
  4 warnings

`frobc fix` writes the new name, and leaves what it cannot rewrite.

  $ frobc fix uses.frob
  uses.frob:5:19: write `doubled` (W0317)
  uses.frob:5:29: write `doubled` (W0317)
  warning[W0317]: `thrice` is deprecated
   --> uses.frob:5:42
    |
  5 | main = proc x -> (doubled x + doubled 1, thrice x, O.twice x)
    |                                          ^^^^^^
    |
    = hint: write `3 * x`
  
  warning[W0317]: `twice` is deprecated
   --> uses.frob:5:52
    |
  5 | main = proc x -> (doubled x + doubled 1, thrice x, O.twice x)
    |                                                    ^^^^^^^
    |
    = hint: write `doubled`, its new name
  
  2 warnings
  $ tail -n 1 uses.frob
  main = proc x -> (doubled x + doubled 1, thrice x, O.twice x)

An import list names the old name, too.

  $ printf 'import Old (twice)\n\nmain :: SF Float Float\nmain = proc x -> twice x\n' > listed.frob
  $ frobc fix listed.frob; cat listed.frob
  warning[W0317]: `twice` is deprecated
   --> listed.frob:4:18
    |
  4 | main = proc x -> twice x
    |                  ^^^^^
    |
    = hint: write `doubled`, its new name, and import it
  
  1 warning
  import Old (twice)
  
  main :: SF Float Float
  main = proc x -> twice x
