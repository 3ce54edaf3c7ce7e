The robot drives down the middle of a corridor with two cameras: a recording replays bit for bit, on
both engines.

  $ program=../../../examples/corridor_stereo/corridor_stereo.frob
  $ frobc run $program --for 2s --record run.csv > summary
  $ grep -v '^#' run.csv | sed 's/"[^"]*"//g' | cut -d, -f1,32,33 > recorded.csv
  $ frobc trace $program --robot pioneer --input run.csv | cut -d, -f1-3 > replayed.csv
  $ cmp recorded.csv replayed.csv
  $ frobc trace $program --robot pioneer --input run.csv --engine interp | cut -d, -f1-3 | cmp - replayed.csv

In the dark it stays where it is, and reports that it has ended.

  $ sed 's/^\[stereo\]/&\nexposure = 0.001/' ../../../examples/corridor_stereo/world.toml > dark.toml
  $ frobc run $program --world dark.toml --for 2s --exit-when-done | grep -E 'driven|finished'
  distance driven: 0.000 m
  finished after: 0.520 s
