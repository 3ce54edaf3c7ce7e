The robot follows a course of tape with a camera that has latency, noise and lost frames.

  $ sh seeds.sh ../../../examples/line_by_camera pioneer 1 collisions 0 0 mean_distance_from_the_tape 0 0.03 largest_distance_from_the_tape 0 0.07 distance_along_the_tape 12 14 -- --for 60s
  pioneer: 0 of 1 seeds out of bounds

A recording replays bit for bit, on both engines.

  $ line=../../../examples/line_by_camera/line_by_camera.frob
  $ frobc run $line --for 5s --record run.csv > summary
  $ frobc trace $line --robot pioneer --input run.csv > replayed.csv
  $ grep -v '^#' run.csv | sed 's/"[^"]*"//' | cut -d, -f1,31- | cmp - replayed.csv
  $ frobc trace $line --robot pioneer --input run.csv --engine interp | cmp - replayed.csv

At the end of the line the robot searches for it, and finds it again, in the
opposite direction.

  $ cat > end.toml <<'TOML'
  > [start]
  > x = 0
  > y = 0
  > [camera]
  > pitch_deg = 35
  > [[tape]]
  > points = [[0.2, 0], [2, 0]]
  > width = 0.05
  > colour = "blue"
  > [floor]
  > colour = "#d8d4c8"
  > TOML
  $ frobc run $line --world end.toml --for 30s --record run.csv > summary
  $ frobc trace $line --robot pioneer --input run.csv --modes | sed '1d; s/.*,//' | uniq | sed '1{/search/d}' | head -3
  follow
  search
  follow
