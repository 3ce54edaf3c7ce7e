The stick, limited by the sonars, on a table of inputs: both engines agree. A
dead sonar reads NaN, and then the speed is NaN, which stops a robot.

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

With the key w held down, each robot drives up to a wall and stops in front of it.

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

The recording shows how far it came.

  $ sed -n '/^```frob/,/^```$/p' $example/README.md | grep -v '```' > logger.frob
  $ frobc trace logger.frob --entry logger --robot create --input log.csv | awk -F, 'END { print ($2 > 1.2 && $2 < 3) }'
  1
