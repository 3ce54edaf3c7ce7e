open Ir

let atom : expr -> Flow.Ir.atom option = function
  | Bool b -> Some (Bool b)
  | Int n -> Some (Int n)
  | Float x -> Some (Float x)
  | _ -> None

let of_atom : Flow.Ir.atom -> expr option = function
  | Bool b -> Some (Bool b)
  | Int n -> Some (Int n)
  | Float x -> Some (Float x)
  | Signal _ -> None

let is e = match e with Zero_time -> true | e -> Option.is_some (atom e)

let same a b =
  match (a, b) with
  | Zero_time, Zero_time -> true
  | Variable a, Variable b -> a.id = b.id
  | _, _ -> (
      match (atom a, atom b) with
      | Some a, Some b -> Flow.Operands.same a b
      | None, _ | _, None -> false)

let folded real operator arguments =
  let atoms = List.filter_map atom arguments in
  if List.compare_lengths atoms arguments <> 0 then None
  else Option.bind (Flow.Fold.operation real operator atoms) of_atom

let operation real (operator : Flow.Ir.operator) ty arguments =
  match (operator, arguments) with
  | And, ([ Bool true; e ] | [ e; Bool true ]) | Or, ([ Bool false; e ] | [ e; Bool false ]) -> e
  | And, ([ Bool false; _ ] | [ _; Bool false ]) -> Bool false
  | Or, ([ Bool true; _ ] | [ _; Bool true ]) -> Bool true
  | Not, [ Operation { operator = Not; arguments = [ e ]; _ } ] -> e
  | _ -> Option.value (folded real operator arguments) ~default:(Operation { operator; ty; arguments })
