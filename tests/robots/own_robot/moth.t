A user-defined robot with photocells and sensors that look down. Its code is valid C and C++, and it
drives to a lamp that a wall hides at first.

  $ seek=../../../examples/light_seek
  $ moth="--robot $seek/Moth.frob"
  $ frobc check --lint $seek/light_seek.frob $moth
  $ frobc compile $seek/light_seek.frob $moth -o generated
  $ for c in "gcc -std=c99" "clang -std=c99" "clang++ -x c++ -std=c++20"; do
  >   for source in generated/light_seek.c $seek/moth_body.c; do
  >     $c -Wall -Wextra -Wno-missing-field-initializers -Wpedantic -Wconversion -Wshadow -Werror -ffp-contract=off -Igenerated -I../../../runtime/include -fsyntax-only $source
  >   done
  > done
  $ sh ../run/seeds.sh $seek $seek/Moth.frob 5 collisions 0 0 distance_driven 5 8 finished_after 30 50 -- --with $seek/moth_body.c --for 2min --exit-when-done
  ../../../examples/light_seek/Moth.frob: 0 of 5 seeds out of bounds

It ends at the lamp, and the run replays on both engines.

  $ frobc run $seek/light_seek.frob $moth --with $seek/moth_body.c --exit-when-done --for 2min --record run.csv --picture run.svg > summary
  $ frobc trace $seek/light_seek.frob $moth --input run.csv > replayed.csv
  $ frobc trace $seek/light_seek.frob $moth --input run.csv --engine interp | cmp - replayed.csv
  $ head -1 run.csv | tr ',' '\n' | sed -n '10,13p'
  in.light[0]
  in.light[1]
  in.floor[0]
  in.floor[1]
  $ awk -F, 'NR == 2 { print ($10 + $11 < 8 ? "dark" : "light") } END { print ($10 + $11 > 300 ? "bright" : "not bright") }' run.csv
  dark
  bright

Without the lamp it searches forever.

  $ grep -v -e lamp -e position $seek/world.toml > dark.toml
  $ frobc run $seek/light_seek.frob $moth --with $seek/moth_body.c --world dark.toml --exit-when-done --for 60s | grep -c finished
  0
  [1]

The line follower of another robot runs on it, on tape as wide as the distance between its sensors.

  $ cat > narrow.toml <<'TOML'
  > [start]
  > x = 0.6
  > y = 0.8
  > heading_deg = -60
  > [[tape]]
  > points = [[0.5, 0.5], [2, 0.5], [2, 1.6], [1.4, 1.6], [1.2, 1.1], [0.5, 1.1]]
  > closed = true
  > width = 0.019
  > radius = 0.2
  > reflectance = 0.1
  > [floor]
  > noise = 0.03
  > [measure]
  > what = "tape"
  > settle = 6
  > TOML
  $ . ../run/within.sh
  $ frobc run ../../../examples/line_follow/line_follow.frob $moth --with $seek/moth_body.c --world narrow.toml --for 60s > summary
  $ within largest_distance_from_the_tape 0 0.008 distance_along_the_tape 10 12 < summary

No robot of the library senses light.

  $ frobc check $seek/light_seek.frob --robot create
  error[E0503]: `create` has no `HasPhotocells`
    --> ../../../examples/light_seek/light_seek.frob:32:16
     |
  32 | brightness i = lightLeft i + lightRight i
     |                ^^^^^^^^^ `lightLeft` needs it
     |
     = note: no robot in the library has this capability
     = note: `main` is compiled for `create`, but there is no instance `HasPhotocells CreateInput`
  
  1 error
  [1]
