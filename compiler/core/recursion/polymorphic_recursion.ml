open Basis
module Global_table = Resolve.Global_table

let rec is_open : Ir.ty -> bool = function
  | Variable _ -> true
  | Bool | Int | Float | String | Size _ -> false
  | Tuple parts | Data (_, parts) -> List.exists is_open parts
  | Function (a, b) | Signal_function (a, b) | Array (a, b) -> is_open a || is_open b

(* Does the type contain a variable of the definition, without being just that variable? *)
let grows : Ir.ty -> bool = function Variable _ -> false | ty -> is_open ty

type use = { index : int; by : Ir.Global.t; types : Ir.ty list; at : Span.t }

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
            (fun use ->
              let is_new = not (Hashtbl.mem reached use.index) in
              if is_new then Hashtbl.replace reached use.index (Some (v, use));
              is_new)
            uses.(v)
        in
        search (others @ List.map (fun use -> use.index) next)
  in
  Hashtbl.replace reached from None;
  search [ from ]

let report sink (definitions : Ir.definition array) uses i { index; by; types; at } =
  let d = definitions.(i) in
  let label diagnostic (v, use) =
    Diagnostic.label ~at:use.at
      (Printf.sprintf "`%s` starts `%s` here" definitions.(v).name.name use.by.name)
      diagnostic
  in
  let ty = List.find grows types in
  Diagnostic.error ~code:"E0417" ~at "`%s` restarts itself at a larger type" by.name
  |> Diagnostic.here (Printf.sprintf "here its type variable becomes `%s`" (Print.type_name ty))
  |> (fun diagnostic ->
  match way uses index i with
  | [] ->
      let text = Printf.sprintf "`%s` is defined here" d.name.name in
      Diagnostic.label ~at:d.span text diagnostic
  | way -> List.fold_left label diagnostic way)
  |> Diagnostic.hint "restart it with the same types"
  |> Diagnostic.emit sink

let check sink { Uses.definitions; index; uses } =
  let use ({ target; span; later = _ } : Uses.use) =
    match target with
    | Definition (by, types) ->
        let use index = { index; by; types; at = span } in
        Option.map use (Global_table.find_opt index by)
    | Method _ -> None
  in
  let uses = Array.map (List.filter_map use) uses in
  let graph = Array.map (List.map (fun use -> use.index)) uses in
  let components = Graph.components graph in
  let component = Array.make (Array.length definitions) 0 in
  List.iteri (fun k vertices -> List.iter (fun v -> component.(v) <- k) vertices) components;
  Array.iteri
    (fun i own ->
      match
        List.find_opt
          (fun use -> component.(use.index) = component.(i) && List.exists grows use.types)
          own
      with
      | Some use -> report sink definitions uses i use
      | None -> ())
    uses
