open Ir

let children = function
  | Bool _ | Int _ | Float _ | Zero_time | Absent _ | Variable _ | Field _ | Param _ | Dt
  | Dt_nanoseconds ->
      []
  | Operation { arguments; _ } | Call { arguments; _ } -> arguments
  | Select { condition; then_; else_ } -> [ condition; then_; else_ ]
  | Construct { payload; _ } -> payload
  | Elements { elements; _ } -> elements
  | Fill { value; _ } -> [ value ]
  | Index { array; _ } -> [ array ]
  | At { array; index; default; _ } -> [ array; index; default ]
  | Replace { array; index; value; _ } -> [ array; index; value ]
  | Is_constructor { value; _ } | Payload { value; _ } | Seconds value | In_nanoseconds value ->
      [ value ]
  | Later (a, b) | Soon (a, b) | Reached { time = a; period = b } | Rest { time = a; period = b } ->
      [ a; b ]

let rec expression visit e =
  visit e;
  List.iter (expression visit) (children e)

let rec statements visit body =
  List.iter
    (fun statement ->
      visit statement;
      match statement with
      | If { then_; else_; _ } ->
          statements visit then_;
          statements visit else_
      | Declare _ | Assign _ | Step _ | Loop _ | Reset _ | Enter _ | Run _ | Return _ -> ())
    body

let entry visit (e : entry) =
  List.iter (expression visit) e.parameters;
  List.iter (expression visit) e.arguments

let run visit (run : run) =
  let control (condition, e) =
    expression visit condition;
    entry visit e
  in
  let next (n : next) =
    expression visit n.condition;
    entry visit n.entry
  in
  let case c =
    List.iter (expression visit) c.arguments;
    List.iter next c.transitions
  in
  Option.iter (expression visit) run.active;
  Option.iter (fun (clock : clock) -> expression visit clock.elapsed) run.clock;
  List.iter control run.controls;
  List.iter case run.cases

let argument visit : argument -> unit = function
  | Accumulated _ -> ()
  | Each e | Same e | Counted e -> expression visit e

let expressions visit body =
  statements
    (function
      | Declare { value; _ } | Assign { value; _ } | Return { value; _ } -> expression visit value
      | If { condition; _ } -> expression visit condition
      | Step { arguments; _ } | Reset { arguments; _ } -> List.iter (expression visit) arguments
      | Loop l ->
          List.iter (expression visit) l.initial;
          List.iter (argument visit) l.arguments
      | Enter e -> entry visit e.entry
      | Run r -> run visit r)
    body
