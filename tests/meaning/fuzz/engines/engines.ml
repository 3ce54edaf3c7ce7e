open Basis

type tools = { library : string; runtime : string; folder : string; real : Real.t; probed : bool }
type c_engine = Tcc | Sanitized of Sanitized.compiler

type outcome =
  | Agree
  | Rejected of string
  | Failed of string
  | Differ of {
      by : c_engine;
      row : int;
      column : string;
      c : string;
      interpreted : string;
      recording : Recording.t;
    }

let engine_name = function
  | Tcc -> "C (tcc)"
  | Sanitized compiler -> Printf.sprintf "C (%s, with sanitizers)" (Sanitized.name compiler)

let describe outcome =
  match outcome with
  | Agree -> "agrees"
  | Rejected text -> "is rejected:\n" ^ text
  | Failed text -> "fails:\n" ^ text
  | Differ { by; row; column; c; interpreted; _ } ->
      Printf.sprintf "differs in row %d of `%s`: %s gives %s, the interpreter %s" row column
        (engine_name by) c interpreted

type subject = {
  core : Core.Ir.program;
  entry : Core.Ir.Global.t;
  input : Interp.Shape.t;
  output : Interp.Shape.t;
  files : (string * string) list;
}

let ( let* ) = Result.bind
let ( / ) = Filename.concat

(* The message and stage of a compiler bug, or None for other exceptions. The fuzzer reports the
   program that triggers it. *)
let internal_error : exn -> string option = function
  | Diagnostic.Bug { stage; message } ->
      Some (Printf.sprintf "internal error in %s: %s" stage message)
  | Invalid_argument reason | Failure reason -> Some ("internal error: " ^ reason)
  | Not_found -> Some "internal error: something is not found"
  | Stack_overflow -> Some "internal error: the stack overflowed"
  | _ -> None

let guarded act =
  match act () with
  | result -> result
  | exception exn when internal_error exn <> None ->
      (* OCAMLRUNPARAM=b adds a backtrace. *)
      Error (Failed (Option.get (internal_error exn) ^ "\n" ^ Printexc.get_backtrace ()))

