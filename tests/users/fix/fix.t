`frobc fix` applies the fixes of messages if they are certain to be right, and prints the remaining
messages.

  $ cat > drive.frob <<'END'
  > import Geometry
  > import Robot
  > import Control (limit, lowPass)
  > 
  > vMax = 0.4 [m/s]
  > 
  > main = reactimateRobot (proc i -> roMake (setVelTR v omega) where
  >     v     = limit vMax (0.5[1/s] * - frontSonar i)
  >     omega = 0.3)
  > END
  $ cp drive.frob before.frob
  $ frobc fix --diff drive.frob 2> left
  --- drive.frob
  +++ drive.frob
  @@ -2,8 +2,8 @@
   import Robot
   import Control (limit, lowPass)
   
  -vMax = 0.4 [m/s]
  +vMax = 0.4[m/s]
   
   main = reactimateRobot (proc i -> roMake (setVelTR v omega) where
  -    v     = limit vMax (0.5[1/s] * - frontSonar i)
  +    v     = limit vMax (0.5[1/s] * (- frontSonar i))
       omega = 0.3)
  [1]
  $ cmp drive.frob before.frob
  $ frobc fix drive.frob
  drive.frob:5:12: remove the space (E0110)
  drive.frob:8:36: put parentheses around it (E0113)
  1 more fix may not be what you meant; to apply it, run frobc fix --all
  error[E0320]: expected the unit `1/s`, found none
   --> drive.frob:7:54
    |
  7 | main = reactimateRobot (proc i -> roMake (setVelTR v omega) where
    |                                           --------   ^^^^^ this is `Float`
    |                                           |
    |                                           argument 2 of `setVelTR` is `AngularVelocity` (1/s)
  8 |     v     = limit vMax (0.5[1/s] * (- frontSonar i))
  9 |     omega = 0.3)
    |             --- `omega` is defined as this number
    |
    = hint: write `0.3[deg/s]` for degrees per second, or `0.3[rad/s]` for radians per second
  
  1 error
  [1]
  $ sed -i 's/0.3)/0.3[rad\/s])/' drive.frob
  $ frobc fix drive.frob
  drive.frob:1:1: remove it (W0306)
  drive.frob:3:24: remove it (W0306)
  $ cat drive.frob
  import Robot
  import Control (limit)
  
  vMax = 0.4[m/s]
  
  main = reactimateRobot (proc i -> roMake (setVelTR v omega) where
      v     = limit vMax (0.5[1/s] * (- frontSonar i))
      omega = 0.3[rad/s])

With `--all`, it also applies fixes that may not be what the author meant; if there are several for
one place, the first.

  $ cat > turn.frob <<'END'
  > import Robot
  > main = reactimateRobot (proc _ -> roMake (setVelTR 0 30))
  > END
  $ frobc fix turn.frob
  1 more fix may not be what you meant; to apply it, run frobc fix --all
  error[E0320]: expected the unit `1/s`, found none
   --> turn.frob:2:54
    |
  2 | main = reactimateRobot (proc _ -> roMake (setVelTR 0 30))
    |                                           --------   ^^ this is `Float`
    |                                           |
    |                                           argument 2 of `setVelTR` is `AngularVelocity` (1/s)
    |
    = hint: write `30[deg/s]` for degrees per second, or `30[rad/s]` for radians per second
  
  1 error
  [1]
  $ frobc fix --all turn.frob
  turn.frob:2:54: write `30[deg/s]` (E0320)
  $ cat turn.frob
  import Robot
  main = reactimateRobot (proc _ -> roMake (setVelTR 0 30[deg/s]))

If a case or guards are incomplete, the missing branches are added below the existing ones; the
value is `_`, which does not compile, so that it is not forgotten.

  $ cat > cases.frob <<'END'
  > data Side = LeftSide | RightSide | Ahead Float
  > 
  > sign :: Maybe Side -> Float
  > sign s = case s of
  >     Just LeftSide -> 1  -- to the left
  > 
  > steps :: Int -> Float
  > steps = \case
  >     1 -> 0.5
  >     2 | False -> 1
  >         where unused = 3
  >     n | n > 2 -> 3
  > 
  > limited :: Float -> Float
  > limited x
  >     | x < 0 = 0  -- never below
  >     | x > 1 = 1  -- nor above
  > 
  > both :: Maybe Float -> Float
  > both m = 1 + (case m of Just x | x > 0 -> x)
  > END
  $ frobc fix --all --diff cases.frob 2> left
  --- cases.frob
  +++ cases.frob
  @@ -3,6 +3,9 @@
   sign :: Maybe Side -> Float
   sign s = case s of
       Just LeftSide -> 1  -- to the left
  +    Nothing -> _
  +    Just RightSide -> _
  +    Just (Ahead _) -> _
   
   steps :: Int -> Float
   steps = \case
  @@ -10,11 +13,15 @@
       2 | False -> 1
           where unused = 3
       n | n > 2 -> 3
  +      | otherwise -> _
   
   limited :: Float -> Float
   limited x
       | x < 0 = 0  -- never below
       | x > 1 = 1  -- nor above
  +    | otherwise = _
   
   both :: Maybe Float -> Float
  -both m = 1 + (case m of Just x | x > 0 -> x)
  +both m = 1 + (case m of Just x | x > 0 -> x
  +                        Nothing -> _
  +                        Just _ -> _)
  [1]
  $ frobc fix --all cases.frob 2> left; frobc check cases.frob 2>&1 | grep -c E0114
  cases.frob:4:15: add the missing cases (E0350)
  cases.frob:8:9: add the missing cases (E0350)
  cases.frob:16:7: add the missing cases (E0352)
  cases.frob:20:20: add the missing cases (E0350)
  4

