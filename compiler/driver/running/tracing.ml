open Basis
open General

type engine = C | Interpreter

let compiled_trace general ~params ~entry ~sources ~modes ~input ~output file =
  Built.hosted general ~entry ~sources file
    ~host:(fun resources -> resources.Resources.trace_host)
    ~arguments:(fun _ program ->
      (if modes then [ "--modes" ] else [])
      @ assert_options general @ param_options params
      @ (program :: input :: Option.to_list output))

(* Speaks as the host of compiled programs does. *)
let interpreted_trace general ~params ~entry ~input ~output file =
  let* resources = Resources.find () in
  Compiled.accepted Pipeline.interpretable general resources ~entry file
    (fun _ (core, entry, marks) ->
      let params = List.map (fun (p : Params.set) -> (p.param, p.value)) params in
      match Interpreted.trace core ~entry ~marks ~params ~input ~output with
      | Ok () -> Exit_status.ok
      | Error errors ->
          List.iter (Printf.eprintf "error: %s\n") errors;
          Exit_status.wrong_use)

(* Of the trace's columns, where they are known. *)
let units_of_columns general (resources : Resources.t) ~entry file =
  let columns =
    match Robots.known general.robot with
    | Error _ -> None
    | Ok robot ->
        let request = request general ?robot ~entry ~library:resources.library file in
        Pipeline.columns (Diagnostic.sink ()) (Source.create ()) { request with probes = [] }
  in
  let table = Hashtbl.create 64 in
  List.iter
    (fun (c : Columns.t) -> Hashtbl.replace table c.name c.unit_)
    (Option.value columns ~default:[]);
  fun name -> Option.value (Hashtbl.find_opt table name) ~default:""

let draw general ~entry ~trace ~picture file =
  let* resources = Resources.find () in
  let units = units_of_columns general resources ~entry file in
  let* drawn = Drawn.picture ~units trace in
  let* () = Output.write [ (picture, drawn) ] in
  Exit_status.ok

let trace general engine ~entry ~sources ~modes ~input ~output ~picture file =
  let run ~input ~output =
    let* resources = Resources.find () in
    with_params general resources ~entry file @@ fun params ->
    match engine with
    | C -> compiled_trace general ~params ~entry ~sources ~modes ~input ~output file
    | Interpreter when modes ->
        prerr_endline "error: modes are those of the compiled program: `--modes` needs `--engine c`";
        Exit_status.wrong_use
    | Interpreter when general.asserts = Stop ->
        wrong_use
          "assertions are judged in the compiled program: `--asserts=stop` needs `--engine c`"
    | Interpreter when List.exists (fun p -> p <> Drawing.probe) general.probes ->
        wrong_use "probes are put into the compiled program: `--probe` needs `--engine c`"
    | Interpreter -> interpreted_trace general ~params ~entry ~input ~output file
  in
  match input with
  | _ when Probed.asks_for_list general -> Probed.print_list general ~entry file
  | None -> wrong_use "there is nothing to run on: `--input IN.csv` names a recording"
  | Some input -> (
      let outputs =
        List.map (Output.asked Table "--output") (Option.to_list output)
        @ List.map (Output.asked Picture "--picture") (Option.to_list picture)
      in
      let* () = Output.check ~reads:(input :: file :: sources) outputs in
      match picture with
      | None -> run ~input ~output
      | Some picture when not (Filename.check_suffix picture ".svg") ->
          wrong_use (Printf.sprintf "a trace is drawn as SVG: %s does not end in .svg" picture)
      | Some picture ->
          let trace =
            match output with
            | Some output -> output
            | None -> Filename.concat (Temporary.folder ()) "trace.csv"
          in
          let status = run ~input ~output:(Some trace) in
          if status = Exit_status.ok then draw general ~entry ~trace ~picture file else status)
