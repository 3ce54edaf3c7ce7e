An outage of the world: the host loses the robot for 4 s, as if its line were lost. The program does
not run meanwhile. Afterwards `outage` returns the length, and the program's controllers take one
step of 0.2 s, not one of 4 s. A low-pass counts the whole time, because its stored value is old.

  $ cat > world.toml <<TOML
  > [start]
  > x = 1
  > y = 1
  > [outage]
  > from = 2
  > lasts = 4
  > TOML
  $ cat > drives.frob <<FROB
  > import Control
  > import Robot
  > main :: DiffDrive o => Program i o
  > main = reactimateRobot (proc _ -> roMake (setVelTR v 0) where
  >     v = rateLimit 0.25[m/s^2] (if time () < 0.05[s] then 0 else 1[m/s])
  >     _away = outage ()
  >     _total = pid gains 1[m/s]
  >     _smooth = lowPass 0.5[s] v)
  > gains :: Pid[m/s, m]
  > gains = Pid { kp = 0, ki = 1, kd = 0, largest = 10[m] }
  > FROB
  $ run () { frobc run drives.frob --world world.toml --for 8s --record $1.csv --robot $1 | grep distance; }
  $ run pioneer
  distance driven: 1.453 m
  $ frobc trace drives.frob --robot pioneer --input pioneer.csv --probe v --probe _away --probe _total --probe _smooth > seen.csv
  $ head -1 seen.csv; awk -F, '$1 >= 1.95 && $1 < 6.05' seen.csv
  time,out.forward,out.turn,probe.main.v,probe.main._away,probe.main._total,probe.main._smooth
  1.960000000,0.48000000000000032,0,0.48000000000000032,,1.9600000000000013,0.35789540580195184
  1.980000000,0.48500000000000032,0,0.48500000000000032,,1.9800000000000013,0.36278404404033832
  6.000000000,0.53500000000000036,0,0.53500000000000036,4.0199999999999996,2.1800000000000015,0.51594956239384304
  6.020000000,0.54000000000000037,0,0.54000000000000037,,2.2000000000000015,0.51687457922484914
  6.040000000,0.54500000000000037,0,0.54500000000000037,,2.2200000000000015,0.51795632617773957

The recording is replayed bit for bit, in both engines, for each robot.

  $ for robot in pioneer scout create; do
  >   run $robot > told
  >   frobc trace drives.frob --robot $robot --input $robot.csv > c.csv
  >   frobc trace drives.frob --robot $robot --input $robot.csv --engine interp | cmp - c.csv
  >   cut -d, -f$(head -1 $robot.csv | tr , '\n' | grep -n out.forward | cut -d: -f1) $robot.csv > recorded
  >   cut -d, -f2 c.csv | cmp - recorded
  > done

The robot stands still during the outage, and for one more instant: the first command afterwards is
zero. A trial has the same outage, and its judge sees it.

  $ cat > judged.frob <<FROB
  > import Robot
  > import Trial
  > main :: DiffDrive o => Program i o
  > main = reactimateRobot (proc _ -> roMake (setVelTR 0.3[m/s] 0))
  > trial "stands" = Trial { world = "world.toml", lasts = 7[s], seeds = 1 \`to\` 2, judge = proc t ->
  >     verdict (time () < 3[s] || time () > 6.01[s] || derivative t.driven < 0.01[m/s])
  > }
  > FROB
  $ frobc test judged.frob --robot create
  ok    stands: 2 seeds, 7 s
  1 test: all hold

Overlapping outages are rejected.

  $ printf '[start]\nx = 0\ny = 0\n[outage]\nlasts = 4\nevery = 2\n' > twice.toml
  $ frobc run drives.frob --world twice.toml --for 1s --robot create
  error: twice.toml:6:9: the next outage begins before this one is over: make `every` longer than `lasts`
  [2]
