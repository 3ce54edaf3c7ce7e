If a device cannot be opened, the message says how to fix that.

  $ . ./robot.sh
  $ frobc run drive.frob --device ./nothing
  error: there is no device ./nothing; plug it in (/dev/serial/by-id lists the devices that are plugged in)
  [2]
  $ touch file; frobc run drive.frob --device ./file
  error: ./file is not a serial line
  [2]
  $ frobc run drive.frob --device tcp:127.0.0.1:1
  error: cannot connect to 127.0.0.1, port 1: Connection refused
  [2]
  $ frobc run drive.frob --device tcp:127.0.0.1:
  error: `tcp:127.0.0.1:` is not an address; write tcp:HOST:PORT
  [2]

For a device that is in use, the message names the program that uses it.

  $ start_robot
  $ start_driving
  $ ./drive --device ./line --for 1 2>&1 | sed 's/[0-9][0-9]*/N/; s/use by [^ ]*/use by PROGRAM/'
  error: ./line is in use by PROGRAM (process N); end that program first
  $ kill -INT $run; wait $run
  [4]
  $ end_robot

Settings are numbers within bounds; the watchdog cannot be disabled.

  $ frobc run drive.frob --for 1s --device ./line --set max-speed=9
  error: max-speed takes a number from 0.01 to 2.2, not `9`
  [2]
  $ frobc run drive.frob --for 1s --device ./line --set max-sped=1
  error: `max-sped=1` is not a setting of a pioneer; write NAME=VALUE with one of: baud, switch-baud, angle, distance, speed, range, difference, vel2-divisor, max-speed, max-turn, wheels, no-echo, motors-flag, hard-stop, silence, interval, carry-on
  [2]
  $ frobc build drive.frob -o drive
  $ ./drive --device ./line --patience 0
  error: you cannot turn off the watchdog of a robot: --patience takes a number from 0.01 to 2 seconds
  [2]
  $ ./drive
  error: --device is missing: add the serial line of the pioneer; see --help
  [2]

Options of the simulator have no meaning on a robot.

  $ frobc run drive.frob --device ./line --world hall.toml
  error: --world only works in the simulator: remove it, or remove --device
  [2]
  $ frobc run drive.frob --device ./line --picture drive.png
  error: --picture only works in the simulator: remove it, or remove --device
  [2]
  $ frobc run drive.frob --device ./line --seed 1
  error: --seed only works in the simulator: remove it, or remove --device
  [2]
  $ frobc run drive.frob --device ./line --strict
  error: --strict only works in the simulator: remove it, or remove --device
  [2]

A robot always runs in real time.

  $ start_robot
  $ frobc run drive.frob --device ./line --for 0.1s --realtime | grep connections
  connections: 1
  $ end_robot

A program that is not for a robot is rejected before a driver starts.

  $ echo 'main = arr (\x -> x + 1.0)' > plain.frob
  $ frobc run plain.frob --for 1s --device ./line
  error: plain is not a robot program; use `reactimateRobot` to make one
  [2]
