open Ir

let children = function
  | Bool _ | Int _ | Float _ | Zero_time | Absent _ | Variable _ | Field _ | Param _ | Dt
  | Dt_nanoseconds ->
      []
  | Operation { arguments; _ } | Call { arguments; _ } -> arguments
  | Select { condition; then_; else_; span = _ } -> [ condition; then_; else_ ]
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

let map_children f = function
  | ( Bool _ | Int _ | Float _ | Zero_time | Absent _ | Variable _ | Field _ | Param _ | Dt
    | Dt_nanoseconds ) as leaf ->
      leaf
  | Operation o -> Operation { o with arguments = List.map f o.arguments }
  | Call c -> Call { c with arguments = List.map f c.arguments }
  | Select { condition; then_; else_; span } ->
      Select { condition = f condition; then_ = f then_; else_ = f else_; span }
  | Construct c -> Construct { c with payload = List.map f c.payload }
  | Elements e -> Elements { e with elements = Basis.Long_list.map f e.elements }
  | Fill e -> Fill { e with value = f e.value }
  | Index e -> Index { e with array = f e.array }
  | At e -> At { e with array = f e.array; index = f e.index; default = f e.default }
  | Replace e -> Replace { e with array = f e.array; index = f e.index; value = f e.value }
  | Is_constructor e -> Is_constructor { e with value = f e.value }
  | Payload e -> Payload { e with value = f e.value }
  | Seconds e -> Seconds (f e)
  | In_nanoseconds e -> In_nanoseconds (f e)
  | Later (a, b) -> Later (f a, f b)
  | Soon (a, b) -> Soon (f a, f b)
  | Reached { time; period } -> Reached { time = f time; period = f period }
  | Rest { time; period } -> Rest { time = f time; period = f period }

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
