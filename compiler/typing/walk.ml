open Ir

let parts visit (e : expr) =
  let bindings = List.iter (fun (b : binding) -> visit b.value) in
  let fields = List.iter (fun (_, e) -> visit e) in
  match e.desc with
  | Local _ | Global _ | Primitive _ | Method _ | Constructor _ | Number _ | String _ -> ()
  | Tuple es | Array es -> List.iter visit es
  | Apply (a, b) | Run (a, b) ->
      visit a;
      visit b
  | Negate a | Power (a, _) | Field (a, _, _) | Index (a, _) | Lambda (_, a) -> visit a
  | If (a, b, c) -> List.iter visit [ a; b; c ]
  | Case (scrutinee, branches) ->
      visit scrutinee;
      List.iter (fun (b : branch) -> visit b.value) branches
  | Let (bs, body) ->
      bindings bs;
      visit body
  | Guards (guarded, last) ->
      List.iter
        (fun (condition, value) ->
          visit condition;
          visit value)
        guarded;
      Option.iter visit last
  | Proc { input = _; equations; output } ->
      bindings equations;
      visit output
  | Record (_, fs) -> fields fs
  | Update (record, _, fs) ->
      visit record;
      fields fs

let own resolved visit (program : program) =
  let modules = Resolve.Walk.own_modules resolved in
  let is_own (d : definition) =
    List.exists (fun (m : Resolve.Ir.module_) -> String.equal m.name d.name.module_) modules
  in
  List.iter (fun d -> if is_own d then visit d.value) program.definitions
