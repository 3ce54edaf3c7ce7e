`frobc serve` first prints what to connect to: a pseudo-terminal,

  $ frobc serve --robot pioneer --for 200ms | sed 's|/dev/pts/[0-9]*|PTY|; s|^\(time simulated:\) [0-9.]* s|\1 N s|'
  device: PTY
  time simulated: N s
  distance driven: 0.000 m
  position: 1.000 m, 1.000 m, heading 0.0 degrees
  odometry error at the end: 0.000 m
  collisions: 0

or a TCP port of this machine, for tools that connect by TCP.

  $ frobc serve --robot pioneer --tcp 0 --for 100ms | sed -n '1s/:[0-9]*$/:PORT/p'
  device: tcp:127.0.0.1:PORT

It also simulates a Scout and a Create.

  $ for robot in scout create; do frobc serve --robot $robot --for 100ms | sed -n '1s|/dev/pts/[0-9]*|PTY|p'; done
  device: PTY
  device: PTY

Errors in the command line are reported.

  $ frobc serve --robot pionier
  error: there is no robot `pionier`; the robots are pioneer, scout, create, ros; for your own robot, give the file of its module
  [2]
  $ frobc serve --model p9
  error: there is no model `p9`; use p3dx-sh, p3dx or p2dx
  [2]
  $ frobc serve --world nowhere.toml
  error: there is no world `nowhere.toml` here or among the worlds that come with frobc: room.toml
  [2]

With --link, a symbolic link leads to the device while it exists, and is removed
at the end.

  $ serve_a_link () {
  >   frobc serve --link robot > out & server=$!
  >   for i in $(seq 600); do [ -e robot ] && break; sleep 0.05; done
  > }
  $ serve_a_link; readlink robot | sed 's|[0-9]*$|N|'
  /dev/pts/N
  $ kill $server; wait $server; [ -e robot ] || echo gone
  gone

A different link that somebody has created in its place is kept.

  $ serve_a_link; ln -sf /dev/null robot
  $ kill $server; wait $server; readlink robot
  /dev/null
