open Cmdliner
open Options

let serve =
  let robot =
    some_string "robot" ~docv:"ROBOT"
      ~doc:"The robot, or the module file of your own robot. The default is $(b,pioneer)."
  in
  let world =
    some_string "world" ~docv:"WORLD.toml"
      ~doc:"The world in which the robot drives. The default is the room that comes with frobc."
  in
  let host =
    Host_option.(
      all
        [
          one Arg.int ~absent:"1" "seed" ~docv:"N" ~doc:"Seed of all noise.";
          one Arg.int "tcp" ~docv:"PORT"
            ~doc:
              "Listen on this port of 127.0.0.1 instead of a pseudo-terminal; 0 chooses a free \
               port.";
          one Arg.int "camera" ~docv:"PORT"
            ~doc:
              "Serve the images of the world's cameras as MJPEG over HTTP, on this port of \
               127.0.0.1; 0 chooses a free port. Prints a line $(b,camera:) with the address of \
               each camera, for $(b,frobc run --camera) or a browser.";
          time_span "for" ~docv:"TIME" ~doc:"How long to run. By default it runs until you stop it.";
          one Arg.string "model" ~docv:"MODEL" ~print:Fun.id
            ~doc:"The model of the robot, such as $(b,p3dx) for a Pioneer.";
        ])
  in
  let log =
    some_string "log" ~docv:"FILE"
      ~doc:"Log each received command to this file, with its time on the monotonic clock."
  in
  let link =
    some_string "link" ~docv:"PATH" ~doc:"Maintain a symbolic link to the device at this path."
  in
  let sources =
    let doc = "A C file that defines the body or the board of your own robot. Can be repeated." in
    Arg.(value & opt_all string [] & info [ "with" ] ~docv:"FILE.c" ~doc)
  in
  let stamped =
    let doc =
      "With the robot $(b,ros): accept commands of the type TwistStamped instead of Twist."
    in
    Arg.(value & flag & info [ "stamped" ] ~doc)
  in
  let ros_arguments =
    let doc =
      "With the robot $(b,ros): arguments for ROS 2, up to $(b,--) or the end, as in \
       $(b,--ros-args -r odom:=base/odom)."
    in
    Arg.(value & opt_all string [] & info [ "ros-args" ] ~docv:"ARG" ~doc)
  in
  let make robot sources world log link stamped ros_arguments host =
    Tools.Real_robot.serve ~robot ~sources { world; log; link; stamped; ros_arguments; host }
  in
  let man =
    [
      `S Manpage.s_description;
      `P
        "Simulates a robot that speaks its serial protocol, byte by byte and in real time. The \
         first line on standard output is $(b,device:) and the address to connect to: the path of \
         a pseudo-terminal, or $(b,tcp:127.0.0.1:PORT). The last lines are a summary.";
      `P "SIGUSR1 unplugs the cable; SIGUSR2 plugs it in again and prints the new device.";
      `P
        "The robot $(b,ros) has no serial line: it is a ROS 2 node, which publishes $(b,odom), \
         $(b,scan), $(b,imu) and $(b,/clock), and drives with the speeds from $(b,cmd_vel). Source \
         the setup script of ROS 2 first. The first lines on standard output are the names of the \
         node and of its topics.";
    ]
  in
  command "serve" ~man ~doc:"simulate a robot on a serial port or in ROS 2"
    Term.(const make $ robot $ sources $ world $ log $ link $ stamped $ ros_arguments $ host)
