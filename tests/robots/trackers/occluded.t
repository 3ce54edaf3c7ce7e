The camera is covered for two seconds, and later for one, while the robot drives and turns. An
object of three patches, a patch and a ball are lost, and found again as soon as they are visible.

  $ cat > again.awk << 'AWK'
  > BEGIN { FS = ","; split("composite patch ball", names, " ") }
  > NR == 1 { next }
  > was == "true" && $2 == "false" {
  >     end = $1
  >     for (i = 1; i <= 3; i++) { waits[i] = before[i] == "Lost"; if (!waits[i]) print names[i], "was not lost" }
  > }
  > { was = $2; for (i = 1; i <= 3; i++) before[i] = $(i + 2) }
  > $2 == "false" {
  >     for (i = 1; i <= 3; i++) if (waits[i] && $(i + 2) == "Seen") {
  >         waits[i] = 0; n[i]++; if ($1 - end > most[i]) most[i] = $1 - end
  >     }
  > }
  > END { for (i = 1; i <= 3; i++) print names[i], n[i], "times,", (most[i] <= 0.5 ? "within 0.5 s" : "after " most[i] " s") }
  > AWK
  $ for seed in 1 2 3; do
  >   frobc run known.frob --world world.toml --for 8s --seed $seed --record run.csv > summary
  >   frobc trace occluded.frob --with covered.c --input run.csv | awk -f again.awk
  > done
  composite 2 times, within 0.5 s
  patch 2 times, within 0.5 s
  ball 2 times, within 0.5 s
  composite 2 times, within 0.5 s
  patch 2 times, within 0.5 s
  ball 2 times, within 0.5 s
  composite 2 times, within 0.5 s
  patch 2 times, within 0.5 s
  ball 2 times, within 0.5 s
