open Cmdliner
open Options
module Reporting = Build.Reporting

let test =
  let paths =
    let doc =
      "A $(b,.frob) file to test, together with its test file $(b,NAME.test.frob) if that exists, \
       or a folder, to run all the tests in it. The default is the current folder."
    in
    Arg.(value & pos_all string [] & info [] ~docv:"FILE" ~doc)
  in
  let pattern =
    let doc = "Run only the tests whose label contains this text." in
    Arg.(value & opt (some string) None & info [ "k" ] ~docv:"TEXT" ~doc)
  in
  let seeds =
    let doc =
      "Run each trial with this number of seeds, starting at its first seed. The default is the \
       number that the trial declares."
    in
    Arg.(value & opt (some int) None & info [ "seeds" ] ~docv:"N" ~doc)
  in
  let rate =
    let doc = "Instants per second." in
    Arg.(value & opt float 50. & info [ "rate" ] ~docv:"HZ" ~doc)
  in
  let json =
    let doc = "Print one JSON object per line, for tools, including each run of a trial." in
    Arg.(value & flag & info [ "json" ] ~doc)
  in
  let junit =
    let doc = "Write the results as a JUnit file, for a CI server." in
    Arg.(value & opt (some string) None & info [ "junit" ] ~docv:"FILE.xml" ~doc)
  in
  let keep =
    let doc = "Folder in which to save a recording and a picture of each trial that fails." in
    Arg.(value & opt string "failed" & info [ "keep" ] ~docv:"DIR" ~doc)
  in
  let update =
    let doc = "Update the output files of golden traces whose output has changed." in
    Arg.(value & flag & info [ "update" ] ~doc)
  in
  let run general sources pattern seeds jobs rate json junit update keep paths =
    match (positive "--seeds" seeds, positive "--jobs" jobs) with
    | Error text, _ | _, Error text -> Reporting.wrong_use text
    | Ok (), Ok () when not (rate >= 0.1 && rate <= 10000.) ->
        Reporting.wrong_use "--rate must be a number from 0.1 to 10000"
    | Ok (), Ok () ->
        Tools.Trials.run general ~sources
          { Tools.Session.pattern; seeds; jobs; rate; json; junit; update; keep }
          paths
  in
  let man =
    [
      `S Manpage.s_description;
      `P
        "Runs the tests in programs: $(b,test \"label\" = during 2[s] observer), $(b,test \
         \"label\" = trace \"in.csv\" \"out.csv\"), and $(b,trial \"label\" = Trial { … }), which \
         runs the program in the simulator with many seeds and checks the simulated robot. Prints \
         a line for each test. For a trial that fails, also prints the seed, the time, the robot's \
         surroundings, a picture, and the command that shows the run.";
      `P "The exit status is 1 if a test fails.";
    ]
  in
  command "test" ~man ~doc:"run the tests and trials in programs"
    Term.(
      const run $ general $ sources $ pattern $ seeds $ jobs $ rate $ json $ junit $ update $ keep
      $ paths)
