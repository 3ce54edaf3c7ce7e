open Basis

(* Maximum number of signals that are considered as parts of a condition. The signals nearest to the
   condition are considered first. *)
let most = 10

let operands (rhs : Ir.rhs) =
  match rhs with
  | Copy _ | Op ((And | Or | Not), _) | If _ -> Operands.signals (Operands.all rhs)
  | _ -> []

let parts definitions (rhs : Ir.rhs) =
  let rec nearest found = function
    | [] -> List.rev found
    | _ when List.length found >= most -> List.rev found
    | (s : Ir.signal) :: rest ->
        if List.exists (fun (f : Ir.signal) -> f.id = s.id) found then nearest found rest
        else
          let inner = Option.fold (Int_table.find_opt definitions s.id) ~none:[] ~some:operands in
          nearest (s :: found) (rest @ inner)
  in
  nearest [] (operands rhs)

(* Whether an operand of the condition is itself a choice, a conjunction or a disjunction. *)
let is_deep definitions (rhs : Ir.rhs) =
  match rhs with
  | If _ | Op ((And | Or), _) ->
      List.exists
        (fun (s : Ir.signal) ->
          match Int_table.find_opt definitions s.id with
          | Some (Ir.If _ | Op ((And | Or), _)) -> true
          | Some _ | None -> false)
        (operands rhs)
  | _ -> false

let rec pairs = function
  | [] -> []
  | first :: rest -> List.map (fun second -> (first, second)) rest @ pairs rest

let simpler at_an_instant definitions (e : Ir.equation) : Ir.rhs option =
  let value known = Truth.value (at_an_instant known) (Signal e.defines) in
  let parts = parts definitions e.rhs in
  (* The value that follows from [known] directly or, failing that, by case analysis on another
     part. *)
  let value_anyhow known =
    let either (other : Ir.signal) =
      match (value ((other, true) :: known), value ((other, false) :: known)) with
      | Some x, Some y when Bool.equal x y -> Some x
      | _, _ -> None
    in
    match value known with None -> List.find_map either parts | found -> found
  in
  let one (a : Ir.signal) : Ir.rhs option =
    match (value_anyhow [ (a, true) ], value_anyhow [ (a, false) ]) with
    | Some true, Some true -> Some (Copy (Bool true))
    | Some false, Some false -> Some (Copy (Bool false))
    | Some true, Some false -> Some (Copy (Signal a))
    | Some false, Some true -> Some (Op (Not, [ Signal a ]))
    | None, _ | _, None -> None
  in
  let two ((a : Ir.signal), (b : Ir.signal)) : Ir.rhs option =
    let value x y = value [ (a, x); (b, y) ] in
    let both = [ Ir.Signal a; Signal b ] in
    match (value true false, value false true) with
    | Some false, Some false when value true true = Some true && value false false = Some false ->
        Some (Op (And, both))
    | Some true, Some true when value true true = Some true && value false false = Some false ->
        Some (Op (Or, both))
    | _, _ -> None
  in
  (* Tries the most distant signals first: if one of them is used, the signals in between are no
     longer needed. *)
  match List.find_map one (List.rev parts) with
  | Some rhs -> Some rhs
  | None -> List.find_map two (List.rev (pairs parts))

let node (node : Ir.node) =
  let definitions = Truth.definitions node in
  let at_an_instant = Truth.at_an_instant node in
  let equation (e : Ir.equation) =
    if e.defines.ty <> Bool || not (is_deep definitions e.rhs) then e
    else
      match simpler at_an_instant definitions e with
      | Some rhs when rhs <> e.rhs -> { e with rhs }
      | Some _ | None -> e
  in
  let equations = Long_list.map_sharing equation node.equations in
  if equations == node.equations then node else { node with equations }

let program = Simplify.after node
