type problem = Param of Core.Ir.param | Foreign of string

exception Depends_on of Core.Ir.param

let known evaluate =
  match evaluate () with
  | value -> Ok value
  | exception Depends_on p -> Error (Param p)
  | exception Primitive.Foreign_code name -> Error (Foreign name)

let value (core : Core.Ir.program) name =
  let unknown (p : Core.Ir.param) =
    if p.param = name then None
    else Some (p.param, Thunk.delay (fun () -> raise_notrace (Depends_on p)))
  in
  let program = Evaluate.program ~params:(List.filter_map unknown core.params) core in
  known (fun () -> Thunk.demand (Evaluate.definition program name))
