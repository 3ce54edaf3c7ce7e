The resolutions that `frobc report` states are those of the drivers and of the simulator.

  $ cat > still.frob <<EOF
  > import Robot
  > 
  > main :: (HasOdometry i, DiffDrive o) => Program i o
  > main = reactimateRobot (constant (roMake (setVelTR 0 0)))
  > EOF
  $ cat > steps.c <<EOF
  > #include <stdio.h>
  > #include "drivers/create/command.h"
  > #include "drivers/pioneer/speeds.h"
  > #include "drivers/scout/command.h"
  > 
  > static void wheels(struct frob_wire w)
  > {
  >     printf("%.3g mm/s\n%.3g deg/s\n", w.step[0] * 1e3, w.step[0] / w.separation_m / FROB_PIONEER_DEGREE);
  > }
  > 
  > int main(void)
  > {
  >     struct frob_wire w = frob_pioneer_wire(1, 1);
  >     printf("%.3g mm/s\n%.3g deg/s\n", w.step[0] * 1e3, w.step[1] / FROB_PIONEER_DEGREE);
  >     wheels(frob_scout_wire(0.3452));
  >     wheels(frob_create_wire(0.235));
  >     return 0;
  > }
  > EOF
  $ gcc -std=c99 -I../../../runtime -I../../../runtime/include steps.c -lm -o steps && ./steps > drivers
  $ for robot in pioneer scout create; do
  >   frobc report still.frob --robot $robot | sed -n '/on the wire/,$p'
  > done | tee told
  resolution of speed on the wire of a pioneer, averaged over commands
    ahead     1 mm/s
    turning  1 deg/s
  resolution of speed on the wire of a scout, averaged over commands
    each wheel             2.54 mm/s
    resulting turn rate  0.422 deg/s
  resolution of speed on the wire of a create, averaged over commands
    each wheel                1 mm/s
    resulting turn rate  0.244 deg/s
  $ sed -n 's/^  [a-z ]*  *\([0-9.]* [a-z]*\/s\)$/\1/p' told | diff - drivers
  $ frobc report still.frob --robot scout --format=json | grep -o '"wire":.*]}'
  "wire":{"robot":"scout","steps":[{"quantity":"each wheel","size":2.54,"unit":"mm/s"},{"quantity":"resulting turn rate","size":0.42158539966172975,"unit":"deg/s"}]}
