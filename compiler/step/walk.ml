open Ir

let children = function
  | Bool _ | Int _ | Float _ | Zero_time | Time _ | Absent _ | Variable _ | Field _ | Dt | Dt_nanoseconds -> []
  | Operation { arguments; _ } | Call { arguments; _ } -> arguments
  | Select { condition; then_; else_ } -> [ condition; then_; else_ ]
  | Construct { payload; _ } -> payload
  | Elements { elements; _ } -> elements
  | Fill { value; _ } -> [ value ]
  | Index { array; _ } -> [ array ]
  | At { array; index; default; _ } -> [ array; index; default ]
  | Replace { array; index; value; _ } -> [ array; index; value ]
  | Is_constructor { value; _ } | Payload { value; _ } | Seconds value | In_nanoseconds value -> [ value ]
  | Later (a, b) | Soon (a, b) | Reached { time = a; period = b } | Rest { time = a; period = b } -> [ a; b ]

let map_children f e =
  match e with
  | Bool _ | Int _ | Float _ | Zero_time | Time _ | Absent _ | Variable _ | Field _ | Dt | Dt_nanoseconds -> e
  | Operation o -> Operation { o with arguments = List.map f o.arguments }
  | Call c -> Call { c with arguments = List.map f c.arguments }
  | Select { condition; then_; else_ } ->
      Select { condition = f condition; then_ = f then_; else_ = f else_ }
  | Construct c -> Construct { c with payload = List.map f c.payload }
  | Elements e -> Elements { e with elements = Basis.Long_list.map f e.elements }
  | Fill l -> Fill { l with value = f l.value }
  | Index i -> Index { i with array = f i.array }
  | At a -> At { a with array = f a.array; index = f a.index; default = f a.default }
  | Replace r -> Replace { r with array = f r.array; index = f r.index; value = f r.value }
  | Is_constructor c -> Is_constructor { c with value = f c.value }
  | Payload p -> Payload { p with value = f p.value }
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
      | Declare _ | Assign _ | Step _ | Loop _ | Reset _ | Enter _ | Start _ | Begin _ | Await _
      | Run _ | Return _ -> ())
    body

let entry visit (e : entry) =
  List.iter (expression visit) e.parameters;
  match e.first with Reset_by arguments | Started_by arguments -> List.iter (expression visit) arguments

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
  Option.iter (entry visit) run.start;
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
      | Step { arguments; _ } | Reset { arguments; _ } | Start { arguments; _ } ->
          List.iter (expression visit) arguments
      | Begin { run; entry = e; _ } ->
          entry visit e;
          (match e.first with
          | Started_by _ -> ()
          | Reset_by _ ->
              List.iter (expression visit) (List.nth run.cases e.mode).arguments)
      | Loop l ->
          List.iter (expression visit) l.initial;
          List.iter (argument visit) l.arguments
      | Enter e -> entry visit e.entry
      | Await _ -> ()
      | Run r -> run visit r)
    body

let map_entry expression (e : entry) =
  let map = List.map expression in
  {
    e with
    parameters = map e.parameters;
    first =
      (match e.first with
      | Reset_by arguments -> Reset_by (map arguments)
      | Started_by arguments -> Started_by (map arguments));
  }

let map_run ~expression ~entry (run : run) =
  let next (n : next) = { n with condition = expression n.condition; entry = entry n.entry } in
  let case (c : case) =
    {
      c with
      arguments = List.map expression c.arguments;
      transitions = List.map next c.transitions;
    }
  in
  {
    run with
    active = Option.map expression run.active;
    clock = Option.map (fun (c : clock) -> { c with elapsed = expression c.elapsed }) run.clock;
    start = Option.map entry run.start;
    controls = List.map (fun (condition, e) -> (expression condition, entry e)) run.controls;
    cases = List.map case run.cases;
  }

let map_argument expression : argument -> argument = function
  | Accumulated k -> Accumulated k
  | Each e -> Each (expression e)
  | Same e -> Same (expression e)
  | Counted e -> Counted (expression e)

let map_statements ~expression ~entry body =
  let entry e = entry (map_entry expression e) in
  let rec statement = function
    | Declare d -> Declare { d with value = expression d.value }
    | Assign a -> Assign { a with value = expression a.value }
    | Return r -> Return { r with value = expression r.value }
    | If i ->
        If
          {
            i with
            condition = expression i.condition;
            then_ = List.map statement i.then_;
            else_ = List.map statement i.else_;
          }
    | Step s -> Step { s with arguments = List.map expression s.arguments }
    | Reset r -> Reset { r with arguments = List.map expression r.arguments }
    | Start s -> Start { s with arguments = List.map expression s.arguments }
    | Begin b -> Begin { b with run = map_run ~expression ~entry b.run; entry = entry b.entry }
    | Loop l ->
        Loop
          {
            l with
            initial = List.map expression l.initial;
            arguments = List.map (map_argument expression) l.arguments;
          }
    | Enter e -> Enter { e with entry = entry e.entry }
    | Await a -> Await a
    | Run r -> Run (map_run ~expression ~entry r)
  in
  List.map statement body

let entries visit body =
  let run (r : run) =
    Option.iter visit r.start;
    List.iter (fun (_, e) -> visit e) r.controls;
    List.iter (fun (c : case) -> List.iter (fun (n : next) -> visit n.entry) c.transitions) r.cases
  in
  statements
    (function
      | Enter { entry; _ } -> visit entry
      | Begin { entry; _ } -> visit entry
      | Run r -> run r
      | Declare _ | Assign _ | If _ | Step _ | Loop _ | Reset _ | Start _ | Await _ | Return _ -> ())
    body
