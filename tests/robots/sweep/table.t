A sweep performs many runs of a trial, and writes a table of them: over worlds, robots, values of
parameters, and seeds, which vary fastest.

  $ cat > follow.frob << 'FROB'
  > import Robot
  > import Trial
  > import WallFollow
  > -- | How far from the wall.
  > param gap :: Distance = 0.3[m]
  > param speed :: Velocity = 0.3[m/s]
  > param on :: Bool = True
  > param laps :: Int = 3
  > follow :: (HasSonar i, DiffDrive o) => SF i o
  > follow = proc i -> roMake (setVelTR (if on then min speed v else 0) w) where
  >     (v, w) = wallFollow gap (0.3[m/s], frontSonar i, sideSonar i)
  > main :: (HasSonar i, DiffDrive o) => Program i o
  > main = reactimateRobot follow
  > trial "keeps, \"off\"" = Trial { world = "room.toml", lasts = 4[s], seeds = 1 `to` 2, judge = proc t -> neverTouches t where
  >     error = meanOf (t.clearance - gap)
  >     way = lastOf t.driven
  >     assert "keeps off" (t.driven < 1.2[m])
  > }
  > FROB
  $ printf '[start]\nx = 0\ny = 0\n' > empty.toml
  $ cat > gaps.toml << 'PLAN'
  > program = "follow.frob"
  > worlds = ["room.toml", "empty.toml"]
  > robots = ["pioneer", "scout"]
  > lasts = 4
  > 
  > [params]
  > gap = "20[cm] to 0.4[m], 3 steps"
  > speed = ["0.2[m/s]", "0.5[m/s]"]
  > PLAN
  $ frobc sweep gaps.toml --picture gaps.svg > told; sed -E 's/[0-9]+\.[0-9]+/N/g' told
  48 runs: 36 held, 12 failed
    error: mean N m, deviation N, from N (run 11) to N (run 13); not measured in 24 of 48 runs
    way: mean N m, deviation N, from N (run 25) to N (run 16)
  table: gaps.csv
  picture: gaps.svg
  $ cut -d, -f1-9 gaps.csv | sed -n '1,8p;45,$p'
  run,world,robot,gap,speed,seed,fate,at,by
  1,room.toml,pioneer,0.2,0.2,1,held,4.000000000,
  2,room.toml,pioneer,0.2,0.2,2,held,4.000000000,
  3,room.toml,pioneer,0.2,0.5,1,held,4.000000000,
  4,room.toml,pioneer,0.2,0.5,2,held,4.000000000,
  5,room.toml,pioneer,0.3,0.2,1,held,4.000000000,
  6,room.toml,pioneer,0.3,0.2,2,held,4.000000000,
  7,room.toml,pioneer,0.3,0.5,1,held,4.000000000,
  44,empty.toml,scout,0.3,0.5,2,violated,3.660000000,keeps off
  45,empty.toml,scout,0.4,0.2,1,held,4.000000000,
  46,empty.toml,scout,0.4,0.2,2,held,4.000000000,
  47,empty.toml,scout,0.4,0.5,1,violated,3.660000000,keeps off
  48,empty.toml,scout,0.4,0.5,2,violated,3.660000000,keeps off
  $ head -1 gaps.csv
  run,world,robot,gap,speed,seed,fate,at,by,x,y,heading,clearance,touches,driven,odometry_error,collisions,collision_at,collision_x,collision_y,collision_clearance,collision_with,error,way
  $ sed 's/<[^>]*>//g' gaps.svg | grep keeps
  keeps, &quot;off&quot;: fraction of runs that held
  keeps, &quot;off&quot;: error (m)
  keeps, &quot;off&quot;: way (m)

The table does not depend on the number of processes, or on the order in which earlier plans
performed its runs.

  $ frobc sweep gaps.toml -j 1 --rows one --table one.csv > /dev/null
  $ frobc sweep gaps.toml -j 8 --rows eight --table eight.csv > /dev/null
  $ cmp gaps.csv one.csv && cmp gaps.csv eight.csv
  $ sed 's/^lasts/seeds = [2, 3]\nlasts/' gaps.toml > more.toml
  $ frobc sweep more.toml --rows one --table more.csv > /dev/null
  $ frobc sweep more.toml --rows fresh --table fresh.csv > /dev/null
  $ cmp more.csv fresh.csv

