type robot = { input : Ir.Global.t; output : Ir.Global.t }
type openness = Closed | Open_signal_function | Open_program
type lack = { class_ : Ir.Global.t; of_ : Ir.Global.t; need : Ir.need }

let ends (d : Ir.definition) =
  match d.scheme.ty with
  | Data { tycon; arguments = [ input; output ]; _ } when tycon = Environment.built_in "Program" ->
      Some (input, output)
  | Signal_function (input, output) -> Some (input, output)
  | _ -> None

let openness (d : Ir.definition) =
  match (d.scheme.types, d.scheme.ty, ends d) with
  | [], _, _ | _, _, None -> Closed
  | _ :: _, Signal_function _, Some _ -> Open_signal_function
  | _ :: _, _, Some _ -> Open_program

let rec is_closed (t : Ir.ty) =
  match t with
  | Variable _ | Number (Representation_variable _, _) -> false
  | Number _ | Bool | String | Size _ -> true
  | Tuple parts -> List.for_all is_closed parts
  | Function (a, b) | Signal_function (a, b) -> is_closed a && is_closed b
  | Data { arguments; _ } -> List.for_all is_closed arguments

let is_anybodys (t : Ir.ty) others =
  match t with Data { tycon; _ } -> List.mem tycon others | _ -> false

(* The substitution that makes the type equal to the robot's; empty if they are equal. A plain
   signal function may also have a closed type that is not the type of any robot. *)
let matches ~program ~others (t : Ir.ty) tycon =
  match t with
  | Variable v -> Some [ (v.id, tycon) ]
  | Data { tycon = t; _ } when t = tycon -> Some []
  | t when (not program) && is_closed t && not (is_anybodys t others) -> Some []
  | _ -> None

let has_instance (program : Ir.program) class_ tycon =
  List.exists
    (fun (i : Ir.instance) ->
      i.class_ = class_ && match i.head with Data { tycon = t; _ } -> t = tycon | _ -> false)
    program.instances

let lacks (program : Ir.program) (d : Ir.definition) ~others robot =
  match ends d with
  | None -> None
  | Some (input, output) -> (
      let matches =
        let program = match d.scheme.ty with Signal_function _ -> false | _ -> true in
        matches ~program ~others
      in
      match (matches input robot.input, matches output robot.output) with
      | Some [], Some [] -> None
      | Some inputs, Some outputs when not (robot.input <> robot.output && input = output) ->
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
