open Basis

(* By node that runs in a loop with accumulators: the variables of its step that come
   from them. *)
type t = unit Int_table.t option array

let mentions from e =
  let found = ref false in
  Walk.expression (function Variable v when Int_table.mem from v.id -> found := true | _ -> ()) e;
  !found

(* Everything is written before it is read, so once through the body is enough. *)
let follow from (node : Ir.node) =
  let add (v : Ir.variable) = Int_table.replace from v.id () in
  Walk.statements
    (fun (s : Ir.statement) ->
      match s with
      | Declare { variable; value; _ } | Assign { place = Local variable; value; _ } ->
          if mentions from value then add variable
      | If { uninitialized; condition; _ } -> if mentions from condition then List.iter add uninitialized
      | Step { results; _ } | Start { results; _ } | Loop { results; _ } | Run { results; _ } ->
          List.iter add results
      | Assign { place = Own _ | Result _; _ } | Reset _ | Enter _ | Begin _ | Await _ | Return _ -> ())
    node.step.body

let of_program (program : Ir.program) =
  let rounds = Array.make (Array.length program.nodes) None in
  let enter node parameters =
    let from = Option.value rounds.(node) ~default:(Int_table.create 8) in
    List.iter (fun (p : Ir.variable) -> Int_table.replace from p.id ()) parameters;
    rounds.(node) <- Some from
  in
  let parameters node is_from arguments =
    List.map fst
      (List.filter
         (fun (_, argument) -> is_from argument)
         (List.combine program.nodes.(node).step.parameters arguments))
  in
  let is_accumulator : Ir.argument -> bool = function
    | Accumulated _ -> true
    | Each _ | Same _ | Counted _ -> false
  in
  let loop (s : Ir.statement) =
    match s with
    | Loop { node; arguments; initial = _ :: _; _ } ->
        enter node (parameters node is_accumulator arguments)
    | _ -> ()
  in
  let call from node arguments = enter node (parameters node (mentions from) arguments) in
  let calls from (node : Ir.node) =
    Walk.expressions
      (function Call { node; arguments } -> call from node arguments | _ -> ())
      node.step.body;
    Walk.statements
      (function Step { node; arguments; _ } -> call from node arguments | _ -> ())
      node.step.body
  in
  Array.iter (fun (node : Ir.node) -> Walk.statements loop node.step.body) program.nodes;
  (* Callers come after callees. *)
  for k = Array.length program.nodes - 1 downto 0 do
    Option.iter
      (fun from ->
        follow from program.nodes.(k);
        calls from program.nodes.(k))
      rounds.(k)
  done;
  rounds

let is_own rounds k e =
  match rounds.(k) with Some from -> not (mentions from e) | None -> false
