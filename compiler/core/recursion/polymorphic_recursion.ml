open Basis
module Global_table = Resolve.Global_table

let rec is_open : Ir.ty -> bool = function
  | Variable _ -> true
  | Bool | Int | Float | String | Size _ -> false
  | Tuple parts | Data (_, parts) -> List.exists is_open parts
  | Function (a, b) | Signal_function (a, b) | Array (a, b) -> is_open a || is_open b

(* Does the type properly contain a type variable of the definition? *)
let grows : Ir.ty -> bool = function Variable _ -> false | ty -> is_open ty

(* The uses on a shortest path from the definition [from] to [target]. *)
let way uses from target =
  let reached = Hashtbl.create 16 in
  let rec back v found =
    match Hashtbl.find_opt reached v with
    | Some (Some (u, use)) -> back u ((u, use) :: found)
    | Some None | None -> found
  in
  let rec search = function
    | [] -> []
    | v :: _ when v = target -> back v []
    | v :: others ->
        let next =
          List.filter
            (fun (use : Fact.use) ->
              let is_new = not (Hashtbl.mem reached use.index) in
              if is_new then Hashtbl.replace reached use.index (Some (v, use));
              is_new)
            uses.(v)
        in
        search (others @ List.map (fun (use : Fact.use) -> use.index) next)
  in
  Hashtbl.replace reached from None;
  search [ from ]

let fact (definitions : Ir.definition array) uses i (use : Fact.use) : Fact.t =
  let way = List.map (fun (v, use) -> (definitions.(v), use)) (way uses use.index i) in
  Larger_type { definition = definitions.(i); use; ty = List.find grows use.types; way }

let facts { Uses.definitions; index; uses } =
  let use ({ target; span; later = _ } : Uses.use) =
    match target with
    | Definition (by, types) ->
        let use index : Fact.use = { index; by; types; at = span } in
        Option.map use (Global_table.find_opt index by)
    | Method _ -> None
  in
  let uses = Array.map (List.filter_map use) uses in
  let graph = Array.map (List.map (fun (use : Fact.use) -> use.index)) uses in
  let components = Graph.components graph in
  let component = Array.make (Array.length definitions) 0 in
  List.iteri (fun k vertices -> List.iter (fun v -> component.(v) <- k) vertices) components;
  let fact i own =
    List.find_opt
      (fun (use : Fact.use) -> component.(use.index) = component.(i) && List.exists grows use.types)
      own
    |> Option.map (fact definitions uses i)
  in
  List.filter_map Fun.id (Array.to_list (Array.mapi fact uses))
