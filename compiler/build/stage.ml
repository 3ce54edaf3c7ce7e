type t = Parse | Resolve | Types | Core | Specialize | Passes | Flow | Step | C

let table =
  [
    (Parse, "parse", "the module after parsing");
    (Resolve, "resolve", "all modules, with each name linked to its declaration");
    (Types, "types", "all modules with types and levels");
    (Core, "core", "the small language that defines what the program means");
    (Specialize, "specialize", "first-order nodes of equations");
    (Passes, "passes", "flow and step after each pass that changes them");
    (Flow, "flow", "the nodes after all passes");
    (Step, "step", "state, reset and step as statements");
    (C, "c", "the generated C");
  ]

let all = List.map (fun (t, _, _) -> t) table
let row t = List.find (fun (other, _, _) -> other = t) table

let name t =
  let _, name, _ = row t in
  name

let meaning t =
  let _, _, meaning = row t in
  meaning

let of_name text =
  List.find_map (fun (t, name, _) -> if String.equal name text then Some t else None) table
