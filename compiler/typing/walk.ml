open Basis
open Ir

let children (e : expr) =
  let fields = Long_list.map snd in
  match e.desc with
  | Local _ | Global _ | Primitive _ | Method _ | Constructor _ | Number _ | String _ -> []
  | Tuple es | Array es -> es
  | Apply (a, b) | Run (a, b) -> [ a; b ]
  | Negate a | Power (a, _) | Field (a, _, _) | Index (a, _) | Lambda (_, a) -> [ a ]
  | If (a, b, c) -> [ a; b; c ]
  | Case (scrutinee, branches) -> scrutinee :: List.map (fun (b : branch) -> b.value) branches
  | Let (bindings, body) | Proc { input = _; equations = bindings; output = body } ->
      List.rev_append (List.rev_map (fun (b : binding) -> b.value) bindings) [ body ]
  | Guards (guarded, last) ->
      List.concat_map (fun (guard, value) -> [ guard; value ]) guarded @ Option.to_list last
  | Record (_, all) -> fields all
  | Update (record, _, all) -> record :: fields all

let parts visit e = List.iter visit (children e)

let patterns (e : expr) =
  let bound = Long_list.map (fun (b : binding) -> b.pattern) in
  match e.desc with
  | Lambda (parameters, _) -> parameters
  | Case (_, branches) -> List.map (fun (b : branch) -> b.pattern) branches
  | Let (bindings, _) -> bound bindings
  | Proc { input; equations; output = _ } -> input :: bound equations
  | _ -> []

let own resolved visit (program : program) =
  let modules = Resolve.Walk.own_modules resolved in
  let is_own (d : definition) =
    List.exists (fun (m : Resolve.Ir.module_) -> String.equal m.name d.name.module_) modules
  in
  List.iter (fun d -> if is_own d then visit d.value) program.definitions
