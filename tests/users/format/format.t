`frobc format` formats programs in the style of the library, in place and without output.

  $ cat > speed.frob <<'EOF'
  > 
  > import   Control
  > 
  > 
  > 
  > lap::Distance
  > lap=10[ m ]
  > -- | Where it is,and whether a lap is done.
  > main::SF Velocity (Distance,Bool)
  > main=proc v->(x,x>=lap && -x< -lap/2) where
  >   x=integral(v)   -- as the crow flies
  >   unused  = \y->-y
  > EOF
  $ frobc format speed.frob
  $ cat speed.frob
  import Control
  
  lap :: Distance
  lap = 10[m]
  -- | Where it is,and whether a lap is done.
  main :: SF Velocity (Distance, Bool)
  main = proc v -> (x, x >= lap && -x < -lap / 2) where
      x = integral (v)   -- as the crow flies
      unused = \y -> -y

Line breaks are kept; each block is indented by four more columns, and `then`, `else` and a `where`
on its own line by two; a list whose lines begin with commas has them below its bracket. Text that
was aligned with spaces stays aligned, including renamed or added lines in between.

  $ frobc format - <<'EOF'
  > next n = do
  >  found  <- search
  >  place <- ask (arr (\i -> i))
  >  if found
  >     then do
  >         drive
  >     else return False
  > table = [ 1
  >         , 2   -- two
  >         , 333 -- three
  >   ]
  > f x = g (case x of
  >   Just y   | y > 0 -> y
  >            | otherwise -> -y
  >   Nothing  -> z
  >   _ -> 2)
  >    where z = 1
  >          name = 0
  > control = proc e -> v where
  >     error  = e
  >     velocity      = limit 1 error
  >     -- of both
  >     v      = velocity
  > EOF
  next n = do
      found <- search
      place <- ask (arr (\i -> i))
      if found
        then do
          drive
        else return False
  table = [ 1
          , 2   -- two
          , 333 -- three
          ]
  f x = g (case x of
      Just y | y > 0 -> y
             | otherwise -> -y
      Nothing -> z
      _ -> 2)
    where z = 1
          name = 0
  control = proc e -> v where
      error    = e
      velocity = limit 1 error
      -- of both
      v        = velocity

A choice in a chain is aligned with the previous one; so is `in` with the `let` of a line.

  $ frobc format - <<'EOF'
  > speed = if far then 3
  >           else if near then 1
  >        else 0
  > turn = do
  >   if far
  >      then left
  >      else if near
  >         then do
  >              right
  >         else stop
  > sum = let
  >         a = 1
  >     in a
  > EOF
  speed = if far then 3
      else if near then 1
      else 0
  turn = do
      if far
        then left
        else if near
          then do
            right
          else stop
  sum = let
      a = 1
    in a

Lines of more than 100 characters are broken at the loosest-binding operators.

  $ frobc format - <<'EOF'
  > placesHeard :: Ranging -> (Pose -> Pose) -> Array n Pose -> SF (Facing, Array n (Event Distance)) (Array n (Maybe Point2))
  > turnBy angle = mkTask (proc i -> (roMake (setVelTR 0 omega), notYet (when (abs left < turnEnd))) where
  >     omega = limit turnSpeed (turnGain * left))
  > nearest = nearestBy ranging.reach (aside side square robot) (placesHeard ranging taken seats (robot, echoes))
  > total = theFirstOfManySummands * itsOwnFactor + theSecondOfManySummands * itsOwnFactor + theThird * its
  > start = Estimate { offset = 0.5[m], heading = 0, varOffset = 0.1[m^2], covariance = 0, varHeading = 0.05 }
  > along = [-0.98, -0.83, -0.56, -0.20, 0.20, 0.56, 0.83, 0.98, 0.98, 0.83, 0.56, 0.20, -0.20, -0.56, -0.83, -0.98]
  > EOF
  placesHeard :: Ranging -> (Pose -> Pose) -> Array n Pose
      -> SF (Facing, Array n (Event Distance)) (Array n (Maybe Point2))
  turnBy angle = mkTask (proc i ->
      (roMake (setVelTR 0 omega), notYet (when (abs left < turnEnd))) where
      omega = limit turnSpeed (turnGain * left))
  nearest = nearestBy ranging.reach (aside side square robot)
      (placesHeard ranging taken seats (robot, echoes))
  total = theFirstOfManySummands * itsOwnFactor + theSecondOfManySummands * itsOwnFactor
      + theThird * its
  start = Estimate
      { offset = 0.5[m], heading = 0, varOffset = 0.1[m^2], covariance = 0, varHeading = 0.05 }
  along =
      [ -0.98, -0.83, -0.56, -0.20, 0.20, 0.56, 0.83, 0.98, 0.98, 0.83, 0.56, 0.20, -0.20, -0.56
      , -0.83, -0.98
      ]

