open Basis

(* The unit of a knob, from the type of the expression that reads it. [None] if the type does not
   determine the unit, as in a function that is polymorphic in its unit. *)
let unit_of (typed : Typing.Ir.program) (place : Span.t) =
  let found = ref None in
  let rec look (e : Typing.Ir.expr) =
    (match e.ty with
    | Number (_, { variables = []; _ }) when e.span = place && !found = None ->
        found := Some (Option.value (Probe.Signal_types.unit_ e.ty) ~default:"")
    | _ -> ());
    Typing.Walk.parts look e
  in
  List.iter (fun (d : Typing.Ir.definition) -> look d.value) typed.definitions;
  !found

let unit_of_control typed (c : Core.Ir.control) =
  match c.kind with
  | Knob _ -> unit_of typed c.span
  | Button | Hold | Toggle _ | Map | Camera | Tags | Lidar _ | Imu -> None

let in_unit unit_ = if String.equal unit_ "" then "without a unit" else "in " ^ unit_

let refuse sink ~first ~first_unit (c : Core.Ir.control) unit_ =
  Diagnostic.error ~code:"E0442" ~at:c.span
    "the console already has another control with the label `%s`" c.label
  |> Diagnostic.here "%s" (Core.Console.describe c.kind ^ ", " ^ in_unit unit_)
  |> Diagnostic.label ~at:first "%s" (Core.Console.describe c.kind ^ ", " ^ in_unit first_unit)
  |> Diagnostic.hint "rename one of them"
  |> Diagnostic.emit sink

(* Keeps the first of several controls with the same label, and gives it the first unit that is
   known for any of them. *)
let once sink typed controls =
  let merge known (c : Core.Ir.control) =
    let unit_ = unit_of_control typed c in
    let is_same ((other : Core.Ir.control), _) = String.equal other.label c.label in
    match (List.find_opt is_same known, unit_) with
    | None, _ -> (c, unit_) :: known
    | Some (_, None), Some _ ->
        List.map (fun (k, u) -> if is_same (k, u) then (k, unit_) else (k, u)) known
    | Some (first, Some first_unit), Some unit_ when not (String.equal first_unit unit_) ->
        refuse sink ~first:first.span ~first_unit c unit_;
        known
    | Some _, _ -> known
  in
  List.rev_map
    (fun ((c : Core.Ir.control), unit_) -> { c with unit_ = Option.value unit_ ~default:"" })
    (List.fold_left merge [] controls)

let declared options sink typed ~name ~entry core =
  Option.bind
    (Specialize.Of_core.controls options (Advice.Of_specialize.into sink) ~name ~entry core)
    (fun controls ->
      let controls = once sink typed controls in
      if Diagnostic.has_errors sink then None else Some (Core.Console.declare controls core))
