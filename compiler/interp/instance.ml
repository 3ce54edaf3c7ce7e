open Core.Ir

type table = (Global.t, instance) Hashtbl.t

let table instances =
  let table = Hashtbl.create 64 in
  List.iter (fun (i : instance) -> Hashtbl.add table i.class_ i) instances;
  table

(* If this is the instance for [ty], returns the types of the head's variables, in order. *)
let matches (head : ty) (ty : ty) =
  match (head, ty) with
  | Data (tycon, _), Data (other, arguments) when tycon = other -> Some arguments
  | Tuple variables, Tuple parts when List.compare_lengths variables parts = 0 -> Some parts
  | Function _, Function (a, b) | Signal_function _, Signal_function (a, b) -> Some [ a; b ]
  | Bool, Bool | Int, Int | Float, Float | String, String -> Some []
  | Array _, Array (size, element) -> Some [ size; element ]
  | ( ( Variable _ | Bool | Int | Float | String | Tuple _ | Function _ | Signal_function _ | Data _
      | Array _ | Size _ ),
      _ ) ->
      None

let method_ table ~class_ ~name ty =
  let of_instance i =
    match (matches i.head ty, List.assoc_opt name i.methods) with
    | Some arguments, Some (Given definition) -> Some (definition, arguments)
    | Some _, Some (Default definition) -> Some (definition, [ ty ])
    | None, _ | _, None -> None
  in
  List.find_map of_instance (Hashtbl.find_all table class_)
