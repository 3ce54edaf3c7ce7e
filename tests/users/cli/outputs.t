Nothing is overwritten without a word: neither what a command reads, nor the same file
twice, nor a file that frobc has not made.

  $ cat > double.frob <<'EOF'
  > main :: SF Float Float
  > main = proc x -> 2 * x
  > EOF
  $ cat > drive.frob <<'EOF'
  > import Robot
  > main = proc _ -> roMake (setVelTR 0.1[m/s] 0)
  > EOF
  $ printf 'time,in\n0,1\n' > in.csv
  $ cp drive.frob wall
  $ frobc build wall
  error: the program would overwrite wall, which is read: name another file
  [2]
  $ frobc build drive.frob -o ./drive.frob
  error: -o would overwrite drive.frob, which is read: name another file
  [2]
  $ frobc run drive.frob --record drive.frob
  error: --record would overwrite drive.frob, which is read: name another file
  [2]
  $ printf '[start]\nx = 0\ny = 0\n' > world.toml
  $ ln -s world.toml link.toml
  $ frobc run drive.frob --record link.toml
  error: --record would overwrite ./world.toml, which is read: name another file
  [2]
  $ frobc run drive.frob --device tty --record drive.frob
  error: --record would overwrite drive.frob, which is read: name another file
  [2]
  $ frobc run drive.frob --record run.svg --picture ./run.svg
  error: --record and --picture both write ./run.svg: name two files
  [2]
  $ frobc trace double.frob --input in.csv --output in.csv
  error: --output would overwrite in.csv, which is read: name another file
  [2]

What a person has written stays.

  $ echo 'int speed;' > double.c
  $ frobc compile double.frob
  error: compile would overwrite ./double.c, which is there already and not C that frobc has generated: move it away, or name another file
  [2]
  $ ls double.h
  ls: cannot access 'double.h': No such file or directory
  [2]
  $ echo notes > notes.csv
  $ frobc run drive.frob --record notes.csv
  error: --record would overwrite notes.csv, which is there already and not a trace or a recording: move it away, or name another file
  [2]
  $ echo '<svg>mine</svg>' > mine.svg
  $ frobc run drive.frob --picture mine.svg
  error: --picture would overwrite mine.svg, which is there already and not a picture that frobc has drawn: move it away, or name another file
  [2]
  $ echo '#!/bin/sh' > drive
  $ frobc build drive.frob
  error: the program would overwrite drive, which is there already and not a program that frobc has built: move it away, or name another file
  [2]
  $ echo mine > robot
  $ frobc serve --link robot
  error: --link would overwrite robot, which is no link: move it away, or name another file
  [2]
  $ cat robot
  mine

What frobc has made is replaced, and so is what is empty.

  $ rm double.c drive
  $ touch run.csv
  $ for again in 1 2; do
  >   frobc compile double.frob && frobc build drive.frob &&
  >     frobc run drive.frob --for 1s --record run.csv --picture run.svg > summary &&
  >     frobc run drive.frob --for 1s --picture run.png > summary &&
  >     frobc trace double.frob --input in.csv --output out.csv || echo failed
  > done
  $ ls -A -I '*.t'
  double.c
  double.frob
  double.h
  drive
  drive.frob
  in.csv
  link.toml
  mine.svg
  notes.csv
  out.csv
  robot
  run.csv
  run.png
  run.svg
  summary
  wall
  world.toml

The C and its header are written beside and renamed together: where there is no room
for one, both stay as they were.

  $ cp double.c before.c && cp double.h before.h
  $ (ulimit -f 0; frobc compile double.frob --batch 2>&1) | cat
  error: cannot write ./double.h: File too large
  $ cmp double.c before.c && cmp double.h before.h
  $ ls -A | grep '^\.frobc'
  [1]
