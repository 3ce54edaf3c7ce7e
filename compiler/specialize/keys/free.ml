open Basis
module Set = Variables.Set
module Table = Variables.Table
module Ir = Core.Ir

type table = { free : Set.t Table.t; used : unit Table.t; mutable size : int }

let table () = { free = Table.create 256; used = Table.create 256; size = 0 }

(* The free variables of a function, given its parameter and the free variables of its body. Records
   whether the parameter is used. *)
let bind table (binder : Ir.binder) body =
  let id = binder.local.id in
  if Set.mem id body then Table.replace table.used id ();
  let free = Set.remove id body in
  Table.replace table.free id free;
  free

(* In Core, a record update reads every field that it does not change, although the source text does
   not mention these fields. The work limit grows with the source text, so reading a field of a
   variable does not count. *)
let rec free table (e : Ir.expr) =
  match e.desc with
  | Payload { value = { desc = Local local; _ }; _ } -> Set.singleton local.id
  | _ ->
      table.size <- table.size + 1;
      free_of_other table e

and free_of_other table (e : Ir.expr) =
  match e.desc with
  | Local local -> Set.singleton local.id
  | Lambda (binder, body) -> bind table binder (free table body)
  | Let { binder; value; body } ->
      Set.union (free table value) (Set.remove binder.local.id (free table body))
  | Proc { input; equations; output = _ } ->
      let remove set (eq : Ir.equation) = Set.remove eq.binder.local.id set in
      bind table input (List.fold_left remove (of_parts table e) equations)
  | _ -> of_parts table e

and of_parts table e =
  List.fold_left (fun set part -> Set.union set (free table part)) Set.empty (Core.Term.parts e)

let expr table e = ignore (free table e)
let size table = table.size

let of_code table id =
  match Table.find_opt table.free id with
  | Some set -> set
  | None -> Diagnostic.bug ~stage:"Specialize.Free" "there is no code with the id %d" id

let uses_binder table id = Table.mem table.used id
