open Cmdliner
open Options
module General = Driver.General

let jobs =
  let doc = "So many processes at a time; without it, as many as there are processors." in
  Arg.(value & opt (some int) None & info [ "j"; "jobs" ] ~docv:"N" ~doc)

let positive name = function
  | Some n when n < 1 -> Error (Printf.sprintf "%s takes a number of at least 1" name)
  | _ -> Ok ()

let test =
  let paths =
    let doc =
      "A $(b,.frob) file, or a folder: all files in it with tests. Without any: this folder."
    in
    Arg.(value & pos_all string [] & info [] ~docv:"FILE" ~doc)
  in
  let pattern =
    let doc = "Run only tests whose label has this text in it." in
    Arg.(value & opt (some string) None & info [ "k" ] ~docv:"TEXT" ~doc)
  in
  let seeds =
    let doc = "Run each trial with so many seeds, from its first on, instead of as it says." in
    Arg.(value & opt (some int) None & info [ "seeds" ] ~docv:"N" ~doc)
  in
  let rate =
    let doc = "Instants a second." in
    Arg.(value & opt float 50. & info [ "rate" ] ~docv:"HZ" ~doc)
  in
  let json =
    let doc = "Print an object a line, for tools, with each run of a trial." in
    Arg.(value & flag & info [ "json" ] ~doc)
  in
  let junit =
    let doc = "Write what became of the tests as a JUnit document, for a CI server." in
    Arg.(value & opt (some string) None & info [ "junit" ] ~docv:"FILE.xml" ~doc)
  in
  let keep =
    let doc = "The folder for a recording and a picture of each trial that fails." in
    Arg.(value & opt string "failed" & info [ "keep" ] ~docv:"DIR" ~doc)
  in
  let update =
    let doc = "Write the output files of golden traces anew, where they have changed." in
    Arg.(value & flag & info [ "update" ] ~doc)
  in
  let run general sources pattern seeds jobs rate json junit update keep paths =
    match (positive "--seeds" seeds, positive "--jobs" jobs) with
    | Error text, _ | _, Error text -> General.wrong_use text
    | Ok (), Ok () when not (rate >= 0.1 && rate <= 10000.) ->
        General.wrong_use "--rate takes a number from 0.1 to 10000"
    | Ok (), Ok () ->
        Driver.Trials.run general ~sources
          { Driver.Checking.pattern; seeds; jobs; rate; json; junit; update; keep }
          paths
  in
  let man =
    [
      `S Manpage.s_description;
      `P
        "Runs what programs say of themselves: $(b,test \"label\" = during 2[s] observer), \
         $(b,test \"label\" = trace \"in.csv\" \"out.csv\"), and $(b,trial \"label\" = Trial { … \
         }), which drives the program in the simulator with many seeds and judges what really \
         happens. A line for each; of a trial that fails the seed, when, what was there, a \
         picture, and the command that shows the run.";
      `P "The exit status is 1 if a test fails.";
    ]
  in
  command "test" ~man ~doc:"run the tests and trials that are written in programs"
    Term.(
      const run $ general $ sources $ pattern $ seeds $ jobs $ rate $ json $ junit $ update $ keep
      $ paths)

let sweep =
  let plan =
    let doc = "The plan: what is varied, in TOML." in
    Arg.(required & pos 0 (some string) None & info [] ~docv:"PLAN.toml" ~doc)
  in
  let shard =
    let doc =
      "Make only the K-th of N parts of the runs, as $(b,3/100): for a batch system, each part on \
       a machine. $(b,--merge) makes the table then."
    in
    let parse text =
      match List.map int_of_string_opt (String.split_on_char '/' text) with
      | [ Some number; Some of_ ] when number >= 1 && number <= of_ ->
          Ok { Driver.Runs.number; of_ }
      | _ -> Error (`Msg (Printf.sprintf "`%s` is no shard; the third of a hundred is 3/100" text))
    in
    let print out { Driver.Runs.number; of_ } = Format.fprintf out "%d/%d" number of_ in
    Arg.(
      value
      & opt (conv (parse, print)) { Driver.Runs.number = 1; of_ = 1 }
      & info [ "shard" ] ~docv:"K/N" ~doc)
  in
  let merge =
    let doc = "Make no runs, but the table of the rows that are there." in
    Arg.(value & flag & info [ "merge" ] ~doc)
  in
  let dry =
    let doc =
      "Make nothing, but check the plan, and tell how many runs there are and how many of them are \
       done; and a digest, which is the same on each machine that would make the same runs."
    in
    Arg.(value & flag & info [ "dry-run" ] ~doc)
  in
  let rows =
    let doc = "The folder where rows are kept; without it, $(b,PLAN.rows) beside the plan." in
    Arg.(value & opt (some string) None & info [ "rows" ] ~docv:"DIR" ~doc)
  in
  let also =
    let doc = "One more folder with rows, of another machine; may be given several times." in
    Arg.(value & opt_all string [] & info [ "also" ] ~docv:"DIR" ~doc)
  in
  let table =
    let doc = "Where the table goes; without it, $(b,PLAN.csv) beside the plan." in
    Arg.(value & opt (some string) None & info [ "table" ] ~docv:"T.csv" ~doc)
  in
  let picture =
    let doc = "Draw a heat map over two parameters, a line over one, or else histograms." in
    Arg.(value & opt (some string) None & info [ "picture" ] ~docv:"P.svg" ~doc)
  in
  let run general sources jobs shard merge dry rows also table picture plan =
    match (positive "--jobs" jobs, List.find_opt (fun dir -> not (Sys.file_exists dir)) also) with
    | Error text, _ -> General.wrong_use text
    | Ok (), Some folder -> General.wrong_use (Printf.sprintf "there is no folder %s" folder)
    | Ok (), None ->
        Driver.Sweep.run general ~sources
          { Driver.Sweep.jobs; shard; merge; dry; rows; also; table; picture }
          plan
  in
  let man =
    [
      `S Manpage.s_description;
      `P
        "Makes many runs of a trial, over worlds, robots, values of parameters and seeds, and a \
         table with a row for each: what became of it, and what the trial measures.";
      `Pre
        "program = \"wall_follow.frob\"\n\
         seeds = [1, 20]\n\n\
         [params]\n\
         gap = \"0.2[m] to 0.6[m], 9 steps\"";
      `P
        "Each row is kept as soon as its run is done. Whatever ends a sweep, the same command goes \
         on where it ended; a plan with more runs makes only those that are new.";
    ]
  in
  command "sweep" ~man ~doc:"make many runs of a trial, and a table of them"
    Term.(
      const run $ general $ sources $ jobs $ shard $ merge $ dry $ rows $ also $ table $ picture
      $ plan)
