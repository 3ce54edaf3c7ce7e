(* Further than a person looks, and it keeps this linear. *)
let furthest = 16

(* [before] is what stands before, the nearest first. *)
let go_up statement before =
  let moved = Exchange.touched statement in
  let rec up n over = function
    | above :: rest when n > 0 && Exchange.may_exchange moved above -> up (n - 1) (above :: over) rest
    | before -> List.rev_append over (statement :: before)
  in
  up furthest [] before

let is_of_several (v : Ir.variable) (s : Ir.statement) =
  match s with
  | Declare { variable; value = Operation { operator = And | Or; _ } | Select _; _ } -> variable.id = v.id
  | _ -> false

let rec is_near n v = function
  | s :: rest -> n > 0 && (is_of_several v s || is_near (n - 1) v rest)
  | [] -> false

let statements body =
  let place before (s : Ir.statement) =
    match s with
    | If { condition = Variable v; uninitialized = []; _ }
      when Exchange.is_plain s && is_near furthest v before ->
        go_up s before
    | _ -> s :: before
  in
  List.rev (List.fold_left place [] body)