(* Limited because tcc has little room for a call's results. *)
let most_probes = 40

let is_claim (c : Build.Columns.t) =
  let word = Str.regexp "\\.\\(assert\\|assume\\) " in
  match Str.search_forward word c.name 0 with _ -> true | exception Not_found -> false

(* Chooses some of the program's signals, evenly spread over it. Also returns whether the program
   has few enough assertions. *)
let some_probes request =
  match Build.Queries.columns (Diagnostic.sink ()) (Source.create ()) request with
  | None -> ([], false)
  | Some columns ->
      let few =
        List.compare_length_with (List.filter is_claim columns) (Int.div most_probes 2) <= 0
      in
      let is_probe (c : Build.Columns.t) = String.starts_with ~prefix:"probe." c.name in
      let all = List.filter is_probe columns in
      let every = 1 + Int.div (List.length all) most_probes in
      let some = List.filteri (fun k _ -> k mod every = 0) all in
      (List.map (fun (c : Build.Columns.t) -> c.name) some, few)

(* Loads a program with these probes. With [watched], its assertions are judged as well. *)
let rec load_with ?(watched = false) probes ?robot tools ~entry file =
  let sink = Diagnostic.sink () and sources = Source.create () in
  let asserts = if watched then Build.Common_options.Count else Off in
  let options =
    { Build.Common_options.default with real = tools.real; lint = true; probes; asserts }
  in
  let request = Build.Request.make ~options ?robot ~entry ~library:tools.library file in
  match Build.Queries.for_both_engines sink sources request with
  | None
    when List.exists (fun (d : Diagnostic.t) -> d.code = Build.Probes.unknown) (Diagnostic.all sink)
    ->
      (* One of the probes may be a signal that cannot be observed, in a switch fed with its own
         output. *)
      load_with [] ?robot tools ~entry file
  | None -> Error (Rejected (Render_text.diagnostics ~colour:false sources (Diagnostic.all sink)))
  | Some (core, entry, c) ->
      let name = Build.C_file.name file in
      let input, output = Interp.Execution.interface core entry in
      let sees (c : Core.Ir.control) = c.kind = Camera in
      if List.exists sees core.console then Frames.write ~folder:tools.folder;
      Ok
        {
          core;
          entry;
          input = Interp.Shape.of_type core input;
          output = Interp.Shape.of_type core output;
          files =
            [
              (name ^ ".h", c.header);
              (name ^ ".c", c.source);
              (name ^ "_host.c", Option.get c.host_table);
            ];
        }

let load ?robot tools ~entry file =
  guarded @@ fun () ->
  let probes, watched =
    if not tools.probed then ([], false)
    else
      let options = { Build.Common_options.default with real = tools.real } in
      some_probes (Build.Request.make ~options ?robot ~entry ~library:tools.library file)
  in
  load_with ~watched probes ?robot tools ~entry file

let judges tools file =
  guarded @@ fun () ->
  let sink = Diagnostic.sink () and sources = Source.create () in
  let request = Build.Request.make ~library:tools.library file in
  match Build.Queries.checks sink sources request with
  | None -> Error (Rejected (Render_text.diagnostics ~colour:false sources (Diagnostic.all sink)))
  | Some checks ->
      let judge (check : Build.Checks.t) =
        match check.plan with
        | Traced _ -> None
        | Alone | Simulated _ -> Some (Resolve.Labels.judge check.name)
      in
      Ok (List.filter_map judge checks)

let files subject = subject.files

(* Parses the parameters from a saved recording's lines, or chooses random values. *)
let params_of lines random subject : Recording.param list =
  let core = subject.core in
  let param (p : Core.Ir.param) : Recording.param =
    let shape = Interp.Shape.of_type core p.ty in
    let saved line =
      match Interp.Recorded_params.read core ~set:[] line with
      | Ok [ (name, value) ], _ when name = p.param -> Some value
      | _, _ -> None
    in
    let rec any () =
      let rows = Recording.rows (Input.make random Wild shape ~rows:1) in
      match (List.hd rows).value with Float x when Float.is_nan x -> any () | value -> value
    in
    let value = match List.find_map saved lines with Some value -> value | None -> any () in
    {
      line = Interp.Recorded_params.line core p value;
      cell = Interp.Cell.write shape value;
      setting = (p.param, value);
    }
  in
  List.map param core.params

let set random subject recording =
  if subject.core.params = [] then recording
  else Recording.with_params (params_of [] random subject) recording

let with_dt random ~rows tools subject =
  let precision : Real.t =
    match tools.real with
    | Double -> Double
    | Single -> if Random.State.bool random then Single else Double
  in
  set random subject (Input.with_dt random precision subject.input ~rows)

let recordings random ~rows subject =
  let tame = Input.make random Tame subject.input ~rows in
  let wild = Input.make random Wild subject.input ~rows in
  [ set random subject tame; set random subject wild ]

let fits subject recording =
  let names = List.map (fun (p : Recording.param) -> fst p.setting) (Recording.params recording) in
  Recording.has_shape subject.input recording
  && names = List.map (fun (p : Core.Ir.param) -> p.param) subject.core.params

let read_recording subject text =
  let params = params_of (String.split_on_char '\n' text) (Random.State.make [| 1 |]) subject in
  Result.map (Recording.with_params params) (Recording.read subject.input text)

(* The columns of a program's trace. A program that ends has additional columns. *)
let traced subject recording =
  let text = Recording.csv recording in
  let at = ref 0 and out = Buffer.create 4096 in
  let read () =
    if !at = String.length text then None
    else (
      incr at;
      Some text.[!at - 1])
  in
  match
    Interp.Trace.run subject.core ~entry:subject.entry ~name:"input" ~read
      ~write:(Buffer.add_string out)
  with
  | Ok () -> Buffer.contents out
  | Error complaints -> failwith (String.concat "\n" complaints)

let interpreted subject recording =
  let params = List.map (fun (p : Recording.param) -> p.setting) (Recording.params recording) in
  let execution = Interp.Execution.start ~params subject.core ~entry:subject.entry in
  if Option.is_some (Interp.Execution.ended execution) then traced subject recording
  else
    let precision = Recording.precision recording in
    let instant (row : Recording.row) seconds =
      (row.time_ns, Interp.Execution.instant ~precision execution ~seconds row.value)
    in
    Recording.trace subject.output
      (List.map2 instant (Recording.rows recording) (Recording.seconds recording))

let failed result = Result.map_error (fun text -> Failed text) result

let write path text =
  let channel = open_out_bin path in
  Fun.protect ~finally:(fun () -> close_out channel) (fun () -> output_string channel text)

let in_process tools subject recordings =
  List.iter (fun (file, text) -> write (tools.folder / file) (Build.Tcc.adapted text)) subject.files;
  let sources =
    List.filter_map
      (fun (file, _) ->
        if Filename.check_suffix file ".c" then Some (tools.folder / file) else None)
      subject.files
  in
  let* program =
    In_process.compile ~headers:(tools.runtime / "include") ~folder:tools.folder sources |> failed
  in
  Fun.protect
    ~finally:(fun () -> In_process.release program)
    (fun () ->
      List.fold_right
        (fun recording traces ->
          let* traces = traces in
          let* trace = failed (In_process.run program ~real:tools.real recording) in
          Ok (trace :: traces))
        recordings (Ok []))

let traces tools engine subject recordings =
  match engine with
  | Tcc -> in_process tools subject recordings
  | Sanitized compiler ->
      failed
        (Sanitized.run compiler ~runtime:tools.runtime ~folder:tools.folder subject.files recordings)

(* {1 Comparison} *)

let cells text =
  let next = ref 0 in
  let characters () =
    if !next = String.length text then None
    else (
      incr next;
      Some text.[!next - 1])
  in
  let csv = Interp.Csv.reader characters in
  let rec rows found =
    match Interp.Csv.next csv with
    | Ok (Some row) -> rows (List.map (fun (c : Interp.Csv.cell) -> c.text) row.cells :: found)
    | Ok None | Error _ -> List.rev found
  in
  rows []

let first_difference by recording ~c ~interpreted =
  let rec in_row row columns c interpreted =
    match (columns, c, interpreted) with
    | column :: columns, c :: cs, i :: is ->
        if String.equal c i then in_row row columns cs is
        else Some (Differ { by; row; column; c; interpreted = i; recording })
    | _, _, _ -> None
  in
  let rec in_rows row columns c interpreted =
    match (c, interpreted) with
    | c :: cs, i :: is -> (
        match in_row row columns c i with
        | Some difference -> difference
        | None -> in_rows (row + 1) columns cs is)
    | _, _ -> Failed "the traces differ, but no cell does"
  in
  match (cells c, cells interpreted) with
  | columns :: c, _ :: interpreted -> in_rows 0 columns c interpreted
  | _, _ -> Failed "a trace is empty"

(* Removes the columns of probes, which come last. *)
let without_probes trace =
  let is_probe name = String.starts_with ~prefix:"probe." name in
  let header = List.hd (String.split_on_char '\n' trace) in
  (* Labels of assertions may contain commas. *)
  let names = List.hd (cells header) in
  let plain = List.filter (fun name -> not (is_probe name)) names in
  let count = List.length plain in
  let kept = Buffer.create (String.length trace) in
  let column = ref 0 and is_quoted = ref false in
  String.iter
    (fun c ->
      (match c with
      | '\n' -> column := 0
      | '"' -> is_quoted := not !is_quoted
      | ',' when not !is_quoted -> incr column
      | _ -> ());
      if !column < count then Buffer.add_char kept c)
    trace;
  Buffer.contents kept

let judge tools engines subject recordings =
  let result =
    guarded @@ fun () ->
    (* Other engines read files, which contain times instead of dt. *)
    let possible engine recording = engine = Tcc || not (Recording.has_dt recording) in
    let expected = List.map (fun r -> (r, interpreted subject r)) recordings in
    let compare engine recording expected trace =
      let trace = if tools.probed then without_probes trace else trace in
      if String.equal trace expected then Ok ()
      else Error (first_difference engine recording ~c:trace ~interpreted:expected)
    in
    let by engine =
      let expected = List.filter (fun (r, _) -> possible engine r) expected in
      let* found = traces tools engine subject (List.map fst expected) in
      List.fold_left2
        (fun so_far (r, e) f -> Result.bind so_far (fun () -> compare engine r e f))
        (Ok ()) expected found
    in
    List.fold_left (fun so_far engine -> Result.bind so_far (fun () -> by engine)) (Ok ()) engines
  in
  match result with Ok () -> Agree | Error outcome -> outcome
