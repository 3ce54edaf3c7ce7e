open Basis
open Ir

let rec globals found (e : expr) =
  match e.desc with Global (g, _) -> g :: found | _ -> List.fold_left globals found (Term.parts e)

let definitions list =
  let all = Array.of_list list in
  let index = Resolve.Global_table.create (Array.length all) in
  Array.iteri (fun i (d : definition) -> Resolve.Global_table.replace index d.name i) all;
  let uses (d : definition) =
    List.filter_map (fun g -> Resolve.Global_table.find_opt index g) (globals [] d.body)
  in
  let components = Graph.components (Array.map uses all) in
  let add reversed component =
    List.fold_left
      (fun reversed i -> all.(i) :: reversed)
      reversed (List.sort Int.compare component)
  in
  List.rev (List.fold_left add [] components)
