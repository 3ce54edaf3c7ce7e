type problem = Param of Core.Ir.param | Foreign of string | Too_much

exception Depends_on of Core.Ir.param

let most_steps = 5_000_000
let most_steps_of_all = 20_000_000

type program = {
  evaluate : Evaluate.program;
  params : (Core.Ir.Global.t, unit) Hashtbl.t;
  mutable left : int;  (** evaluation steps left for all definitions together *)
}

let program (core : Core.Ir.program) =
  let params = Hashtbl.create 64 in
  let unknown (p : Core.Ir.param) =
    Hashtbl.replace params p.param ();
    (p.param, Thunk.delay (fun () -> raise_notrace (Depends_on p)))
  in
  let evaluate = Evaluate.program ~params:(List.rev_map unknown core.params) core in
  { evaluate; params; left = most_steps_of_all }

let known program evaluate =
  let before = Basis.Work.left () in
  let result =
    match Basis.Work.within (Int.min most_steps program.left) evaluate with
    | Some value -> Ok value
    | None | (exception Stack_overflow) -> Error Too_much
    | exception Depends_on p -> Error (Param p)
    | exception Primitive.Foreign_code name -> Error (Foreign name)
  in
  program.left <- Int.max 0 (program.left - (before - Basis.Work.left ()));
  result

let value program name =
  let thunk =
    if Hashtbl.mem program.params name then Evaluate.written program.evaluate name
    else Evaluate.definition program.evaluate name
  in
  known program (fun () -> Thunk.demand thunk)
