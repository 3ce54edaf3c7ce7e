let negated (e : Ir.expr) =
  match e with
  | Operation { operator = Not; arguments = [ Variable v ]; _ } -> Some v
  | _ -> None

(* The condition, and what the value is where it holds and where not. *)
let decided (value : Ir.expr) : (Ir.variable * Ir.expr * Ir.expr) option =
  match value with
  | Operation { operator = (And | Or) as operator; arguments = [ a; b ]; _ } ->
      let by e other =
        let decides (c : Ir.variable) : Ir.variable * Ir.expr * Ir.expr =
          if operator = And then (c, Bool false, other) else (c, other, Bool true)
        in
        Option.map decides (negated e)
      in
      if Option.is_some (negated b) then by b a else by a b
  | _ -> None

(* Is this the condition, or its contrary? *)
let asks (c : Ir.variable) (condition : Ir.expr) =
  match (condition, negated condition) with
  | Variable v, _ when v.id = c.id -> Some true
  | _, Some v when v.id = c.id -> Some false
  | _, _ -> None

(* Further than a person looks, and it keeps this linear. *)
let furthest = 16

(* [before] is what stands before, the nearest first. *)
let into_branch (write : Ir.statement) before =
  let climb assigned (c, holds, fails) =
    let moved = Exchange.touched write in
    let rec up n over (before : Ir.statement list) =
      match before with
      | (If ({ condition; uninitialized = []; _ } as choice) as above) :: rest -> (
          match asks c condition with
          | Some is_then ->
              let then_, else_ = if is_then then (holds, fails) else (fails, holds) in
              let then_ = choice.then_ @ [ assigned then_ ] in
              let else_ = choice.else_ @ [ assigned else_ ] in
              Some (List.rev_append over (Ir.If { choice with then_; else_ } :: rest))
          | None -> past n over above rest)
      | above :: rest -> past n over above rest
      | [] -> None
    and past n over above rest =
      if n > 0 && Exchange.may_exchange moved above then up (n - 1) (above :: over) rest else None
    in
    up furthest [] before
  in
  match write with
  | Assign ({ place = Own _; value; _ } as assign) ->
      Option.bind (decided value) (climb (fun value -> Ir.Assign { assign with value }))
  | _ -> None

let statements body =
  let place before s = Option.value (into_branch s before) ~default:(s :: before) in
  List.rev (List.fold_left place [] body)
