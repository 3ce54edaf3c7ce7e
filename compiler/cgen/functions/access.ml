let plain desc : Ir.statement = { desc; comment = "" }
let no_path () = Basis.Diagnostic.bug ~stage:"Cgen.Access" "invalid access path"

(* A place in the input or output struct, given an index for each array that contains it. *)
let path from steps indices =
  let step (e, indices) (step : Interface.step) =
    match (step, indices) with
    | Member member, _ -> (Ir.Member (e, member), indices)
    | Element _, index :: others -> (Ir.Subscript (e, index), others)
    | Element _, [] -> no_path ()
  in
  match steps with
  | Interface.Member first :: rest ->
      let member : Ir.expr =
        match from with
        | Ir.Unary (Address, variable) -> Member (variable, first)
        | pointer -> Arrow (pointer, first)
      in
      fst (List.fold_left step (member, indices) rest)
  | Element _ :: _ | [] -> no_path ()

(* [body] receives the indices of all enclosing arrays. *)
let for_each names steps body =
  let rec around (steps : Interface.step list) indices =
    match steps with
    | [] -> body (List.rev indices)
    | Member _ :: rest -> around rest indices
    | Element count :: rest ->
        let index = Expression.index names (List.length indices) in
        [ plain (Ir.For { index; count; body = around rest (Ir.Name index :: indices) }) ]
  in
  around steps []

let clear names steps from =
  for_each names steps (fun indices -> [ plain (Ir.Assign (path from steps indices, Integer 0l)) ])

(* Copies between an array in the input or output and a variable. *)
let copy names steps ~from_interface from own =
  let element indices =
    let outside = path from steps indices in
    let own = List.fold_left Array_type.element own indices in
    [ plain (if from_interface then Ir.Assign (own, outside) else Ir.Assign (outside, own)) ]
  in
  match for_each names steps element with [ loop ] -> loop | _ -> no_path ()
