open Basis

let is_even : Ir.operator -> bool = function
  | Absolute | Elementary (Cos | Hypot) -> true
  | Add | Subtract | Multiply | Negate | Signum | Equal | Less | Less_equal | Minimum | Maximum
  | Divide | Pow
  | Elementary (Sqrt | Floor_float | Ceiling_float | Exp | Log | Sin | Tan | Asin | Acos | Atan | Atan2)
  | Div | Mod | Bitwise _ | To_float | Round | Floor | Ceiling | Truncate | Not | And | Or ->
      false

(* An Int has a least number without a negation. *)
let is_even_in (e : Ir.equation) =
  match e.rhs with Op (operator, _) -> is_even operator && e.defines.ty = Float | _ -> false

(* Equal for [a - b] and [b - a]. *)
let difference (rhs : Ir.rhs) =
  let key : Ir.atom -> [ `Signal of int | `Float of int64 ] option = function
    | Signal s -> Some (`Signal s.id)
    | Float x -> Some (`Float (Int64.bits_of_float x))
    | Bool _ | Int _ -> None
  in
  match rhs with
  | Op (Subtract, [ a; b ]) -> (
      match (key a, key b) with
      | Some a, Some b -> Some (if compare a b <= 0 then (a, b) else (b, a))
      | None, _ | _, None -> None)
  | _ -> None

let node (node : Ir.node) =
  let even = List.filter is_even_in node.equations in
  if even = [] then node
  else
    let definitions = Int_table.create 64 in
    List.iter
      (fun (e : Ir.equation) -> Int_table.replace definitions e.defines.id e.rhs)
      node.equations;
    let definition (s : Ir.signal) = Int_table.find_opt definitions s.id in
    let rec without_sign (atom : Ir.atom) =
      match atom with
      | Signal s -> (
          match definition s with
          | Some (Op ((Negate | Absolute), [ a ])) -> without_sign a
          | Some _ | None -> atom)
      | Bool _ | Int _ | Float _ -> atom
    in
    let read =
      Operands.signals
        (List.concat_map (fun (e : Ir.equation) -> List.map without_sign (Operands.all e.rhs)) even)
    in
    let here = Int_table.create 16 in
    let times (s : Ir.signal) = Option.value (Int_table.find_opt here s.id) ~default:0 in
    List.iter (fun (s : Ir.signal) -> Int_table.replace here s.id (1 + times s)) read;
    let uses = Uses.of_signals node in
    (* One that is read elsewhere too is there anyhow. *)
    let best = Hashtbl.create 16 in
    let consider (s : Ir.signal) =
      let propose key =
        match Hashtbl.find_opt best key with
        | Some (_, true) -> ()
        | Some (_, false) | None ->
            let is_elsewhere = uses s > times s in
            if is_elsewhere || not (Hashtbl.mem best key) then
              Hashtbl.replace best key (s, is_elsewhere)
      in
      Option.iter propose (Option.bind (definition s) difference)
    in
    List.iter consider read;
    let argument (atom : Ir.atom) : Ir.atom =
      match without_sign atom with
      | Signal s as same -> (
          match Option.bind (definition s) difference with
          | Some key -> Signal (fst (Hashtbl.find best key))
          | None -> same)
      | (Bool _ | Int _ | Float _) as constant -> constant
    in
    let equation (e : Ir.equation) =
      if not (is_even_in e) then e
      else
        let rhs = Operands.map argument e.rhs in
        if List.for_all2 Operands.same (Operands.all rhs) (Operands.all e.rhs) then e
        else { e with rhs }
    in
    let equations = Long_list.map equation node.equations in
    if List.for_all2 ( == ) equations node.equations then node else { node with equations }

let program program = Each_node.program (fun ~fresh:_ -> node) program
