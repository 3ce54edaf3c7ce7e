open Basis
module T = Typing.Ir

type t = { variables : Ir.binder list; runs : bool }

type walk = {
  bound : unit Int_table.t;
  met : unit Int_table.t;
  mutable mentioned : Ir.binder list; (* newest first *)
  mutable own_runs : bool;
}

let pattern w p =
  List.iter (fun (x : Ir.Local.t) -> Int_table.replace w.bound x.id ()) (Typing.Parts.variables p)

let rec expr w ~in_proc (e : T.expr) =
  let visit = expr w ~in_proc in
  match e.desc with
  | Local (x, _) ->
      if not (Int_table.mem w.met x.id) then (
        Int_table.replace w.met x.id ();
        w.mentioned <- { local = x; ty = Erasure.ty e.ty } :: w.mentioned)
  | Global _ | Primitive _ | Method _ | Constructor _ | Number _ | String _ -> ()
  | Run (f, x) ->
      if not in_proc then w.own_runs <- true;
      visit f;
      visit x
  | Apply (f, x) ->
      visit f;
      visit x
  | Tuple es | Array es -> List.iter visit es
  | Negate e | Power (e, _) | Field (e, _, _) | Index (e, _) -> visit e
  | If (a, b, c) -> List.iter visit [ a; b; c ]
  | Case (scrutinee, branches) ->
      visit scrutinee;
      let branch (b : T.branch) =
        pattern w b.pattern;
        visit b.value
      in
      List.iter branch branches
  | Let (bindings, body) ->
      List.iter (binding w ~in_proc) bindings;
      visit body
  | Lambda (patterns, body) ->
      List.iter (pattern w) patterns;
      visit body
  | Guards (guarded, last) ->
      List.iter (fun (guard, value) -> List.iter visit [ guard; value ]) guarded;
      Option.iter visit last
  | Proc { input; equations; output } ->
      pattern w input;
      List.iter (binding w ~in_proc:true) equations;
      expr w ~in_proc:true output
  | Record (_, fields) -> List.iter (fun (_, e) -> visit e) fields
  | Update (record, _, fields) ->
      visit record;
      List.iter (fun (_, e) -> visit e) fields

and binding w ~in_proc (b : T.binding) =
  pattern w b.pattern;
  expr w ~in_proc b.value

let of_expr e =
  let bound = Int_table.create 16 and met = Int_table.create 16 in
  let w = { bound; met; mentioned = []; own_runs = false } in
  expr w ~in_proc:false e;
  let is_free (b : Ir.binder) = not (Int_table.mem bound b.local.id) in
  { variables = List.rev (List.filter is_free w.mentioned); runs = w.own_runs }
