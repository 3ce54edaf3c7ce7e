open Context

(* Is this a type without capabilities, used by mistake in place of a robot's input or output type?
   *)
let is_no_robot t =
  Environment.is_task t
  ||
  match Type.expand t with
  | Function _ | Signal_function _ | Tuple _ | Number _ | Bool | String -> true
  | Data { tycon; _ } ->
      List.exists
        (fun name -> tycon = Environment.built_in name)
        [ "Event"; "Maybe"; "Either"; "Array" ]
  | Flexible _ | Rigid _ | Size _ | Erroneous | Alias _ -> false

(* Is this a comparison of tuples that contain a function, as in `max(0, min(a, b))`? The arguments
   have already been reported. *)
let follows_from_a_tuple ctx (required : required) (lack : Instance_fact.lack) =
  let is_function_type t = match Type.expand t with Function _ -> true | _ -> false in
  let rec holds_a_function t =
    match Type.expand t with
    | Tuple parts -> List.exists (fun t -> is_function_type t || holds_a_function t) parts
    | _ -> false
  in
  errors ctx > 0 && (lack.lacking = Eq || lack.lacking = Ord) && holds_a_function required.argument

(* Is this an output in place of a time, as when the arguments of `sleepT` are swapped? That mistake
   has already been reported. *)
let follows_from_an_order ctx (required : required) (lack : Instance_fact.lack) =
  errors ctx > 0
  &&
  match (lack.lacking, Type.expand lack.culprit) with
  | Declared { name = "RobotOutput" | "DiffDrive"; _ }, Number _ -> required.by = Name "roMake"
  | _ -> false

let report ctx (required : required) (lack : Instance_fact.lack) =
  if not (follows_from_a_tuple ctx required lack || follows_from_an_order ctx required lack) then
    match (lack.lacking, lack.through) with
    | Declared class_, [] when class_ = Environment.built_in "Claim" && required.by = Name "verdict"
      ->
        tell_of_instance ctx (Not_a_condition { at = required.at; ty = lack.culprit })
    | _ -> tell_of_instance ctx (No_instance { required; lack })

(* {1 Promises} *)

let owner ctx (missing : Instance_fact.promise) = Hashtbl.find_opt ctx.owners missing.variable.id

let same_signature ctx a b =
  match (owner ctx a, owner ctx b) with
  | Some (a : Surroundings.owned), Some b -> Basis.Span.compare a.place b.place = 0
  | None, None -> true
  | Some _, None | None, Some _ -> false

(* Lists each missing class of a variable once, with the first use that needs it. Omits classes that
   other missing classes imply. *)
let essential ctx (missing : Instance_fact.promise list) =
  let implies (a : Instance_fact.promise) (b : Instance_fact.promise) =
    a.variable.id = b.variable.id
    && List.mem b.class_ (Environment.superclasses ctx.reader.environment a.class_)
  in
  let same (a : Instance_fact.promise) (b : Instance_fact.promise) =
    a.variable.id = b.variable.id && a.class_ = b.class_
  in
  let first kept m = if List.exists (same m) kept then kept else m :: kept in
  List.rev (List.fold_left first [] missing)
  |> List.filter (fun m -> not (List.exists (fun other -> implies other m) missing))

let rec report_unpromised ctx = function
  | [] -> ()
  | m :: _ as missing ->
      let here, elsewhere = List.partition (same_signature ctx m) missing in
      (match essential ctx here with
      | [] -> ()
      | first :: others -> tell_of_instance ctx (Unpromised { first; others }));
      report_unpromised ctx elsewhere
