The stick that the sonars limit, on a table: both engines agree. A sonar that is dead
gives no number, and then the speed is none, at which a robot rests.

  $ example=../../../examples/safe_stick
  $ frobc trace $example/safe_stick.frob --entry safely --input $example/drive.csv | tee driven.csv
  time,out.1,out.2
  0.000000000,0.59999999999999998,0
  0.500000000,0.59999999999999998,0
  1.000000000,0.59999999999999998,0
  2.000000000,0.59999999999999998,0
  3.000000000,0.34641016151377546,0
  4.000000000,0.077459666924148352,0.90000000000000002
  5.000000000,0,1.5707963267948966
  6.000000000,-0.10000000000000001,0
  7.000000000,-0.10000000000000001,0
  8.000000000,0.10000000000000001,0
  9.000000000,nan,0
  $ frobc trace $example/safe_stick.frob --entry safely --input $example/drive.csv --engine interp | cmp - driven.csv

With the key w held down, whatever the robot, it drives up to a wall and stops before it.

  $ printf 'name = "ahead"\n[start]\nx = 0\ny = 0\n[[wall]]\npoints = [[3, -3], [3, 3]]\n' > ahead.toml
  $ for robot in pioneer scout create; do
  >   printf w | frobc run $example/safe_stick.frob --robot $robot --world ahead.toml --for 30s --console --record log.csv | grep collisions
  >   awk -F, 'END { print ($2 > 1.2) }' log.csv
  > done
  collisions: 0
  1
  collisions: 0
  1
  collisions: 0
  1

The recording tells how far it came.

  $ sed -n '/^```frob/,/^```$/p' $example/README.md | grep -v '```' > logger.frob
  $ frobc trace logger.frob --entry logger --robot create --input log.csv | awk -F, 'END { print ($2 > 1.2 && $2 < 3) }'
  1
