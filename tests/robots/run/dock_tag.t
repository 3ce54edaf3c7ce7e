Docking in front of a tag: on each robot, and not in front of the other tag; a recording replays bit
for bit, on both engines, without the tag finder.

  $ program=../../../examples/dock_tag/dock_tag.frob
  $ for robot in scout create; do frobc test $program --robot $robot --seeds 2 | grep degrees; done
  ok    docks within 2 cm and 2 degrees: 2 seeds, 20 s
  ok    docks within 2 cm and 2 degrees: 2 seeds, 20 s
  $ frobc run $program --for 20s --exit-when-done --record run.csv | grep -E 'collisions|result'
  collisions: 0
  result: ()
  $ grep -v '^#' run.csv | sed 's/"[^"]*"//g' | cut -d, -f1,31,32 > recorded.csv
  $ frobc trace $program --robot pioneer --input run.csv | cut -d, -f1-3 > replayed.csv
  $ cmp recorded.csv replayed.csv
  $ frobc trace $program --robot pioneer --input run.csv --engine interp | cut -d, -f1-3 | cmp - replayed.csv

Without its tag the robot turns, and searches for it.

  $ sed 's/^id = 5/id = 4/' ../../../examples/dock_tag/world.toml > lost.toml
  $ frobc run $program --world lost.toml --for 5s --exit-when-done | grep -E 'driven|finished'
  distance driven: 0.000 m
