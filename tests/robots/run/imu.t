An inertial measurement unit in the simulator, and the module Imu.

  $ room () { { echo 'robot = "pioneer"' && cat; } > room.toml && cat >> room.toml <<TOML
  > [start]
  > x = 1.0
  > y = 1.0
  > [[wall]]
  > points = [[0, 0], [6, 0], [6, 4], [0, 4]]
  > closed = true
  > TOML
  > }
  $ cat > turn.frob <<FROB
  > import Geometry
  > import Imu
  > import Robot
  > main :: (HasImu i, DiffDrive o) => Program i o
  > main = reactimateRobot (proc i -> roMake (setVelTR v omega) where
  >     heading = imuHeading 5[s] i
  >     north = fromMaybe 0 (compassHeading i)
  >     v = 0.3[m/s] + 0 * forwardAcceleration i / 1[1/s]
  >     omega = 0.6[1/s] + 0 * (angleDiff heading north) / 1[s] + 0 * gyroRate i)
  > FROB

Without errors, the sum of the turn rates is the turn, and the sum of the accelerations ahead is the
speed:

  $ room <<TOML
  > [imu]
  > TOML
  $ frobc run turn.frob --world room.toml --for 10s --record run.csv > /dev/null
  $ python3 devices.py imu run.csv
  turned 5.899, odometry 5.899; speed 0.30; up 9.807; rates around x: mean 0.0000, deviation 0.0000
  compass: mean error 0.000, deviation 0.000
  $ head -1 run.csv | tr , '\n' | grep imu
  in.console.imu
  $ frobc trace turn.frob --robot pioneer --input run.csv --output again.csv
  $ frobc trace turn.frob --robot pioneer --input run.csv --engine interp --output interpreted.csv
  $ cmp again.csv interpreted.csv
  $ frobc run turn.frob --world room.toml --for 10s --real float --record float.csv > /dev/null
  $ frobc trace turn.frob --real float --robot pioneer --input float.csv --output float_c.csv
  $ frobc trace turn.frob --real float --robot pioneer --input float.csv --engine interp --output float_i.csv
  $ cmp float_c.csv float_i.csv

Noise, a constant bias, a bias that walks, an error of scale, and a compass with errors. A reading
is the mean of the two measurements of an instant:

  $ with () { printf '[imu]\n%s\n' "$@" | tr ';' '\n' | room; frobc run turn.frob --world room.toml --for 60s --seed ${seed:-1} --record run.csv > /dev/null; python3 devices.py imu run.csv; }
  $ with 'gyro_noise_deg = 2'
  turned 35.937, odometry 35.898; speed 0.32; up 9.807; rates around x: mean -0.0004, deviation 0.0243
  compass: mean error 0.000, deviation 0.000
  $ with 'gyro_bias_deg = 1'
  turned 37.127, odometry 35.898; speed 0.32; up 9.807; rates around x: mean 0.0043, deviation 0.0000
  compass: mean error 0.000, deviation 0.000
  $ seed=2 with 'gyro_bias_deg = 1'
  turned 37.463, odometry 35.898; speed 0.32; up 9.807; rates around x: mean 0.0231, deviation 0.0000
  compass: mean error 0.000, deviation 0.000
  $ with 'gyro_drift_deg = 0.5'
  turned 33.548, odometry 35.898; speed 0.32; up 9.807; rates around x: mean 0.0109, deviation 0.0293
  compass: mean error 0.000, deviation 0.000
  $ with 'gyro_scale_error = 0.01'
  turned 36.258, odometry 35.898; speed 0.32; up 9.807; rates around x: mean 0.0000, deviation 0.0000
  compass: mean error 0.000, deviation 0.000
  $ with 'acceleration_bias = 0.1; acceleration_noise = 0.2'
  turned 35.899, odometry 35.898; speed 6.14; up 9.835; rates around x: mean 0.0000, deviation 0.0000
  compass: mean error 0.000, deviation 0.000
  $ with 'compass_noise_deg = 3; compass_error_deg = 10'
  turned 35.899, odometry 35.898; speed 0.32; up 9.807; rates around x: mean 0.0000, deviation 0.0000
  compass: mean error 0.176, deviation 0.052
  $ with 'compass = false'
  turned 35.899, odometry 35.898; speed 0.32; up 9.807; rates around x: mean 0.0000, deviation 0.0000
  no compass

A magnet deflects the compass near it:

  $ printf '[imu]\n[[magnet]]\nposition = [3, 2]\nstrength = 0.5\n' | room
  $ frobc run turn.frob --world room.toml --for 60s --record run.csv > /dev/null
  $ python3 devices.py imu run.csv
  turned 35.899, odometry 35.898; speed 0.32; up 9.807; rates around x: mean 0.0000, deviation 0.0000
  compass: mean error 0.015, deviation 0.013

The gyroscope has a bias, and the compass has noise. `imuHeading` starts at a heading with noise. After
10 s, its error stays below 3 degrees:

  $ cat > fused.frob <<FROB
  > import Geometry
  > import Imu
  > import Robot
  > import Trial
  > main :: Program RobotInput RobotOutput
  > main = reactimateRobot (proc i -> roMake (setVelTR 0.3[m/s] 0.6[1/s]) where
  >     assert "is right" (time () < 10[s] || abs (angleDiff (imuHeading 5[s] i) (robotPose i).heading) < 3[deg]))
  > trial "the heading stays right" = Trial {
  >     world = "room.toml", lasts = 60[s], seeds = 1 \`to\` 10, judge = proc _ -> Holds }
  > FROB
  $ printf '[imu]\ngyro_bias_deg = 0.3\ngyro_noise_deg = 0.5\ncompass_noise_deg = 3\n' | room
  $ frobc test fused.frob
  ok    the heading stays right: 10 seeds, 60 s
  1 test: all hold

Messages:

  $ room < /dev/null
  $ frobc run turn.frob --world room.toml --for 1s
  error: the program uses an inertial measurement unit, `imu`, but the robot in this world has none: add a table [imu] to the world file
  [2]
  $ printf '[[imu]]\nname = "a"\n[[imu]]\nname = "b"\n' | room
  $ frobc run turn.frob --world room.toml --for 1s
  error: the program uses an inertial measurement unit, `imu`, but the robot in this world has none with this name; it has `a`, `b`: add `name = "imu"` to one of them in the world file, or write [[imu]] for each and add another one
  [2]
  $ printf '[[imu]]\n[[imu]]\nrate = 300\ngyro_noise_deg = -1\n[[magnet]]\nstrength = 1\n' | room
  $ frobc run turn.frob --world room.toml --for 1s
  error: room.toml:1:1: two inertial measurement units are named `imu`: give each one its own `name`
  error: room.toml:4:8: `rate` must be at most 200, the rate of the physics steps
  error: room.toml:5:18: `gyro_noise_deg` must be zero or more
  error: room.toml:6:1: this needs a key `position`
  [2]
  $ frobc build turn.frob --robot scout -o turn
  error: turn uses the inertial measurement unit `imu`, but only the simulator has one; for your own robot, let the driver fill a field of the input, and define an instance that reads this field
  [2]
