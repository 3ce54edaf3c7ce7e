The robot that senses the floor drives three times round a course of tape.

  $ sh seeds.sh ../../../examples/line_follow create 5 collisions 0 0 mean_distance_from_the_tape 0 0.01 largest_distance_from_the_tape 0 0.04 distance_along_the_tape 45 50 -- --for 220s
  create: 0 of 5 seeds out of bounds

A recording replays bit for bit, on both engines; it contains the sensor
signals.

  $ follow=../../../examples/line_follow/line_follow.frob
  $ frobc run $follow --for 20s --record run.csv --picture run.svg > summary
  $ grep -E 'mean|along' summary | sed 's/[0-9.]* m$/N m/'
  mean distance from the tape: N m
  distance along the tape: N m
  $ grep -o 'distance from the middle of the tape' run.svg
  distance from the middle of the tape
  $ frobc trace $follow --robot create --input run.csv > replayed.csv
  $ frobc trace $follow --robot create --input run.csv --engine interp | cmp - replayed.csv
  $ cut -d, -f31-34 run.csv | sed 1q
  in.cliffSignals[0],in.cliffSignals[1],in.cliffSignals[2],in.cliffSignals[3]

The robot loses the line at a corner, searches, and finds it again; at the end of the line it
searches and stops. It searches only at the corner and at the end.

  $ cat > corner.toml <<'TOML'
  > robot = "create"
  > [start]
  > x = 0
  > y = 0
  > [[tape]]
  > points = [[0.5, 0], [2.5, 0], [2, 1.3], [0.5, 1.3]]
  > width = 0.08
  > [measure]
  > what = "tape"
  > settle = 4
  > TOML
  $ frobc run $follow --world corner.toml --exit-when-done --for 60s --record run.csv > summary
  $ . ./within.sh
  $ within distance_along_the_tape 4.5 4.7 largest_distance_from_the_tape 0 0.06 finished_after 30 38 < summary
  $ awk -F, 'NR > 1 { print $35 != 0 ? "drives" : $36 != 0 ? "searches" : "rests" }' run.csv | uniq
  drives
  searches
  drives
  searches
  rests

Without a line it gives up.

  $ printf 'robot = "create"\n[start]\nx = 0\ny = 0\n' > bare.toml
  $ frobc run $follow --world bare.toml --exit-when-done --for 60s | grep finished
  finished after: 20.000 s

A robot without floor sensors is rejected.

  $ frobc check $follow --robot scout 2>&1 | head -1
  error[E0503]: `scout` has no `HasFloorSensors`
