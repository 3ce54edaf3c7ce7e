The wall follower's gains depend neither on the noise of one run nor on the
program's rate: no collision, and errors within the same bounds.

  $ . ./within.sh
  $ for rate in 20 30 50 100; do
  >   for seed in 2 7 9 20 34; do
  >     frobc run ../../../examples/wall_follow/wall_follow.frob --rate $rate --seed $seed |
  >       within distance_driven 17 20 mean_wall_distance_error 0 0.03 largest_wall_distance_error 0 0.25 collisions 0 0 ||
  >       echo "with rate $rate and seed $seed"
  >   done
  > done
