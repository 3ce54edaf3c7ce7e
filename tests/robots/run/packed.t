Runs with compressed recordings: the same rows, and the same replay.

  $ examples=../../../examples
  $ drive=$examples/wall_follow/wall_follow.frob
  $ frobc run $drive --for 60s --record plain.csv > summary
  $ for ending in gz zst; do
  >   frobc run $drive --for 60s --record run.csv.$ending | grep log
  > done
  log: run.csv.gz
  log: run.csv.zst
  $ gzip -dc run.csv.gz | cmp - plain.csv
  $ zstd -dqc run.csv.zst | cmp - plain.csv
  $ frobc trace $drive --input plain.csv --output out.csv
  $ frobc trace $drive --input run.csv.gz | cmp - out.csv
  $ frobc trace $drive --input run.csv.zst | cmp - out.csv

With a camera: its frames are stored next to the recording, in the folder that they would have if it
were compressed later.

  $ see=$examples/follow_ball/follow_ball.frob
  $ frobc run $see --for 3s --record ball.csv.gz > summary
  $ ls -d ball*
  ball.csv.gz
  ball.frames
  $ frobc trace $see --input ball.csv.gz --output ball.out.csv
  $ gunzip ball.csv.gz
  $ frobc trace $see --input ball.csv | cmp - ball.out.csv
  $ columns='NR == 1 { for (k = 1; k <= NF; k++) if ($k == "out.turn") f = k } { print $1, $f }'
  $ grep -v '^#' ball.csv | sed 's/"[^"]*"//g' | awk -F, "$columns" > recorded
  $ awk -F, "$columns" ball.out.csv | cmp - recorded

With several robots, each has a recording:

  $ cat > two.toml <<END
  > [[start]]
  > x = 2
  > y = 2
  > [[start]]
  > x = 6
  > y = 6
  > END
  $ frobc run $drive --world two.toml --for 1s --record two.csv.gz > summary
  $ ls two*
  two-1.csv.gz
  two-2.csv.gz
  two.toml

A host that is killed leaves a complete archive, because gzip writes it; so does one that is
interrupted together with all processes of its group.

  $ frobc build --shared $drive -o drive.so
  $ host=$(dirname $(dirname $(command -v frobc)))/lib/frobc/frob-sim
  $ whole () { # waits until gzip has ended, too
  >   for i in $(seq 100); do gzip -t $1 2> /dev/null && break; sleep 0.1; done
  >   gzip -dc $1 > killed.csv; rows=$(wc -l < killed.csv)
  >   frobc trace $drive --input $1 > killed.out
  >   head -n $rows plain.csv | cmp - killed.csv && test $rows -gt 20 && echo "as far as it went"
  > }
  $ $host ./drive.so --world $examples/wall_follow/world.toml --for 60 --realtime --record killed.csv.gz > summary & pid=$!
  $ sleep 2; kill -9 $pid; wait $pid 2> /dev/null
  [137]
  $ whole killed.csv.gz
  as far as it went
  $ setsid $host ./drive.so --world $examples/wall_follow/world.toml --for 60 --realtime --record int.csv.gz > summary 2> /dev/null & pid=$!
  $ sleep 2; kill -INT -$pid; wait $pid 2> /dev/null
  $ whole int.csv.gz
  as far as it went

If the disk is full, the run ends:

  $ ln -s /dev/full full.csv.gz
  $ frobc run $drive --for 60s --record full.csv.gz 2> said > summary
  [2]
  $ grep error said
  error: cannot write full.csv.gz: gzip ended early
