The robot follows a rolling ball with a camera that has latency, noise and lost frames.

  $ follow=../../../examples/follow_ball/follow_ball.frob
  $ sh seeds.sh ../../../examples/follow_ball pioneer 3 collisions 0 0 mean_ball_distance_error 0 0.03 largest_ball_distance_error 0 0.05 -- --for 45s
  pioneer: 0 of 3 seeds out of bounds

The same on other robots with a camera.

  $ for robot in scout create; do sh seeds.sh ../../../examples/follow_ball $robot 1 collisions 0 0 mean_ball_distance_error 0 0.03 -- --for 30s; done
  scout: 0 of 1 seeds out of bounds
  create: 0 of 1 seeds out of bounds

Once the robot follows the ball, it never loses sight of it for long: there is no second search.

  $ frobc run $follow --for 10s --record run.csv --picture run.svg > summary
  $ frobc trace $follow --robot pioneer --input run.csv --modes | sed 's/.*,//' | uniq
  mode.reactimateTask
  search
  follow

A recording replays bit for bit, on both engines; the picture shows the last image of the camera.

  $ grep -v '^#' run.csv | sed 's/"[^"]*"//' | cut -d, -f1,31,32,33 > recorded.csv
  $ frobc trace $follow --robot pioneer --input run.csv > replayed.csv
  $ cmp recorded.csv replayed.csv
  $ frobc trace $follow --robot pioneer --input run.csv --engine interp | cmp - replayed.csv
  $ grep -c 'href="data:image/png;base64,' run.svg; grep -o 'camera frame at' run.svg
  1
  camera frame at

Without a ball it searches for one.

  $ sed '/^\[\[ball\]\]/,/^$/d; /^\[measure\]/,/^$/d' ../../../examples/follow_ball/world.toml > empty.toml
  $ frobc run $follow --world empty.toml --for 5s --record empty.csv > summary
  $ frobc trace $follow --robot pioneer --input empty.csv --modes | sed 's/.*,//' | uniq
  mode.reactimateTask
  search
