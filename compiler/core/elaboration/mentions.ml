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
  (match e.desc with
  | Local (x, _) ->
      if not (Int_table.mem w.met x.id) then (
        Int_table.replace w.met x.id ();
        w.mentioned <- { local = x; ty = Erasure.ty e.ty } :: w.mentioned)
  | Run _ -> if not in_proc then w.own_runs <- true
  | _ -> ());
  List.iter (pattern w) (Typing.Walk.patterns e);
  let in_proc = in_proc || match e.desc with Proc _ -> true | _ -> false in
  Typing.Walk.parts (expr w ~in_proc) e

let of_expr e =
  let bound = Int_table.create 16 and met = Int_table.create 16 in
  let w = { bound; met; mentioned = []; own_runs = false } in
  expr w ~in_proc:false e;
  let is_free (b : Ir.binder) = not (Int_table.mem bound b.local.id) in
  { variables = List.rev (List.filter is_free w.mentioned); runs = w.own_runs }
