A separate process looks for tags in the frames of a real camera: a served robot docks in front of
one, as in the simulator. Its final position is reported by its world, not by the program.

  $ . ./camera.sh
  $ example=../../../examples/dock_tag
  $ dock () {
  >   start_robot $example/world.toml
  >   camera=$(sed -n 's/camera: //p' served)
  >   frobc run $example/dock_tag.frob --device $device --camera $camera --set camera.field_of_view_deg=70 --for 60s --exit-when-done --record run.csv > summary
  >   end $robot
  > }
  $ in_time dock
  $ sed -n 's/^camera: \(.*\);.*/\1/p; s/^camera failures/camera failures/p; s/^result/result/p' summary; at_least 'camera frames' 20
  320 x 240, colours, JPEG
  camera failures: 0
  result: ()
  camera frames: enough
  $ awk -F '[ ,]+' '/^position/ { print ($2 - 3.4) ^ 2 + ($4 - 2) ^ 2 < 0.05 ^ 2 && ($7 ^ 2 < 3 ^ 2) ? "docked" : $0 }; /^collisions/' served
  docked
  collisions: 0

The recording contains the tags, and no pictures: it is replayed without the tag finder.

  $ ls -d run.frames 2> /dev/null
  [2]
  $ grep -v '^#' run.csv | sed 's/"[^"]*"//g' | cut -d, -f1,31- > recorded.csv
  $ frobc trace $example/dock_tag.frob --robot pioneer --input run.csv | cmp - recorded.csv
  $ frobc trace $example/dock_tag.frob --robot pioneer --input run.csv --engine interp | cmp - recorded.csv

A program that also examines the frames receives both at the same instant, from the same frame. Here
the host and the kernels are compiled from their sources, as for another machine.

  $ cat > both.frob <<'FROB'
  > import Robot
  > import Tags
  > import Vision
  > 
  > main :: (HasTags i, HasCamera i, DiffDrive o) => Program i o
  > main = reactimateRobot (proc i -> roMake (setVelTR (gap i) 0)) where
  >     gap = proc i -> 0.1[m/s] * toFloat (hold 1 (numbers (camera i) (tags i)))
  >     numbers c t = case (c, t) of
  >         (Event f, Event g) -> Event (f.number - g.number + (if tagged g && seen f then 0 else 2))
  >         (NoEvent, NoEvent) -> NoEvent
  >         _ -> Event 3
  >     seen f = (getStatistics f.image (everywhere f.image)).pixels == 76800
  >     tagged g = maybe False (\t -> t.margin > 50) (g.found ! 0)
  > FROB
  $ cat > still.frob <<'FROB'
  > import Robot
  > import Vision
  > 
  > -- | Is there for its frames.
  > main :: (HasCamera i, DiffDrive o) => Program i o
  > main = reactimateRobot (proc i -> roMake (setVelTR (0[m/s] * toFloat (hold 0 (mapE (\f -> f.number) (camera i)))) 0))
  > FROB
  $ sed 's/heading_deg = -30/heading_deg = 10/' $example/world.toml > ahead.toml
  $ frobc run still.frob --robot pioneer --world ahead.toml --for 2s --record still.csv > summary
  $ frobc build both.frob --robot pioneer --target linux -o both
  $ both () { ./both --device $device --for 3 --camera still.frames --record log.csv > summary 2> messages; }
  $ wants="at_least 'camera frames' 10 | grep -q enough && grep -q ^warning messages"
  $ in_time with_robot both; warnings
  warning: camera `camera` (still.frames) delivers no frames any more: all 29 pictures have been shown
  $ at_least 'camera frames' 10
  camera frames: enough
  $ frobc trace both.frob --robot pioneer --input log.csv | cut -d, -f2 | uniq
  out.forward
  0.10000000000000001
  0

If the process that looks for tags is killed, another one replaces it, and the program continues.

  $ rm log.csv
  $ start_robot
  $ ./both --device $device --for 600 --camera still.frames --set camera.rate=1 --record log.csv > summary 2> messages & run=$!
  $ until_true 'grep -q "number = 1" log.csv 2> /dev/null'
  $ keeper=$(cut -d ' ' -f 1 /proc/$run/task/$run/children)
  $ kill -SEGV $(cut -d ' ' -f 2 /proc/$keeper/task/$keeper/children)
  $ until_true 'grep -q "frames again" messages'
  $ kill -INT $run; wait $run
  [4]
  $ sed 's/(http[^)]*)/(ADDRESS)/; s/at [0-9.]* s/at N s/' messages
  warning: camera `camera` (still.frames) delivers no frames: its tag detector was killed by signal 11 (Segmentation fault); restarting it
  camera `camera` (still.frames) delivers frames again
  interrupted at N s: the summary covers the run until then, and so does log.csv; run the same command again to start over and overwrite that file
  error: the run was ended by an interrupt; sent a stop command to the robot

Without the library, a program that uses tags is rejected before anything moves.

  $ mkdir none; printf 'no library' > none/libapriltag.so.3
  $ LD_LIBRARY_PATH=$PWD/none ./both --device $device --for 3 --camera still.frames
  error: this program detects tags, but the library libapriltag.so.3 is not installed: install it (Debian: `sudo apt-get install libapriltag-dev`); replaying a recording does not need it
  [2]
  $ end $robot
