open Basis

type which = Least | Largest

let is (s : Ir.signal) (atom : Ir.atom) =
  match atom with Signal other -> other.id = s.id | Bool _ | Int _ | Float _ -> false

let definition (node : Ir.node) (atom : Ir.atom) =
  match atom with
  | Signal s -> List.find_opt (fun (e : Ir.equation) -> e.defines.id = s.id) node.equations
  | Bool _ | Int _ | Float _ -> None

(* How a loop's node compares: [if not (ordered) && x == x then x else best]. *)
type comparison = {
  which : which;
  x : Ir.signal;
  alone : Ir.signal list;  (** signals between the accumulator and the result *)
  condition : Ir.signal;
}

let comparison (node : Ir.node) ~best result =
  let ( let* ) = Option.bind in
  let* chosen = definition node result in
  match chosen.rhs with
  | If { condition; then_ = Signal x; else_ } when is best else_ -> (
      let* both = definition node condition in
      match both.rhs with
      | Op (And, [ comes_first; is_number ]) -> (
          let* number = definition node is_number in
          let* negated = definition node comes_first in
          match (number.rhs, negated.rhs) with
          | Op (Equal, [ a; b ]), Op (Not, [ ordered ]) when is x a && is x b -> (
              let* order = definition node ordered in
              let found which =
                let alone = [ order.defines; negated.defines; both.defines; chosen.defines ] in
                Some { which; x; alone; condition = both.defines }
              in
              match order.rhs with
              | Op (Less_equal, [ a; b ]) when is best a && is x b -> found Least
              | Op (Less_equal, [ a; b ]) when is x a && is best b -> found Largest
              | _ -> None)
          | _, _ -> None)
      | _ -> None)
  | _ -> None

(* Of equations that read the signal: do they give the same for NaN and for the infinity that
   any number is before? *)
let takes_infinity which signal (e : Ir.equation) =
  match (which, e.rhs) with
  | Least, Op (Less, [ a; _ ]) -> is signal a
  | Largest, Op (Less, [ _; b ]) -> is signal b
  | Least, Op (Less_equal, [ a; Float limit ]) -> is signal a && limit < infinity
  | Largest, Op (Less_equal, [ Float limit; b ]) -> is signal b && limit > neg_infinity
  | _, Op (Equal, ([ a; Float limit ] | [ Float limit; a ])) ->
      is signal a && Float.abs limit < infinity
  | _, _ -> false

(* The numbers of times that a node reads a signal. *)
type reader = { node : Ir.node; uses : Ir.signal -> int }

let reader (node : Ir.node) = { node; uses = Uses.of_signals node }

let may_be_infinity which caller (result : Ir.signal) =
  let same = List.filter (takes_infinity which result) caller.node.equations in
  let reads =
    List.fold_left
      (fun n (e : Ir.equation) -> n + List.length (List.filter (is result) (Operands.all e.rhs)))
      0 same
  in
  reads > 0 && caller.uses result = reads

(* Does the loop start from the element that it meets first? *)
let starts_anew caller (i : Ir.instance) (l : Ir.loop) (callee : Ir.node) start (x : Ir.signal) =
  match definition caller.node start with
  | Some { rhs = Index (Signal array, 0); _ } ->
      List.exists2
        (fun (parameter : Ir.signal) (argument, atom) ->
          parameter.id = x.id && argument = Ir.Element && is array atom)
        callee.inputs
        (List.combine l.arguments i.inputs)
  | Some _ | None -> false

(* The comparison of an accumulator that may start from NaN. *)
let improvable caller (i : Ir.instance) (l : Ir.loop) callee k =
  let best = List.nth callee.node.Ir.inputs k in
  match comparison callee.node ~best (snd (List.nth callee.node.outputs k)) with
  | Some c
    when starts_anew caller i l callee.node (List.nth i.inputs k) c.x
         && best.ty = Float
         && callee.uses best = 2
         && List.for_all (fun s -> callee.uses s = 1) c.alone ->
      Some (c, best)
  | Some _ | None -> None

let compare_only (callee : Ir.node) c (best : Ir.signal) =
  let operands : Ir.atom list =
    match c.which with Least -> [ Signal c.x; Signal best ] | Largest -> [ Signal best; Signal c.x ]
  in
  let equation (e : Ir.equation) =
    if e.defines.id = c.condition.id then { e with rhs = Op (Less, operands) } else e
  in
  { callee with equations = Long_list.map equation callee.equations }

let instance (nodes : Ir.node array) runs caller (i : Ir.instance) (l : Ir.loop) =
  let callee = reader nodes.(i.node) in
  let start k argument (input : Ir.atom) : Ir.atom =
    match if argument = Ir.Accumulator then improvable caller i l callee k else None with
    | None -> input
    | Some (c, best) when may_be_infinity c.which caller (List.nth i.outputs k) ->
        if runs.(i.node) = 1 then nodes.(i.node) <- compare_only nodes.(i.node) c best;
        Float (match c.which with Least -> infinity | Largest -> neg_infinity)
    | Some _ -> Float Fold.nan
  in
  let given = List.combine l.arguments i.inputs in
  let inputs = List.mapi (fun k (how, a) -> start k how a) given in
  if List.for_all2 ( == ) inputs i.inputs then i else { i with inputs }

let program (program : Ir.program) =
  let runs = Uses.of_nodes program in
  let nodes = Array.copy program.nodes in
  let has_loop (i : Ir.instance) = Option.is_some i.loop in
  Array.iteri
    (fun index (node : Ir.node) ->
      if List.exists has_loop node.instances then
        let caller = reader node in
        let instances =
          List.map
            (fun (i : Ir.instance) ->
              Option.fold i.loop ~none:i ~some:(instance nodes runs caller i))
            node.instances
        in
        if not (List.for_all2 ( == ) instances node.instances) then
          nodes.(index) <- { nodes.(index) with instances })
    program.nodes;
  if Array.for_all2 ( == ) nodes program.nodes then program else { program with nodes }
