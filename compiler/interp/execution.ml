open Core.Ir

type t = { instance : Value.instance; ended : ty option; mutable is_first : bool }

let bug format = Basis.Diagnostic.bug ~stage:"Interp" format

let interface (core : program) (entry : Global.t) =
  match List.find_opt (fun (d : definition) -> d.name = entry) core.definitions with
  | Some { ty = Signal_function (input, output); parameters = []; _ }
  | Some { ty = Data ({ name = "Program"; _ }, [ input; output ]); parameters = []; _ } ->
      (input, output)
  | Some _ | None -> bug "`%s` cannot be run" entry.name

let start ?(params = []) core ~entry =
  let params = List.map (fun (name, value) -> (name, Thunk.known value)) params in
  let definition = Evaluate.definition (Evaluate.program ~params core) entry in
  let started ended (value : Value.t) =
    match value with
    | Signal_function start -> { instance = start (); ended; is_first = true }
    | _ -> bug "`%s` is not a signal function" entry.name
  in
  match Thunk.demand definition with
  | Signal_function _ as signal_function -> started None signal_function
  | Ending { signal_function; result } -> started (Some result) (Thunk.demand signal_function)
  | Bool _ | Int _ | Float _ | Text _ | Drawing _ | Image _ | Tuple _ | Array _ | Data _
  | Function _ | Task _ ->
      bug "`%s` is not a signal function" entry.name

let ended t = t.ended

let instant ?(precision = Basis.Real.Double) t ~seconds input =
  let clock = if t.is_first then Clock.first else Clock.after precision seconds in
  t.is_first <- false;
  let output = t.instance.output clock (Thunk.known input) in
  Whole.evaluate output;
  t.instance.commit ();
  Thunk.demand output
