type options = {
  jobs : int option;
  shard : Runs.shard;
  merge : bool;
  dry : bool;
  rows : string option;
  also : string list;
  table : string option;
  picture : string option;
}

open Basis.Let_syntax.Result

let wrong result = Result.map_error Reporting.wrong_use result

(* {1 Summary} *)

let plural n word = Printf.sprintf "%d %s%s" n word (if n = 1 then "" else "s")

let summary (t : Setup.t) rows =
  let total = Runs.count t in
  let cells = Array.init total (fun n -> Option.get (Rows.find rows (Runs.run t n).key)) in
  let fates = Array.map Table.fate cells in
  let count is = Array.fold_left (fun n fate -> if is fate then n + 1 else n) 0 fates in
  let held = count (fun f -> f.held) and void = count (fun f -> f.void) in
  Printf.printf "%s: %d held, %d failed%s\n" (plural total "run") held
    (total - held - void)
    (if void = 0 then "" else Printf.sprintf ", %d void because an assumption failed" void);
  let spread (m : Measures.t) =
    let values = Array.to_list (Array.mapi (fun n c -> (n + 1, Table.measured t c m)) cells) in
    print_endline ("  " ^ Spread.text ~each:"run" ~name:m.name ~unit_:m.unit_ values)
  in
  List.iter spread t.measures

(* {1 The command} *)

let stem plan =
  if Filename.check_suffix plan ".toml" then Filename.chop_suffix plan ".toml" else plan

let outputs options plan =
  let table = Option.value options.table ~default:(stem plan ^ ".csv") in
  let output content asked path = { Output.path; content; asked } in
  let pictures = List.map (output Picture "--picture") (Option.to_list options.picture) in
  (table, output Rows "--table" table :: pictures)

let finish (t : Setup.t) rows options ~table =
  let drawn = Option.map (fun path -> (path, Sweep_picture.svg t rows)) options.picture in
  let* () = wrong (Output.write ((table, Table.csv t rows) :: Option.to_list drawn)) in
  summary t rows;
  Printf.printf "table: %s\n" (Basis.Printable.name table);
  Option.iter (fun (path, _) -> Printf.printf "picture: %s\n" (Basis.Printable.name path)) drawn;
  Ok ()

let here = function
  | { Runs.of_ = 1; _ } -> ""
  | { number; of_ } -> Printf.sprintf " of shard %d/%d" number of_

let loaded folders =
  let rows = Rows.create () in
  match List.iter (Rows.load rows) folders with
  | () -> Ok rows
  | exception Sys_error reason ->
      Error (Reporting.wrong_use (Printf.sprintf "cannot read %s" reason))

(* Describes how to continue after an interruption. Each row is written as soon as its run is
   done. *)
let interrupted (t : Setup.t) options ~folder () =
  let all = List.length (Runs.missing t options.shard (Rows.create ())) in
  match loaded (folder :: options.also) with
  | Error _ -> "run the same command to continue"
  | Ok rows ->
      let left = List.length (Runs.missing t options.shard rows) in
      Printf.sprintf "%d of %s are saved in %s; run the same command to perform the remaining %d"
        (all - left) (plural all "run") folder left

let made (t : Setup.t) options resources rows ~folder =
  let whole = { Runs.number = 1; of_ = 1 } in
  let missing = Runs.missing t options.shard rows in
  let count = List.length missing in
  let total = Runs.count t in
  let* () =
    if options.merge || missing = [] then Ok ()
    else
      let jobs = match options.jobs with Some n -> n | None -> Workers.processors () in
      let* () = wrong (Output.folder folder) in
      match
        Interruption.reported (interrupted t options ~folder) (fun () ->
            Runs.make t resources ~jobs ~folder rows missing)
      with
      | Ok () -> Ok ()
      | Error reason ->
          let left = List.length (Runs.missing t options.shard rows) in
          Error
            (Reporting.wrong_use
               (Printf.sprintf "%s\n%s done, %d left; run the same command to continue" reason
                  (plural (count - left) "run")
                  left))
  in
  let left = List.length (Runs.missing t whole rows) in
  if left = 0 then Ok `Complete
  else if options.merge then
    Error
      (Reporting.wrong_use
         (Printf.sprintf
            "%d of %s are missing: run their shards, or name their folder with `--also`" left
            (plural total "run")))
  else (
    Printf.printf
      "%s%s done; %d remain for other shards; when all are done, create the table with `--merge`\n"
      (plural count "run") (here options.shard) left;
    Ok `Shard)

(* Prints the number of runs, the number of those that are done, and a digest of everything that the
   runs depend on. *)
let count_only (t : Setup.t) options rows =
  let keys = List.init (Runs.count t) (fun n -> (Runs.run t n).key) in
  let missing = List.length (Runs.missing t options.shard rows) in
  let ours = List.length (Runs.missing t options.shard (Rows.create ())) in
  Printf.printf "runs: %d\ndone: %d\ndigest: %s\n" ours (ours - missing)
    (Digest.to_hex (Digest.string (String.concat "" keys)))

let run general ~sources options plan =
  let folder = Option.value options.rows ~default:(stem plan ^ ".rows") in
  let result =
    let* resources = wrong (Installation.find ()) in
    let table, outputs = outputs options plan in
    let* () = wrong (Output.check ~reads:[ plan ] outputs) in
    let* () =
      match options.picture with
      | Some path when not (Filename.check_suffix path ".svg") ->
          Error (Reporting.wrong_use (path ^ " must end in .svg: a sweep is drawn as SVG"))
      | _ -> Ok ()
    in
    let* t = Preparation.of_plan general ~sources plan in
    let* rows = loaded (folder :: options.also) in
    if options.dry then Ok (count_only t options rows)
    else
      let* state = made t options resources rows ~folder in
      match state with `Complete -> finish t rows options ~table | `Shard -> Ok ()
  in
  match result with Ok () -> Exit_status.ok | Error status -> status
