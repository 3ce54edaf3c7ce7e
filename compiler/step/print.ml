open Format

let variable names (v : Ir.variable) = Basis.Unique_names.find names ~id:v.id v.name
let operator = Flow.Print.operator
let is_symbol text = match text.[0] with 'a' .. 'z' -> false | _ -> true
let field (f : Ir.field) = sprintf "self.%s#%d" f.name f.id

type context = { program : Ir.program; names : Basis.Unique_names.t }

let constructor c sum k = (List.nth c.program.sums.(sum).constructors k).Flow.Ir.constructor

let rec expr c ppf (e : Ir.expr) =
  match e with
  | Bool b -> pp_print_bool ppf b
  | Int i -> fprintf ppf "%ld" i
  | Float x -> pp_print_string ppf (Flow.Print.float x)
  | Zero_time -> pp_print_string ppf "0ns"
  | Param k -> fprintf ppf "param %d" k
  | Absent _ -> pp_print_string ppf "absent"
  | Variable v -> pp_print_string ppf (variable c.names v)
  | Field f -> pp_print_string ppf (field f)
  | Dt -> pp_print_string ppf "dt"
  | Dt_nanoseconds -> pp_print_string ppf "dt_ns"
  | Operation { operator = o; arguments = [ a; b ]; _ } when is_symbol (operator o) ->
      fprintf ppf "%a %s %a" (operand c) a (operator o) (operand c) b
  | Operation { operator = o; arguments; _ } -> fprintf ppf "%s%a" (operator o) (list c) arguments
  | Select { condition; then_; else_ } ->
      fprintf ppf "if %a then %a else %a" (expr c) condition (expr c) then_ (expr c) else_
  | Construct { sum; constructor = k; payload } ->
      fprintf ppf "%s%a" (constructor c sum k) (list c) payload
  | Is_constructor { sum; value; constructor = k } ->
      fprintf ppf "%a is %s" (operand c) value (constructor c sum k)
  | Payload { sum; value; constructor = k; leaf } ->
      fprintf ppf "%a.%s.%d" (operand c) value (constructor c sum k) leaf
  | Elements { elements; _ } -> fprintf ppf "array%a" (list c) elements
  | Fill { count; value; _ } -> fprintf ppf "fill%a" (list c) [ Int (Int32.of_int count); value ]
  | Index { array; index } -> fprintf ppf "%a[%d]" (operand c) array index
  | At { array; index; default; _ } -> fprintf ppf "at%a" (list c) [ array; index; default ]
  | Replace { array; index; value; _ } -> fprintf ppf "replace%a" (list c) [ array; index; value ]
  | Call { node; arguments } -> fprintf ppf "%s%a" c.program.nodes.(node).name (list c) arguments
  | Seconds e -> fprintf ppf "seconds%a" (list c) [ e ]
  | In_nanoseconds e -> fprintf ppf "nanoseconds%a" (list c) [ e ]
  | Later (a, b) -> fprintf ppf "later%a" (list c) [ a; b ]
  | Soon (a, b) -> fprintf ppf "soon%a" (list c) [ a; b ]
  | Reached { time; period } -> fprintf ppf "reached%a" (list c) [ time; period ]
  | Rest { time; period } -> fprintf ppf "rest%a" (list c) [ time; period ]

and operand c ppf (e : Ir.expr) =
  match e with
  | Bool _ | Int _ | Float _ | Zero_time | Absent _ | Variable _ | Field _ | Param _ | Dt
  | Dt_nanoseconds | Call _ | Construct _ | Elements _ | Fill _ | Index _ | At _ | Replace _
  | Payload _ | Seconds _ | In_nanoseconds _ | Later _ | Soon _ | Reached _ | Rest _ ->
      expr c ppf e
  | Operation { operator = o; _ } when not (is_symbol (operator o)) -> expr c ppf e
  | Operation _ | Select _ | Is_constructor _ -> fprintf ppf "(%a)" (expr c) e

and list c ppf es =
  fprintf ppf "(%a)" (pp_print_list ~pp_sep:(fun ppf () -> pp_print_string ppf ", ") (expr c)) es

let place c : Ir.place -> string = function
  | Local v -> variable c.names v
  | Own f -> field f
  | Result k -> sprintf "result.%d" k

let variables c vs = String.concat ", " (List.map (variable c.names) vs)