Literals, texts and comments are not changed. A comment on its own line is indented like the line
below it, or like its block; one at the end of a line moves with the line.

  $ frobc format - <<'EOF'
  > {- {- nested -}
  >       as it is -}
  > x = 0x1F+1_000 -- behind
  >                -- and below
  > y = f {- inner -} 2.50e3 "a -- b \" {-" where
  >   -- of a
  >   a = 1
  >   -- the end of the block
  > -- of z
  > z = 35[deg]-- close
  >    -- the end
  > EOF
  {- {- nested -}
        as it is -}
  x = 0x1F + 1_000 -- behind
                   -- and below
  y = f {- inner -} 2.50e3 "a -- b \" {-" where
      -- of a
      a = 1
      -- the end of the block
  -- of z
  z = 35[deg] -- close
  -- the end

`--check` writes nothing; it lists the files that would change, each with the first line that would,
and exits with 1.

  $ printf 'x = 1\ny=2\n' > small.frob
  $ frobc format --check speed.frob small.frob
  small.frob:2
    - y=2
    + y = 2
  [1]
  $ cat small.frob
  x = 1
  y=2
  $ frobc format --check - < speed.frob

A tab is as wide as editors show it, if the program is the same for all widths; a byte order mark is
removed. All lines get the line ending of the first one.

  $ printf '\357\273\277main = proc x -> y where\r\n\ty\t= x\r\n\tz = y -- a\tb\r\n' | frobc format - | cat -A
  main = proc x -> y where^M$
      y = x^M$
      z = y -- a  b^M$
  $ printf 'main = proc x -> y where\r\n    {- a\r\n\r\n    b -}\n  y = x\n\r\n' > ends.frob && frobc format ends.frob && cat -A ends.frob
  main = proc x -> y where^M$
      {- a^M$
  ^M$
      b -}^M$
      y = x^M$
  $ frobc format --check ends.frob

A file keeps its permissions and its other names; a read-only file is not
changed.

  $ printf 'x  = 1\n' > shared.frob && ln shared.frob other.frob && chmod 640 shared.frob
  $ frobc format shared.frob && cat other.frob && stat -c '%a %h' shared.frob
  x = 1
  640 2
  $ printf 'x  = 1\n' > locked.frob && chmod 444 locked.frob && frobc format locked.frob; cat locked.frob
  error: cannot write locked.frob: it is read-only; make it writable with `chmod u+w`
  x  = 1
  $ ls -A | grep -c '^.frobc'
  0
  [1]
  $ printf 'main = proc x -> y where\n    y = x\n\tz = y\n' | frobc format - 2>&1 | head -1
  error[E0102]: tabs are not allowed, because indentation is significant
  $ printf 'x = "a\tb"\n' | frobc format - 2>&1 | head -1
  error[E0102]: tabs are not allowed, because indentation is significant

A file that is not a program is not changed; the message is that of `frobc
check`.

  $ printf 'x  = (1\n' > broken.frob && cp broken.frob before
  $ frobc check broken.frob 2> said; frobc format small.frob broken.frob 2> message
  [1]
  $ diff said message && cmp broken.frob before && cat small.frob
  x = 1
  y = 2
  $ printf 'x = "M\374nchen"\n' > latin_1.frob
  $ frobc format latin_1.frob
  error[E0101]: this file is not valid UTF-8: byte 252 is not allowed here
   --> latin_1.frob:1:7
    |
  1 | x = "M�nchen"
    |       ^
    |
    = hint: save the file as UTF-8 text
  
  1 error
  [1]

