(* The place where the programmer wrote the code of a mode. *)
let rec place ~otherwise (value : Value.t) =
  match value with
  | Primitive { arguments; _ } -> (
      match List.rev arguments with first :: _ -> place ~otherwise first.value | [] -> otherwise)
  | Function { code = Lambda (_, body); _ } -> body.span
  | Function closure | Signal_function closure -> closure.span
  | Choice { then_; _ } -> place ~otherwise then_
  | Atom _ | Text _ | Product _ | Constructed _ | Array _ | Elements _ | Program _ | Unspecified ->
      otherwise

let name (value : Value.t) =
  match value with
  | Primitive { primitive = Run_task; arguments = [ { value = Primitive { owner; _ }; _ } ]; _ } ->
      owner
  | Primitive { owner; _ } -> owner
  | Signal_function closure -> closure.name
  | Choice _ -> "choice"
  | Atom _ | Text _ | Product _ | Constructed _ | Array _ | Elements _ | Function _ | Program _
  | Unspecified ->
      "mode"

let mode_name (value : Value.t) =
  match value with
  | Primitive { primitive = Run_task; arguments = [ task ]; _ } -> Task.name task.value
  | _ -> name value

let mode_place ~otherwise (value : Value.t) =
  match value with
  | Primitive { primitive = Run_task; arguments = [ task ]; _ } -> Task.place task.value
  | _ -> place ~otherwise value
