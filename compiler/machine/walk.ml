open Ir

let children = function
  | Bool _ | Int _ | Float _ | Zero_time | Variable _ | Field _ | Dt | Dt_nanoseconds -> []
  | Operation { arguments; _ } | Call { arguments; _ } -> arguments
  | Select { condition; then_; else_ } -> [ condition; then_; else_ ]
  | Construct { payload; _ } -> payload
  | Is_constructor { value; _ } | Payload { value; _ } | Seconds value -> [ value ]
  | Later (a, b) -> [ a; b ]

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
      | Declare _ | Assign _ | Step _ | Reset _ | Return _ -> ())
    body

let expressions visit body =
  statements
    (function
      | Declare { value; _ } | Assign { value; _ } | Return { value; _ } -> expression visit value
      | If { condition; _ } -> expression visit condition
      | Step { arguments; _ } | Reset { arguments; _ } -> List.iter (expression visit) arguments)
    body