The equations of a `where` belong to the field of a record, or the element of a list, that contains
them; so does the rest of a field.

  $ cat > trial.frob << 'FROB'
  > trial "keeps off" = Trial {
  >   world = "room.toml",
  >   judge = proc t -> neverTouches t where
  >         assert "far" (t.clearance > 0.5[m])
  >         assert "on time" (by 1[s] (t.driven > 1[m])),
  >   lasts = 6
  >    * tenSeconds,
  >   seeds = 1 `to` 2 }
  > 
  > both = [
  >     proc x -> y where
  >       y = x,
  >     proc x -> z
  >       where
  >         z = x
  > ]
  > FROB
  $ frobc format trial.frob && cat trial.frob
  trial "keeps off" = Trial {
      world = "room.toml",
      judge = proc t -> neverTouches t where
          assert "far" (t.clearance > 0.5[m])
          assert "on time" (by 1[s] (t.driven > 1[m])),
      lasts = 6
          * tenSeconds,
      seeds = 1 `to` 2 }
  
  both = [
      proc x -> y where
          y = x,
      proc x -> z
        where
          z = x
  ]
  $ frobc format trial.frob --check

Read and write errors are reported.

  $ mkfifo pipe; mkdir folder; echo '[robot]' > world.toml
  $ timeout 120 frobc format pipe folder world.toml none.frob
  error: cannot read pipe: it is a pipe or a device, not a file
  error: cannot read folder: it is a directory
  error: world.toml is not a Frob program but a world; use it with a program: `frobc run PROGRAM.frob --world world.toml`
  error: there is no file none.frob
  [2]
  $ frobc format - < folder
  error: cannot read standard input: Is a directory
  [2]
  $ printf 'x=1\n' | frobc format - > /dev/full
  error: cannot write to standard output: No space left on device
  [2]
  $ printf 'x=%0900d\n' 1 > large.frob && cp large.frob before
  $ (ulimit -f 0; frobc format large.frob 2>&1) | cat; cmp large.frob before; ls -A | grep '^\.frobc'
  error: cannot write large.frob: File too large
  [1]

A file keeps its permissions; a link stays a link; a formatted file is not touched.

  $ printf 'x=1\n' > real.frob; chmod 761 real.frob; ln -s real.frob link.frob
  $ frobc format link.frob
  $ stat -c '%a %F' real.frob link.frob; cat real.frob
  761 regular file
  777 symbolic link
  x = 1
  $ touch -d 2001-01-01 real.frob; frobc format real.frob; stat -c %y real.frob | cut -c1-10
  2001-01-01

Long files and long lines: a minute of processor time is far more than they need.

  $ within() { (ulimit -t "$1"; shift; exec "$@"); } # so many seconds of processor time
  $ for i in $(seq 100000); do echo "x$i=f $i"; done > many.frob
  $ within 60 frobc format many.frob && head -2 many.frob && wc -l < many.frob
  x1 = f 1
  x2 = f 2
  100000
  $ { printf 'x=[0'; for i in $(seq 100000); do printf ',%d' $i; done; echo ']'; } > wide.frob
  $ within 60 frobc format wide.frob && head -2 wide.frob && awk 'length > 100' wide.frob | wc -l
  x =
      [ 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25
  0
  $ { printf 'x='; for i in $(seq 2000); do printf '(f '; done; printf 1; for i in $(seq 2000); do printf ')'; done; echo; } > deep.frob
  $ within 60 frobc format deep.frob
  $ for i in $(seq 3000); do printf 'x%d = y%d   -- %d\n' $i $i $i; done > comments.frob
  $ within 60 frobc format comments.frob
  $ : > empty.frob; frobc format empty.frob; wc -c < empty.frob
  0