let rec statement c indent ppf (s : Ir.statement) =
  let put format = fprintf ppf ("%s" ^^ format ^^ "@\n") (String.make indent ' ') in
  match s with
  | Declare { variable = v; value; span } ->
      put "%s = %a  -- %d" (variable c.names v) (expr c) value (Basis.Span.line span.start)
  | Assign { place = p; value; span } ->
      put "%s := %a  -- %d" (place c p) (expr c) value (Basis.Span.line span.start)
  | If { uninitialized; condition; then_; else_; predicted; span } ->
      if uninitialized <> [] then put "var %s" (variables c uninitialized);
      let word = if predicted then "if predicted" else "if" in
      put "%s %a  -- %d" word (expr c) condition (Basis.Span.line span.start);
      List.iter (statement c (indent + 2) ppf) then_;
      if else_ <> [] then (
        put "else";
        List.iter (statement c (indent + 2) ppf) else_)
  | Step { node; state; arguments; results; on_trial; span } ->
      put "%s = %s %s %s%a  -- %d" (variables c results)
        (if on_trial then "try" else "step")
        c.program.nodes.(node).name
        (match state with Some f -> field f | None -> "")
        (list c) arguments (Basis.Span.line span.start)
  | Loop { node; state; count; initial; arguments; results; span } ->
      let argument : Ir.argument -> string = function
        | Accumulated k -> sprintf "so far.%d" k
        | Each e -> asprintf "each %a" (operand c) e
        | Same e -> asprintf "%a" (expr c) e
        | Counted e -> asprintf "%a + i" (operand c) e
      in
      put "%s = %d times step %s %s(%s) from %a  -- %d" (variables c results) count
        c.program.nodes.(node).name
        (match state with Some f -> field f | None -> "")
        (String.concat ", " (List.map argument arguments))
        (list c) initial (Basis.Span.line span.start)
  | Reset { node; state; arguments; span } ->
      put "reset %s %s%a  -- %d" c.program.nodes.(node).name (field state) (list c) arguments
        (Basis.Span.line span.start)
  | Enter { entry; _ } -> put "%a" (enter c) entry
  | Run { active; clock = _; steps; controls; late; drops; cases; results; span } ->
      Option.iter (put "if %a" (expr c)) active;
      put "%s = run, at most %d steps%s  -- %d" (variables c results) steps
        (if drops then ", may drop results" else "")
        (Basis.Span.line span.start);
      let control (condition, e) =
        put "  %s %a -> %a" (if late then "then" else "first") (expr c) condition (enter c) e
      in
      List.iter control controls;
      List.iteri
        (fun k (case : Ir.case) ->
          put "  case %d: %s = step%a" k (variables c case.others) (list c) case.arguments;
          List.iter
            (fun (n : Ir.next) ->
              put "    %a -> %a%s" (expr c) n.condition (enter c) n.entry
                (if n.delayed then ", delayed" else ""))
            case.transitions)
        cases
  | Return { value; _ } -> put "return %a" (expr c) value

and enter c ppf (e : Ir.entry) =
  fprintf ppf "enter %d%a reset%a" e.mode (list c) e.parameters (list c) e.arguments

let rec ty (program : Ir.program) : Ir.ty -> string = function
  | Bool -> "Bool"
  | Int -> "Int"
  | Float -> "Float"
  | Nanoseconds -> "Nanoseconds"
  | Sum k -> program.sums.(k).name
  | Array (n, element) -> sprintf "Array %d (%s)" n (ty program element)
  | Foreign f -> f.foreign_name

let code (program : Ir.program) title ppf (code : Ir.code) =
  let c = { program; names = Basis.Unique_names.create () } in
  fprintf ppf "  %s (%s)@\n" title (variables c code.parameters);
  List.iter (statement c 4 ppf) code.body

let node (program : Ir.program) ppf (n : Ir.node) =
  fprintf ppf "node %s@\n" n.name;
  List.iter
    (fun (f : Ir.field) ->
      let content =
        match f.content with
        | Value t -> (
            match f.bound with
            | None -> ty program t
            | Some bound -> sprintf "%s, at most %Ld" (ty program t) bound)
        | State_of k -> sprintf "state of %s" program.nodes.(k).name
        | States_of { node; count } -> sprintf "%d states of %s" count program.nodes.(node).name
        | Running_mode -> "number of a mode"
        | Component symbol -> sprintf "state of the component %s" symbol
        | Modes modes ->
            sprintf "one of %s" (String.concat ", " (List.map (fun (m : Ir.mode) -> m.name) modes))
      in
      fprintf ppf "  %s : %s  -- %s@\n" (field f) content f.purpose)
    n.state;
  if n.state <> [] then code program "reset" ppf n.reset;
  code program "step" ppf n.step

let program ppf (p : Ir.program) =
  Array.iteri
    (fun k n ->
      if k > 0 then fprintf ppf "@\n";
      node p ppf n)
    p.nodes;
  pp_print_flush ppf ()
