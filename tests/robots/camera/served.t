A served robot offers the cameras of its world as MJPEG over HTTP, so a program with a camera can
drive it completely: here it follows the ball, a metre behind it.

  $ . ./camera.sh
  $ follow () {
  >   start_robot ../../../examples/follow_ball/world.toml
  >   camera=$(sed -n 's/camera: //p' served)
  >   frobc run ../../../examples/follow_ball/follow_ball.frob --device $device --camera $camera --for 40s --record run.csv > summary
  >   end $robot
  > }
  $ wants="at_least 'camera frames' 200 | grep -q enough"
  $ in_time follow
  $ sed -n 's|^camera: \(.*\):[0-9][0-9]*/|\1:PORT/|p' served
  http://127.0.0.1:PORT/camera
  $ sed -n 's/^camera: \(.*\);.*/\1/p; s/^camera failures/camera failures/p' summary; at_least 'camera frames' 200
  320 x 240, colours, JPEG
  camera failures: 0
  camera frames: enough
  $ awk -F ': ' '/^collisions/ { print "collisions:", $2 } /^distance driven/ { print "drove:", ($2 + 0 > 4) } /^mean ball/ { print "error:", ($2 + 0 < 0.1 ? "small" : $2) }' served
  drove: 1
  error: small
  collisions: 0

It follows the ball from its first sight on: there is no second search.

  $ frobc trace ../../../examples/follow_ball/follow_ball.frob --robot pioneer --input run.csv --modes | sed '1d; s/.*,//' | uniq | sed '1{/search/d}'
  follow

Other paths list the cameras; malformed requests are ignored.

  $ start_robot ../../../examples/follow_ball/world.toml
  $ port=$(sed -n 's/camera: .*:\([0-9]*\)\/.*/\1/p' served)
  $ python3 - $port <<END
  > import socket, sys
  > for request in (b"GET / HTTP/1.1\r\nHost: x\r\n\r\n", b"\x00" * 20000, b"\r\n\r\n"):
  >     s = socket.create_connection(("127.0.0.1", int(sys.argv[1])))
  >     s.sendall(request)
  >     answer = b""
  >     while part := s.recv(4096): answer += part
  >     print(answer.split(b"\r\n")[0].decode(), b"/camera" in answer)
  > END
  HTTP/1.0 404 Not Found True
  HTTP/1.0 404 Not Found True
  HTTP/1.0 404 Not Found True
  $ end $robot

A world without a camera cannot serve one.

  $ frobc serve --world hall.toml --camera 0
  error: the world has no camera: add a table [camera] to its file
  [2]
