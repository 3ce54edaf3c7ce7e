One wall follower, unchanged, on three robots in the same room: once round it,
touching nothing. `make seeds` does the same with a hundred seeds.

  $ sh seeds.sh ../../../examples/wall_follow pioneer 5 distance_driven 17 20 mean_wall_distance_error 0 0.03 largest_wall_distance_error 0 0.15 collisions 0 0
  pioneer: 0 of 5 seeds out of bounds
  $ sh seeds.sh ../../../examples/wall_follow scout 5 distance_driven 13 20 mean_wall_distance_error 0 0.03 largest_wall_distance_error 0 0.15 collisions 0 0
  scout: 0 of 5 seeds out of bounds
  $ sh seeds.sh ../../../examples/wall_follow create 5 distance_driven 17 20 mean_wall_distance_error 0 0.03 largest_wall_distance_error 0 0.15 collisions 0 0
  create: 0 of 5 seeds out of bounds

A recording replays bit for bit, on both engines.

  $ follow=../../../examples/wall_follow/wall_follow.frob
  $ for robot in scout create; do
  >   frobc run $follow --robot $robot --for 20s --record run.csv > summary
  >   frobc trace $follow --robot $robot --input run.csv > replayed.csv
  >   frobc trace $follow --robot $robot --input run.csv --engine interp | cmp - replayed.csv
  >   head -1 replayed.csv
  >   wide=$(head -1 replayed.csv | tr ',' '\n' | wc -l)
  >   awk -F, -v wide=$wide '{ row = $1; for (i = NF - wide + 2; i <= NF; i++) row = row "," $i; print row }' run.csv |
  >     cmp - replayed.csv
  > done
  time,out.forward,out.turn
  time,out.forward,out.turn,out.powerColour,out.powerLight,out.checkLight,out.dockLight,out.spotLight,out.debrisLight,out.tone

A world may name its robot. A program that leaves its robot open then needs no
option, and a program for a specific robot must be for that one.

  $ cat > open.frob <<'FROB'
  > import Robot
  > main :: (HasBumpers i, DiffDrive o) => Program i o
  > main = reactimateRobot (proc i -> roMake (setVelTR (if bumped i then 0 else 0.2[m/s]) 0))
  > FROB
  $ printf 'robot = "create"\n[start]\nx = 0\ny = 0\n[[wall]]\npoints = [[1, -2], [1, 2]]\n' > ahead.toml
  $ frobc run open.frob --world ahead.toml --for 10s | grep collisions
  collisions: 1
  $ frobc run open.frob --world ahead.toml --robot scout
  error: ahead.toml: this world is for create, not for scout
  [2]
  $ cat > pioneer.frob <<'FROB'
  > import Robot
  > main :: Program RobotInput RobotOutput
  > main = reactimateRobot (constant (roMake id))
  > FROB
  $ frobc run pioneer.frob --world ahead.toml
  error[E0503]: `main` is a program for `pioneer`, not for `create`
   --> pioneer.frob:3:1
    |
  3 | main = reactimateRobot (constant (roMake id))
    | ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    |
    = hint: allow any robot, as in `main :: (HasSonar i, DiffDrive o) => Program i o`
  
  1 error
  [1]
  $ sed -i s/create/creator/ ahead.toml
  $ frobc run pioneer.frob --world ahead.toml
  error: ahead.toml:1:9: there is no robot `creator`; the robots are pioneer, scout, create, ros; remove `robot` if the world is for your own robot
  [2]

A Create senses where the floor ends. A robot without such sensors falls, and stays there.

  $ cat > edge.toml <<'TOML'
  > robot = "create"
  > [start]
  > x = 0
  > y = 0
  > [[hole]]
  > points = [[1, -1], [2, -1], [2, 1], [1, 1]]
  > TOML
  $ cat > careful.frob <<'FROB'
  > import Robot
  > main :: (HasCliffs i, DiffDrive o) => Program i o
  > main = reactimateRobot (proc i -> roMake (setVelTR (if cliffAhead i then 0 else 0.2[m/s]) 0))
  > FROB
  $ frobc run careful.frob --world edge.toml --for 20s --record log.csv | grep driven
  distance driven: 0.872 m
  $ cut -d, -f8-13,29 log.csv | uniq
  in.bumpRight,in.leftDrop,in.rightDrop,in.cliffs[0],in.cliffs[1],in.cliffs[2],in.obeying
  false,false,false,false,false,false,true
  false,false,false,false,true,true,true
  $ sed 's/cliffAhead i/wheelDropped i/' careful.frob > careless.frob
  $ frobc run careless.frob --world edge.toml --for 20s --record log.csv | grep driven
  distance driven: 1.022 m
  $ cut -d, -f8-13,29 log.csv | uniq
  in.bumpRight,in.leftDrop,in.rightDrop,in.cliffs[0],in.cliffs[1],in.cliffs[2],in.obeying
  false,false,false,false,false,false,true
  false,false,false,false,true,true,true
  false,false,false,true,true,true,true
  false,true,true,true,true,true,false

A Scout's bumpers report from which side they are pressed: it drives backwards into the wall.

  $ cat > back.frob <<'FROB'
  > import Robot
  > main :: (HasBumpers i, DiffDrive o) => Program i o
  > main = reactimateRobot (proc _ -> roMake (setVelTR (-0.2[m/s]) 0))
  > FROB
  $ printf '[start]\nx = 0\ny = 0\n[[wall]]\npoints = [[-1, -2], [-1, 2]]\n' > behind.toml
  $ frobc run back.frob --robot scout --world behind.toml --for 10s --record log.csv | grep collisions
  collisions: 1
  $ tr ',' '\n' < log.csv | head -30 | grep -n bumpers
  23:in.bumpers[0]
  24:in.bumpers[1]
  25:in.bumpers[2]
  26:in.bumpers[3]
  27:in.bumpers[4]
  28:in.bumpers[5]
  $ cut -d, -f23-28 log.csv | sort -u
  false,false,false,false,false,false
  false,false,false,true,false,false
  in.bumpers[0],in.bumpers[1],in.bumpers[2],in.bumpers[3],in.bumpers[4],in.bumpers[5]
