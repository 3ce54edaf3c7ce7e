open Cmdliner
open Options
module Reporting = Build.Reporting

let jobs =
  let doc = "Number of parallel processes. The default is the number of processors." in
  Arg.(value & opt (some int) None & info [ "j"; "jobs" ] ~docv:"N" ~doc)

let positive name = function
  | Some n when n < 1 -> Error (Printf.sprintf "%s must be a number of at least 1" name)
  | _ -> Ok ()

let test =
  let paths =
    let doc =
      "A $(b,.frob) file, which includes its test file $(b,NAME.test.frob) if there is one, or a \
       folder, for all files with tests in it. The default is this folder."
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
          { Tools.Checking.pattern; seeds; jobs; rate; json; junit; update; keep }
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

let sweep =
  let plan =
    let doc = "The plan of the sweep, a TOML file that says what to vary." in
    Arg.(required & pos 0 (some string) None & info [] ~docv:"PLAN.toml" ~doc)
  in
  let shard =
    let doc =
      "Perform only part K of N of the runs, as in $(b,3/100). A batch system can use this to \
       distribute the runs over several machines. When all parts are done, make the table with \
       $(b,--merge)."
    in
    let parse text =
      match List.map int_of_string_opt (String.split_on_char '/' text) with
      | [ Some number; Some of_ ] when number >= 1 && number <= of_ -> Ok { Tools.Runs.number; of_ }
      | _ ->
          Error
            (`Msg
               (Printf.sprintf "`%s` is not a shard; for the third of a hundred shards, write 3/100"
                  text))
    in
    let print out { Tools.Runs.number; of_ } = Format.fprintf out "%d/%d" number of_ in
    Arg.(
      value
      & opt (conv (parse, print)) { Tools.Runs.number = 1; of_ = 1 }
      & info [ "shard" ] ~docv:"K/N" ~doc)
  in
  let merge =
    let doc = "Make the table from the existing rows, without any further runs." in
    Arg.(value & flag & info [ "merge" ] ~doc)
  in
  let dry =
    let doc =
      "Make no runs. Check the plan, and print the number of runs, how many of them are done, and \
       a digest. Machines that would make the same runs print the same digest."
    in
    Arg.(value & flag & info [ "dry-run" ] ~doc)
  in
  let rows =
    let doc = "Folder in which to save rows. The default is $(b,PLAN.rows) in the plan's folder." in
    Arg.(value & opt (some string) None & info [ "rows" ] ~docv:"DIR" ~doc)
  in
  let also =
    let doc = "Another folder with rows, from another machine. Can be repeated." in
    Arg.(value & opt_all string [] & info [ "also" ] ~docv:"DIR" ~doc)
  in
  let table =
    let doc = "Output file for the table. The default is $(b,PLAN.csv) in the plan's folder." in
    Arg.(value & opt (some string) None & info [ "table" ] ~docv:"T.csv" ~doc)
  in
  let picture =
    let doc =
      "Draw a heat map for two parameters, a line plot for one parameter, and histograms otherwise."
    in
    Arg.(value & opt (some string) None & info [ "picture" ] ~docv:"P.svg" ~doc)
  in
  let run general sources jobs shard merge dry rows also table picture plan =
    match (positive "--jobs" jobs, List.find_opt (fun dir -> not (Sys.file_exists dir)) also) with
    | Error text, _ -> Reporting.wrong_use text
    | Ok (), Some folder -> Reporting.wrong_use (Printf.sprintf "there is no folder %s" folder)
    | Ok (), None ->
        Tools.Sweep.run general ~sources
          { Tools.Sweep.jobs; shard; merge; dry; rows; also; table; picture }
          plan
  in
  let man =
    [
      `S Manpage.s_description;
      `P
        "Makes many runs of a trial with different worlds, robots, parameter values and seeds. \
         Writes a table with a row for each run: its result and the quantities that the trial \
         measures.";
      `Pre
        "program = \"wall_follow.frob\"\n\
         seeds = [1, 20]\n\n\
         [params]\n\
         gap = \"0.2[m] to 0.6[m], 9 steps\"";
      `P
        "Each row is saved as soon as its run is done. If a sweep is interrupted, run the same \
         command to continue. If you add runs to the plan, the same command makes only the new \
         ones.";
    ]
  in
  command "sweep" ~man ~doc:"make many runs of a trial and a table of the results"
    Term.(
      const run $ general $ sources $ jobs $ shard $ merge $ dry $ rows $ also $ table $ picture
      $ plan)