In JSON, each fix is listed with its diagnostic.

  $ cat > unused.frob <<'END'
  > main :: SF Float Float
  > main = proc x -> 1
  > END
  $ frobc check --format=json unused.frob 2>&1 | sed 's/.*"fixes"://; s/,"rendered".*//'
  [{"title":"write `_x`","safe":true,"edits":[{"span":{"file_name":"unused.frob","byte_start":35,"byte_end":36,"line_start":2,"line_end":2,"column_start":13,"column_end":14},"text":"_x"}]}]

Files that are not programs or do not exist are left alone; a program without fixes does not change
by a byte.

  $ printf 'main = \377\n' > bytes.frob
  $ cp bytes.frob before.frob
  $ frobc fix bytes.frob
  error[E0101]: this file is not valid UTF-8: byte 255 is not allowed here
   --> bytes.frob:1:8
    |
  1 | main = �
    |        ^
    |
    = hint: save the file as UTF-8 text
  
  1 error
  [1]
  $ cmp bytes.frob before.frob
  $ frobc fix missing.frob
  error: there is no file missing.frob
  [2]
  $ printf '\357\273\277main :: SF Float Float\r\nmain = proc x -> y\r\n' > crlf.frob
  $ frobc fix crlf.frob
  error[E0205]: unknown name `y`
   --> crlf.frob:2:18
    |
  2 | main = proc x -> y
    |                  ^
  
  1 error
  [1]
  $ printf '\357\273\277main :: SF Float Float\r\nmain = proc x -> 1\r\n' > crlf.frob
  $ frobc fix crlf.frob
  crlf.frob:2:13: write `_x` (W0305)
  $ od -c crlf.frob | head -4
  0000000 357 273 277   m   a   i   n       :   :       S   F       F   l
  0000020   o   a   t       F   l   o   a   t  \r  \n   m   a   i   n    
  0000040   =       p   r   o   c       _   x       -   >       1  \r  \n
  0000060

Comments are kept, wherever they are in the text that a fix removes; so are line endings,
permissions and the other names of a file.

  $ cat > why.frob <<'END'
  > import Control -- why
  > import Geometry (zeroVec, -- the origin
  >     dot, norm) -- of vectors
  > import Past {- one -} (always, {- two -} since) -- three
  > import Robot
  >   -- four
  > 
  > main :: SF Float Float
  > main = proc x -> norm zeroVec + x -- five
  > END
  $ sed 's/$/\r/' why.frob > windows.frob && ln windows.frob other.frob && chmod 640 windows.frob
  $ frobc fix why.frob && cat why.frob && frobc check why.frob
  why.frob:1:1: remove it (W0306)
  why.frob:3:5: remove it (W0306)
  why.frob:4:24: remove it (W0306)
  why.frob:5:1: remove it (W0306)
  -- why
  import Geometry (zeroVec -- the origin
      , norm) -- of vectors
  {- one -}
  {- two -}
  -- three
    -- four
  
  main :: SF Float Float
  main = proc x -> norm zeroVec + x -- five
  $ frobc fix windows.frob > said && sed 's/\r$//' windows.frob | cmp - why.frob
  $ grep -vc "$(printf '\r')$" windows.frob; cmp windows.frob other.frob && stat -c '%a %h' windows.frob
  0
  640 2
  $ printf 'import Control -- | what it is for\n\nmain :: SF Float Float\nmain = arr id\n' > doc.frob
  $ frobc fix doc.frob 2>&1 | head -1; head -1 doc.frob
  warning[W0306]: `Control` is imported, but nothing from it is used
  import Control -- | what it is for
  $ printf 'main :: SF Float Float\nmain = proc x -> 1\n' > locked.frob && chmod 444 locked.frob && frobc fix locked.frob
  error: cannot write locked.frob: it is read-only; make it writable with `chmod u+w`
  [2]
  $ mkdir folder.frob
  $ frobc fix folder.frob
  error: cannot read folder.frob: it is a directory
  [2]
