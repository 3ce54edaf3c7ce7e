open Basis
open Common_options
open Reporting

type engine = C | Interpreter

let compiled_trace general ~goes_on ~dialect ~params ~entry ~sources ~modes ~input ~output file =
  Built.hosted ~goes_on general ~entry ~sources file
    ~host:(fun resources -> resources.Resources.trace_host)
    ~arguments:(fun _ program ->
      (if modes then [ "--modes" ] else [])
      @ assert_options general @ Params.host_options params @ Interp.Dialect.arguments dialect
      @ (program :: input :: Option.to_list output))

(* Runs the interpreter. Its messages are the same as those of the host for compiled programs. *)
let interpreted_trace general ~dialect ~params ~entry ~input ~output file =
  let* resources = Installation.find () in
  Compiled.accepted Queries.interpretable general resources ~entry file
    (fun _ (core, entry, marks) ->
      let params = List.map (fun (p : Params.set) -> (p.param, p.value)) params in
      match Interpreted.trace core ~entry ~marks ~params ~dialect ~input ~output with
      | Ok () -> Exit_status.ok
      | Error errors ->
          List.iter (fun text -> Printf.eprintf "error: %s\n" (Printable.text text)) errors;
          Exit_status.wrong_use)

(* The units of the trace's columns, if they are known. *)
let units_of_columns general (resources : Resources.t) ~entry file =
  let columns =
    match Robots.known general.robot with
    | Error _ -> None
    | Ok robot ->
        let options = { general with probes = [] } in
        Queries.columns (Diagnostic.sink ()) (Source.create ())
          (Request.make ~options ?robot ~entry ~library:resources.library file)
  in
  let table = Hashtbl.create 64 in
  List.iter
    (fun (c : Columns.t) -> Hashtbl.replace table c.name c.unit_)
    (Option.value columns ~default:[]);
  fun name -> Option.value (Hashtbl.find_opt table name) ~default:""

let draw general ~entry ~trace ~picture file =
  let* resources = Installation.find () in
  let units = units_of_columns general resources ~entry file in
  let* drawn = Drawn.picture ~units trace in
  let* () = Output.write [ (picture, drawn) ] in
  Exit_status.ok

let trace general engine ~dialect ~entry ~sources ~modes ~input ~output ~picture file =
  let general = Bag.for_its_robot general input in
  let run ~input ~output =
    let* input = Bag.recording ~program:file input in
    let* resources = Installation.find () in
    Compiled.with_params general resources ~entry file @@ fun params ->
    match engine with
    | C ->
        let goes_on = picture <> None in
        compiled_trace general ~goes_on ~dialect ~params ~entry ~sources ~modes ~input ~output file
    | Interpreter when modes ->
        prerr_endline
          "error: only the compiled program shows its modes: use `--modes` with `--engine c`";
        Exit_status.wrong_use
    | Interpreter when general.asserts = Stop ->
        wrong_use
          "only the compiled program stops at assertions: use `--asserts=stop` with `--engine c`"
    | Interpreter when List.exists (fun p -> p <> Drawing.probe) general.probes ->
        wrong_use "only the compiled program has probes: use `--probe` with `--engine c`"
    | Interpreter -> interpreted_trace general ~dialect ~params ~entry ~input ~output file
  in
  match input with
  | _ when Probed.asks_for_list general -> Probed.print_list general ~entry file
  | None -> wrong_use "the input is missing: give a recording with `--input IN.csv`"
  | Some input -> (
      let outputs =
        List.map (Output.asked Table "--output") (Option.to_list output)
        @ List.map (Output.asked Picture "--picture") (Option.to_list picture)
      in
      let* () = Output.check ~reads:(input :: file :: sources) outputs in
      match picture with
      | None -> run ~input ~output
      | Some picture when not (Filename.check_suffix picture ".svg") ->
          wrong_use
            (Printf.sprintf "a trace is drawn as SVG: use a file name that ends in .svg, not %s"
               picture)
      | Some picture ->
          let trace =
            match output with
            | Some output -> output
            | None -> Filename.concat (Temporary.folder ()) "trace.csv"
          in
          let status = run ~input ~output:(Some trace) in
          if status = Exit_status.ok then draw general ~entry ~trace ~picture file else status)