Shards, on separate machines or not, produce the same table together.

  $ frobc sweep gaps.toml --shard 1/3 --rows first
  16 runs of shard 1/3 done; 32 remain for other shards; when all are done, create the table with `--merge`
  $ frobc sweep gaps.toml --shard 2/3 --rows second
  16 runs of shard 2/3 done; 32 remain for other shards; when all are done, create the table with `--merge`
  $ frobc sweep gaps.toml --merge --rows first --also second --table shards.csv
  error: 16 of 48 runs are missing: run their shards, or name their folder with `--also`
  [2]
  $ frobc sweep gaps.toml --shard 3/3 --rows second > /dev/null
  $ frobc sweep gaps.toml --merge --rows first --also second --table shards.csv > /dev/null && cmp gaps.csv shards.csv

Only changed runs are performed again: with another world, a different picture that hangs in it, or
another program.

  $ count () { cat gaps.rows/*.rows | wc -l; }
  $ count
  48
  $ frobc sweep gaps.toml > /dev/null; count
  48
  $ echo '# nothing new' >> empty.toml; frobc sweep gaps.toml > /dev/null; count
  72
  $ printf 'P6 1 1 255\nabc' > p.ppm
  $ sed -i '1i poster = [{ picture = "p.ppm", center = [1, 1], facing_deg = 0, size = [1, 1] }]' empty.toml
  $ frobc sweep gaps.toml > /dev/null; count
  96
  $ printf 'P6 1 1 255\nxyz' > p.ppm; frobc sweep gaps.toml > /dev/null; count
  120
  $ sed -i 's/min speed v/min speed (0.9 * v)/' follow.frob; frobc sweep gaps.toml > /dev/null; count
  168
  $ cmp -s gaps.csv one.csv
  [1]

--dry-run prints the number of runs, and how many of them are finished, without performing any; and
a digest that shows whether another machine would perform the same ones.

  $ dry () { frobc sweep "$@" --dry-run | grep -v digest; }
  $ dry gaps.toml
  runs: 48
  done: 48
  $ dry more.toml --rows gaps.rows --shard 2/3
  runs: 16
  done: 8
  $ digest () { frobc sweep "$@" --dry-run | grep digest; }
  $ mkdir elsewhere && cp follow.frob empty.toml p.ppm gaps.toml elsewhere && digest gaps.toml > here
  $ digest elsewhere/gaps.toml | diff here - && ls elsewhere
  empty.toml
  follow.frob
  gaps.toml
  p.ppm
  $ echo '# other' >> elsewhere/empty.toml; digest elsewhere/gaps.toml | cmp -s here -
  [1]

Points may be sampled: a Latin hypercube has one value in each part of each
range.

  $ cat > drawn.toml << 'PLAN'
  > program = "follow.frob"
  > robots = ["pioneer"]
  > seeds = [5, 5]
  > lasts = 0.1
  > sampling = "latin"
  > points = 10
  > [params]
  > gap = "0.1[m] to 1.1[m]"
  > laps = "1 to 5"
  > on = [true, false]
  > PLAN
  $ frobc sweep drawn.toml > /dev/null
  $ awk -F, 'NR > 1 { gap[int(($4 - 0.1) * 10)]++; laps[$5]++; on[$6]++ } END { for (k = 0; k < 10; k++) printf "%d", gap[k]; print ":"; for (k = 1; k <= 5; k++) printf "%d", laps[k]; print ":", on["true"], on["false"] }' drawn.csv
  1111111111:
  22222: 5 5
  $ cp drawn.csv again.csv; frobc sweep drawn.toml --rows other > /dev/null; cmp drawn.csv again.csv
  $ sed 's/latin/random/; s/^points/sampling_seed = 2\npoints/' drawn.toml > random.toml
  $ frobc sweep random.toml > /dev/null; awk -F, 'NR > 1 && $4 > 0.1 && $4 < 1.1' random.csv | wc -l
  10
