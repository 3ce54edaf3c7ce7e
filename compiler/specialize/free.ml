open Basis
module Set = Variables.Set
module Table = Variables.Table
module Ir = Core.Ir

type table = { free : Set.t Table.t; used : unit Table.t }

let table () = { free = Table.create 256; used = Table.create 256 }

(* What stays free around a parameter, having noted whether it is used. *)
let bind table (binder : Ir.binder) body =
  let id = binder.local.id in
  if Set.mem id body then Table.replace table.used id ();
  let free = Set.remove id body in
  Table.replace table.free id free;
  free

let rec free table (e : Ir.expr) =
  match e.desc with
  | Local local -> Set.singleton local.id
  | Global _ | Primitive _ | Method _ | Number _ | Boolean _ | String _ -> Set.empty
  | Lambda (binder, body) -> bind table binder (free table body)
  | Apply (f, argument) -> Set.union (free table f) (free table argument)
  | Let { binder; value; body } ->
      let in_value = free table value in
      Set.union in_value (Set.remove binder.local.id (free table body))
  | Tuple parts | Array parts | Construct { arguments = parts; _ } ->
      List.fold_left (fun set part -> Set.union set (free table part)) Set.empty parts
  | Component (e, _) | Index (e, _) | Is_constructor (e, _) | Payload { value = e; _ } -> free table e
  | If (condition, then_, else_) ->
      Set.union (free table condition) (Set.union (free table then_) (free table else_))
  | Proc proc -> free_of_proc table proc

and free_of_proc table (proc : Ir.proc) =
  let of_equation (eq : Ir.equation) =
    match eq.rhs with
    | Pure e -> free table e
    | Run { signal_function; input } -> Set.union (free table signal_function) (free table input)
  in
  let all =
    List.fold_left
      (fun set eq -> Set.union set (of_equation eq))
      (free table proc.output) proc.equations
  in
  let unbound =
    List.fold_left
      (fun set (eq : Ir.equation) -> Set.remove eq.binder.local.id set)
      all proc.equations
  in
  bind table proc.input unbound

let expr table e = ignore (free table e)

let of_code table id =
  match Table.find_opt table.free id with
  | Some set -> set
  | None -> Diagnostic.bug ~stage:"Specialize.Free" "no code is named by %d" id

let uses_binder table id = Table.mem table.used id
