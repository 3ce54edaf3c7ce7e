`frobc serve` tells first what to connect to: a pseudo-terminal,

  $ frobc serve --robot pioneer --for 200ms | sed 's|/dev/pts/[0-9]*|PTY|; s|: 0\.[0-9]* s|: 0.2 s|'
  device: PTY
  time simulated: 0.2 s
  distance driven: 0.000 m
  stands at: 1.000 m, 1.000 m, heading 0.0 degrees
  odometry error at the end: 0.000 m
  collisions: 0

or a port of this machine, for tools that connect by TCP.

  $ frobc serve --robot pioneer --tcp 0 --for 100ms | sed -n '1s/:[0-9]*$/:PORT/p'
  device: tcp:127.0.0.1:PORT

A Scout and a Create are there, too.

  $ for robot in scout create; do frobc serve --robot $robot --for 100ms | sed -n '1s|/dev/pts/[0-9]*|PTY|p'; done
  device: PTY
  device: PTY

What is wrong with the call is told.

  $ frobc serve --robot pionier
  error: there is no robot `pionier`; the robots: pioneer, scout, create; your own: the file of its module
  [2]
  $ frobc serve --model p9
  error: there is no model `p9`; there are: p3dx-sh, p3dx, p2dx
  [2]
  $ frobc serve --world nowhere.toml
  error: nowhere.toml: cannot read this world file
  [2]

A link is kept to the device while it is there, and taken away at the end.

  $ frobc serve --link robot --for 1s > out &
  $ for i in 1 2 3 4 5 6 7 8 9 10; do [ -e robot ] && break; sleep 0.05; done; readlink robot | sed 's|[0-9]*$|N|'
  /dev/pts/N
  $ wait; [ -e robot ] || echo gone
  gone

But not another that somebody has put in its place.

  $ frobc serve --link robot --for 1s > out &
  $ for i in 1 2 3 4 5 6 7 8 9 10; do [ -e robot ] && break; sleep 0.05; done; ln -sf /dev/null robot
  $ wait; readlink robot
  /dev/null
