type robot = { input : Ir.Global.t; output : Ir.Global.t }
type lack = { class_ : Ir.Global.t; of_ : Ir.Global.t; need : Ir.need }

let ends (d : Ir.definition) =
  match d.scheme.ty with
  | Data { tycon; arguments = [ input; output ]; _ }
    when tycon = Environment.built_in "Program" ->
      Some (input, output)
  | _ -> None

let is_open (d : Ir.definition) =
  match ends d with
  | Some _ -> d.scheme.types <> []
  | None -> false

(* The variable, if it is one, and the type that it has to be. *)
let matches (t : Ir.ty) tycon =
  match t with
  | Variable v -> Some [ (v.id, tycon) ]
  | Data { tycon = t; _ } when t = tycon -> Some []
  | _ -> None

let has_instance (program : Ir.program) class_ tycon =
  List.exists
    (fun (i : Ir.instance) ->
      i.class_ = class_ && match i.head with Data { tycon = t; _ } -> t = tycon | _ -> false)
    program.instances

let lacks (program : Ir.program) (d : Ir.definition) robot =
  match ends d with
  | None -> None
  | Some (input, output) -> (
      match (matches input robot.input, matches output robot.output) with
      | Some inputs, Some outputs
        when not (robot.input <> robot.output && input = output) ->
          let types = inputs @ outputs in
          let lack ((class_ : Ir.class_), (t : Ir.ty)) need =
            match (class_, t) with
            | Declared class_, Variable v -> (
                match List.assoc_opt v.id types with
                | Some of_ when not (has_instance program class_ of_) -> Some { class_; of_; need }
                | Some _ | None -> None)
            | _ -> None
          in
          Some (List.filter_map Fun.id (List.map2 lack d.scheme.context d.needs))
      | _ -> None)
