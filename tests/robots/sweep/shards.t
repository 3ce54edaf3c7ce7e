A hundred shards, of which some have a run more than others, in any order and two at a time.

  $ cat > follow.frob << 'FROB'
  > import Robot
  > import Trial
  > import WallFollow
  > param gap :: Distance = 0.3[m]
  > main :: (HasSonar i, DiffDrive o) => Program i o
  > main = reactimateRobot (wallFollow1 gap)
  > trial "keeps off" = Trial { world = "room.toml", lasts = 1[s], seeds = 1 `to` 45, judge = proc t -> neverTouches t where
  >     error = meanOf (t.clearance - gap)
  > }
  > FROB
  $ cat > gaps.toml << 'PLAN'
  > program = "follow.frob"
  > robots = ["pioneer", "scout"]
  > [params]
  > gap = "0.2[m] to 0.4[m], 3 steps"
  > PLAN
  $ frobc sweep gaps.toml --rows whole --table whole.csv > told
  $ seq 100 -1 1 | xargs -P 2 -I K frobc sweep gaps.toml -j 1 --shard K/100 > /dev/null
  $ cat gaps.rows/*.rows | cut -f 1 | sort | uniq -c | awk '{ runs++; made += $1 } END { print runs, made }'
  270 270
  $ frobc sweep gaps.toml --merge > merged && cmp gaps.csv whole.csv && sed s/gaps.csv/whole.csv/ merged | diff - told
