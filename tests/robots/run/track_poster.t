The program learns the poster in the first frame, and drives up to it until it is 1.6 times as
large; from 3.8 m that is a distance of 1.4 m. The ball hides the poster twice in 16 s. Each time it
is lost, and found again.

  $ frobc run ../../../examples/track_poster/track_poster.frob --robot pioneer --for 16s --seed 1 --record run.csv | sed -n 's/\(distance driven: 1.4\).*/\1/p; /collisions/p'
  distance driven: 1.4
  collisions: 0
  $ frobc trace ../../../examples/track_poster/track_poster.frob --robot pioneer --input run.csv --probe drive > probed.csv
  $ cat > sights.awk << 'AWK'
  > BEGIN { FS = "," }
  > NR == 1 { for (i = 1; i <= NF; i++) { if ($i ~ /t.sight$/) s = i; if ($i ~ /t.estimate.x$/) x = i } next }
  > $s != last { print $s; last = $s }
  > $s == "Seen" && $1 > 2 && ($x - 159.5) ^ 2 > 25 { print "off the middle at", $1 }
  > AWK
  $ awk -f sights.awk probed.csv
  Lost
  Seen
  Predicted
  Lost
  Seen
  Predicted
  Lost
  Seen

While the poster is not visible, the robot stands still.

  $ awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i ~ /t.sight$/) s = i; next } $s != "Seen" && ($2 != 0 || $3 != 0)' probed.csv | wc -l
  0
