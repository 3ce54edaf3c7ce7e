A robot with a stereo head drives back and forth, slightly more than two metres
in front of a wall; pixels are noisy, frames lost, and the right camera is
slightly misaligned. Each depth is compared with the world. Every depth of the
wall is off by at most five percent, by whichever function; a box and a side
wall are where the floor plan has them.

  $ frobc run stereo.frob --world stereo.toml --for 6s --seed 1 --record run.csv > summary
  $ frobc trace stereo.frob --entry judged --input run.csv > judged.csv
  $ cat > worst.awk << 'AWK'
  > BEGIN { FS = "[{},= ]+"; split("wall 0.05 nearest 0.05 box 0.15 side 0.1 base 0.120001", limits, " ")
  >   for (i = 1; i < 10; i += 2) limit[limits[i]] = limits[i + 1] }
  > NF > 9 { for (i = 3; i < NF; i += 2) { n[$i]++; if ($(i + 1) > worst[$i]) worst[$i] = $(i + 1) } }
  > END { for (i = 1; i < 10; i += 2) { k = limits[i]
  >   print k, (n[k] > 160 && worst[k] < limit[k] ? "within " limit[k] : worst[k] " of " n[k]) } }
  > AWK
  $ awk -f worst.awk judged.csv
  wall within 0.05
  nearest within 0.05
  box within 0.15
  side within 0.1
  base within 0.120001

The interpreter has the same results, bit for bit.

  $ frobc trace stereo.frob --entry judged --input run.csv --engine interp | cmp - judged.csv

A right camera that is misaligned by a degree falsifies distances.

  $ sed 's/askew_yaw_deg = .*/askew_yaw_deg = 1/' stereo.toml > askew.toml
  $ frobc run stereo.frob --world askew.toml --for 0.5s --seed 1 --record askew.csv > summary
  $ frobc trace stereo.frob --entry judged --input askew.csv | sed -n 2p | grep -c 'wall = 0.[2-9]'
  1

A bare wall has no depth, and there is no pair if one of its frames is missing.

  $ sed 's/^closed = true/&\ntexture = "plain"/; s/^noise.*//' stereo.toml > bare.toml
  $ cat > bare.frob << 'FROB'
  > import Pioneer
  > import Robot
  > import Stereo
  > import Vision
  > 
  > ahead :: Region
  > ahead = Region { x = 160[px], y = 50[px], width = 60[px], height = 60[px] }
  > 
  > main = reactimateRobot (proc i -> roMake (setVelTR (hold 0 (mapE (\_ -> 0) (stereo i))) 0))
  > 
  > seen :: SF PioneerInput (Event (Maybe Distance))
  > seen = proc i -> nearestSeen ahead i
  > FROB
  $ frobc run bare.frob --world bare.toml --for 0.2s --record bare.csv > summary
  $ frobc trace bare.frob --entry seen --input bare.csv | cut -d, -f2 | sort | uniq -c | sed 's/^ *//'
  5 
  6 Nothing
  1 out
  $ sed 's/"Frame [^"]*"\(,[^,]*,[^,]*\)$/\1/' bare.csv > half.csv
  $ cp -r bare.frames half.frames
  $ frobc trace bare.frob --entry seen --input half.csv | cut -d, -f2 | sort | uniq -c | sed 's/^ *//'
  11 
  1 out
