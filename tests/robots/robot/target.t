`frobc build --target` compiles the host from its sources, here for this machine.

  $ . ./robot.sh
  $ frobc build drive.frob --target linux -o drive
  $ start_robot
  $ ./drive --device ./line --for 0.5 | sed -n '1p; /connections/p'
  robot: Pioneer p3dx-sh, FrobSim
  connections: 1
  $ end_robot

All sources are installed.

  $ share=$(dirname "$(command -v frobc)")/../share/frobc
  $ (cd ../../../runtime; find core hal/*.h hal/posix hal/cortex_m drivers vision hosts/camera hosts/robot hosts/ros hosts/ros_robot hosts/cortex_m hosts/board hosts/arduino hosts/common/child.* hosts/common/claims.* hosts/common/console.* hosts/common/frames.* hosts/common/packed.* hosts/common/params.* hosts/common/publisher.* hosts/common/record.* hosts/common/ring.* hosts/common/streams.* hosts/common/apriltag.* hosts/common/tag_finder.* hosts/common/tags.* hosts/common/touches.* -name '*.[chl]*' | sort) > here
  $ (cd "$share/runtime"; find . -name '*.[chl]*' | sed 's|^\./||' | sort) | diff here -

For an unknown target, the message lists the others; for a missing compiler, it
says how to install one.

  $ frobc build drive.frob --target arduino
  error: there is no target `arduino`; the targets are host, linux, aarch64-linux, armhf-linux, cortex-m; for Arduino, use `frobc export --platformio`
  [2]
  $ mkdir tools; ln -s "$(command -v frobc)" tools/frobc
  $ export FROB_HOME=$(dirname "$(command -v frobc)")/..
  $ PATH=$PWD/tools frobc build drive.frob --target aarch64-linux
  error: there is no C compiler `aarch64-linux-gnu-gcc`; install it (on Debian: apt-get install gcc-aarch64-linux-gnu libc6-dev-arm64-cross)
  [2]
