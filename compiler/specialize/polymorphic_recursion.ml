open Basis
module Ir = Core.Ir

let rec is_open : Ir.ty -> bool = function
  | Variable _ -> true
  | Bool | Int | Float | String | Size _ -> false
  | Tuple parts | Data (_, parts) -> List.exists is_open parts
  | Function (a, b) | Signal_function (a, b) | Array (a, b) -> is_open a || is_open b

(* With the variables of the definition in it, but larger than one. *)
let grows : Ir.ty -> bool = function
  | Variable _ -> false
  | ty -> is_open ty

let report sink (d : Ir.definition) name types ~at =
  let ty = List.find grows types in
  Diagnostic.error ~code:"E0417" ~at "`%s` starts itself again at a larger type" name
  |> Diagnostic.here (Printf.sprintf "here a type variable of it becomes `%s`" (Types.to_string ty))
  |> Diagnostic.label ~at:d.span (Printf.sprintf "`%s` is defined here" d.name.name)
  |> Diagnostic.hint "start it again at the same types"
  |> Diagnostic.emit sink

let check sink (program : Ir.program) =
  let definitions = Array.of_list program.definitions in
  let index = Hashtbl.create (Array.length definitions) in
  Array.iteri (fun i (d : Ir.definition) -> Hashtbl.replace index d.name i) definitions;
  let uses =
    Array.map
      (fun (d : Ir.definition) ->
        List.filter_map
          (fun (target, at) ->
            match (target : Uses.target) with
            | Definition (g, types) ->
                Option.map (fun i -> (i, g, types, at)) (Hashtbl.find_opt index g)
            | Method _ -> None)
          (Uses.of_expr ~continuations:true d.body))
      definitions
  in
  let graph = Array.map (List.map (fun (i, _, _, _) -> i)) uses in
  let components = Graph.components graph in
  let component = Array.make (Array.length definitions) 0 in
  List.iteri (fun k vertices -> List.iter (fun v -> component.(v) <- k) vertices) components;
  Array.iteri
    (fun i own ->
      match
        List.find_opt
          (fun (j, _, types, _) -> component.(j) = component.(i) && List.exists grows types)
          own
      with
      | Some (_, (g : Ir.Global.t), types, at) -> report sink definitions.(i) g.name types ~at
      | None -> ())
    uses
