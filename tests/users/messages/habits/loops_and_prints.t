A loop over an array that a function returns, and a loop that counts:

  $ cat > count.frob <<'FROB'
  > import Robot
  > 
  > main :: SF RobotInput Int
  > main = proc i -> n where
  >     n = 0
  >     for s in sonars i:
  >         if isEvent s.echo then n = n + 1
  > FROB
  $ frobc check count.frob 2>&1 | grep hint
    = hint: Frob has no `for` loops: to count the elements for which a condition holds, write `foldl (\count s -> if isEvent s.echo then count + 1 else count) 0 (sonars i)`
  $ sed '/for s/d;/if isEvent/d' count.frob > cured.frob
  $ sed -i 's/n = 0/n = foldl (\\count s -> if isEvent s.echo then count + 1 else count) 0 (sonars i)/' cured.frob
  $ frobc check cured.frob
  $ sed 's/if isEvent.*/if isEvent s.echo:/;$a\            n += 1' count.frob > python.frob
  $ frobc check python.frob 2>&1 | grep 'foldl'
    = hint: Frob has no `for` loops: to count the elements for which a condition holds, write `foldl (\count s -> if isEvent s.echo then count + 1 else count) 0 (sonars i)`
  $ sed 's/if isEvent.*/n = n + s.range/' count.frob > sum.frob
  $ frobc check sum.frob 2>&1 | grep hint
    = hint: Frob has no loops: write `map f (sonars i)` or `foldl (+) 0 (sonars i)` for an array, or `forEachT (sonars i) f` to run a task for each element

A robot's program has no other outputs, so the hint for `print` names the ways to see a signal:

  $ cat > print.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     v = min 0.3[m/s] (0.5[1/s] * frontSonar i)
  >     print(v))
  > FROB
  $ frobc check print.frob 2>&1 | grep hint
    = hint: a program cannot print, so remove this line: `frobc run FILE --view` shows every signal, `--probe v --record run.csv` records the signal `v`, and the result of a task is printed when the task ends
  $ sed '/print/d;s/frontSonar i)/frontSonar i))/' print.frob > cured.frob
  $ frobc run cured.frob --for 1s --probe v --record run.csv > /dev/null 2>&1
  $ head -1 run.csv | grep -o 'probe[^,]*v$'
  probe.main.v
