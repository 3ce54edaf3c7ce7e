open Cmdliner
open Options

let convert =
  let from =
    let doc = "The file to convert: a recording or an MCAP file." in
    Arg.(required & pos 0 (some string) None & info [] ~docv:"FROM" ~doc)
  in
  let into =
    let doc =
      "The file to write: an MCAP file ($(b,.mcap)) or a recording ($(b,.csv), $(b,.csv.gz) or \
       $(b,.csv.zst))."
    in
    Arg.(required & pos 1 (some string) None & info [] ~docv:"TO" ~doc)
  in
  let man =
    [
      `S Manpage.s_description;
      `P
        "Foxglove, PlotJuggler and other robot tools display MCAP files. For plots, the file \
         contains all values as JSON in the topics $(b,/in), $(b,/out) and $(b,/probe). For 3D \
         views, it contains $(b,/pose/...), every value with a position and a heading; $(b,/tf), \
         the robot's pose from odometry; $(b,/ranges), the cones of the sonar echoes; and \
         $(b,/image/...), the camera frames.";
      `P
        "It also contains the recording itself with its camera frames, so that $(tname) can \
         restore the same files, byte for byte. To convert MCAP files that other programs have \
         written, install the Python packages with $(b,frobc extras install mcap).";
      `P
        "If both files are recordings, $(tname) changes the compression. If a recording is \
         truncated or damaged, $(tname) converts the complete rows before the damage and prints a \
         warning.";
      `Pre
        "frobc run program.frob --for 60s --record run.csv.gz\n\
         $(tname) run.csv.gz run.mcap\n\
         $(tname) run.mcap again.csv";
    ]
  in
  command "convert" ~man ~doc:"convert recordings to MCAP for Foxglove and PlotJuggler, and back"
    Term.(const Tools.Convert.run $ dialect $ from $ into)
