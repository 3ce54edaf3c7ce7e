open Cmdliner
open Options
module Reporting = Build.Reporting

let plan =
  let doc = "The plan of the sweep, a TOML file that says what to vary." in
  Arg.(required & pos 0 (some string) None & info [] ~docv:"PLAN.toml" ~doc)

let shard =
  let doc =
    "Divide the runs into N parts, and perform only part K, as in $(b,3/100). A batch system can \
     use this to distribute the runs across several machines. When all parts are done, create the \
     table with $(b,--merge)."
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

let merge =
  let doc = "Create the table from the existing rows, without any further runs." in
  Arg.(value & flag & info [ "merge" ] ~doc)

let dry =
  let doc =
    "Do not perform any runs. Check the plan, and print the number of runs, how many of them are \
     done, and a digest. Machines that would perform the same runs print the same digest."
  in
  Arg.(value & flag & info [ "dry-run" ] ~doc)

let rows =
  let doc = "Folder in which to save rows. The default is $(b,PLAN.rows) in the plan's folder." in
  Arg.(value & opt (some string) None & info [ "rows" ] ~docv:"DIR" ~doc)

let also =
  let doc = "Another folder with rows, from another machine. Can be repeated." in
  Arg.(value & opt_all string [] & info [ "also" ] ~docv:"DIR" ~doc)

let table =
  let doc = "Output file for the table. The default is $(b,PLAN.csv) in the plan's folder." in
  Arg.(value & opt (some string) None & info [ "table" ] ~docv:"T.csv" ~doc)

let picture =
  let doc =
    "Draw a heat map for two parameters, a line plot for one parameter, and histograms otherwise."
  in
  Arg.(value & opt (some string) None & info [ "picture" ] ~docv:"P.svg" ~doc)

let sweep =
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
        "Performs many runs of a trial with different worlds, robots, parameter values and seeds. \
         Writes a table with a row for each run: its result and the quantities that the trial \
         measures.";
      `Pre
        "program = \"wall_follow.frob\"\n\
         seeds = [1, 20]\n\n\
         [params]\n\
         gap = \"0.2[m] to 0.6[m], 9 steps\"";
      `P
        "Each row is saved as soon as its run is done. If a sweep is interrupted, run the same \
         command to continue. If you add runs to the plan, the same command performs only the new \
         ones.";
    ]
  in
  command "sweep" ~man ~doc:"perform many runs of a trial and write a table of the results"
    Term.(
      const run $ general $ sources $ jobs $ shard $ merge $ dry $ rows $ also $ table $ picture
      $ plan)
