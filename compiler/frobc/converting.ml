open Cmdliner
open Options

let convert =
  let from =
    let doc = "What is there: a recording, or MCAP that $(tname) has made of one." in
    Arg.(required & pos 0 (some string) None & info [] ~docv:"FROM" ~doc)
  in
  let into =
    let doc =
      "What is to be: $(b,.mcap), or a recording, $(b,.csv), $(b,.csv.gz) or $(b,.csv.zst)."
    in
    Arg.(required & pos 1 (some string) None & info [] ~docv:"TO" ~doc)
  in
  let man =
    [
      `S Manpage.s_description;
      `P
        "MCAP is what Foxglove, PlotJuggler and other tools for robots show. All values are in it, \
         for plots: topics $(b,/in), $(b,/out) and $(b,/probe), in JSON. Besides, in space: \
         $(b,/pose/...), what has a position and a heading; $(b,/tf), the robot by odometry; \
         $(b,/ranges), the cones of its sonars' echoes. And $(b,/image/...), the frames of \
         cameras.";
      `P
        "The recording itself is in it too, with the frames; so $(tname) can make the same files \
         of it again, byte for byte. It makes none of MCAP that others have written.";
      `P
        "From one recording to another it changes the compression. Of an archive that is cut off \
         or damaged the rows that are whole are converted, with a warning.";
      `Pre
        "frobc run program.frob --for 60s --record run.csv.gz\n\
         $(tname) run.csv.gz run.mcap\n\
         $(tname) run.mcap again.csv";
    ]
  in
  command "convert" ~man ~doc:"recordings as MCAP, for Foxglove and PlotJuggler, and back"
    Term.(const Driver.Convert.run $ from $ into)
