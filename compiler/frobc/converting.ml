open Cmdliner
open Options

let convert =
  let from =
    let doc = "The file to convert: a recording, or an MCAP file written by $(tname)." in
    Arg.(required & pos 0 (some string) None & info [] ~docv:"FROM" ~doc)
  in
  let into =
    let doc =
      "The file to write: $(b,.mcap), or a recording, $(b,.csv), $(b,.csv.gz) or $(b,.csv.zst)."
    in
    Arg.(required & pos 1 (some string) None & info [] ~docv:"TO" ~doc)
  in
  let man =
    [
      `S Manpage.s_description;
      `P
        "Foxglove, PlotJuggler and other robot tools display MCAP files. The file contains all \
         values for plots, as JSON in the topics $(b,/in), $(b,/out) and $(b,/probe). For 3D \
         views, it contains $(b,/pose/...), every value with a position and a heading; $(b,/tf), \
         the robot's pose by odometry; $(b,/ranges), the cones of the sonar echoes; and \
         $(b,/image/...), the camera frames.";
      `P
        "It also contains the recording itself with its frames, so that $(tname) can restore the \
         same files, byte for byte. $(tname) cannot convert MCAP files that other programs have \
         written.";
      `P
        "If both files are recordings, $(tname) changes the compression. If an archive is \
         truncated or damaged, it converts the complete rows and prints a warning.";
      `Pre
        "frobc run program.frob --for 60s --record run.csv.gz\n\
         $(tname) run.csv.gz run.mcap\n\
         $(tname) run.mcap again.csv";
    ]
  in
  command "convert" ~man ~doc:"convert recordings to MCAP for Foxglove and PlotJuggler, and back"
    Term.(const Tools.Convert.run $ dialect $ from $ into)
