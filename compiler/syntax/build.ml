open Basis

type location = Lexing.position * Lexing.position

let position (p : Lexing.position) : Span.position =
  Span.position ~line:p.pos_lnum ~column:(p.pos_cnum - p.pos_bol + 1)

let span ((start, stop) : location) =
  Span.make ~file:start.pos_fname ~start:(position start) ~stop:(position stop)

let name location text : Ir.name = { text; span = span location }
let unqualified (name : Ir.name) : Ir.qualified = { qualifier = None; name; span = name.span }

let variable ((start, _) as location : location) (x : Ir.name) =
  if x.span.start = position start then unqualified x
  else { (unqualified x) with span = span location }

(* [take n span] is the first [n] bytes of a span within one line; [drop n span] is the rest. *)
let take n (span : Span.t) = { span with stop = Span.forward n span.start }
let drop n (span : Span.t) = { span with start = Span.forward n span.start }

let qualified location (qualifier, text) : Ir.qualified =
  let span = span location in
  let length = String.length qualifier in
  {
    qualifier = Some { text = qualifier; span = take length span };
    name = { text; span = drop (length + 1) span };
    span;
  }

let field location text : Ir.name = { text; span = drop 1 (span location) }

let tuple places : Surface.term_desc =
  if List.for_all Option.is_some places then Tuple (Long_list.map Option.get places)
  else Expression (Tuple_section (Long_list.map (Option.map Term.to_expr) places))

(* Types *)

let context (t : Ir.ty) =
  let one (t : Ir.ty) =
    match t.desc with
    | Type { name; units = None; arguments = [ argument ] } -> (name, argument)
    | Type _ | Type_variable _ | Representation _ | Function _ | Tuple_type _ | Size _
    | Size_operation _ ->
        Reject.because (Context_without_classes t.span)
  in
  match t.desc with
  | Tuple_type ts -> Long_list.map one ts
  | Type _ | Type_variable _ | Representation _ | Function _ | Size _ | Size_operation _ ->
      [ one t ]

let class_ context (head : Ir.ty) members : Ir.declaration_desc =
  let name, (variable : Ir.name) =
    match head.desc with
    | Type
        {
          name = { qualifier = None; name; _ };
          units = None;
          arguments = [ { desc = Type_variable variable; _ } ];
        } ->
        (name, variable)
    | Type _ | Type_variable _ | Representation _ | Function _ | Tuple_type _ | Size _
    | Size_operation _ ->
        Reject.because (Class_head head.span)
  in
  let superclass ((class_ : Ir.qualified), (t : Ir.ty)) =
    match t.desc with
    | Type_variable x when String.equal x.text variable.text -> class_
    | Type_variable _ | Type _ | Representation _ | Function _ | Tuple_type _ | Size _
    | Size_operation _ ->
        Reject.because (Superclass_of_other_type { at = t.span; class_ = name; variable })
  in
  Class { superclasses = List.map superclass context; name; variable; members }

let instance context (head : Ir.ty) members : Ir.declaration_desc =
  match head.desc with
  | Type { name = class_; units = None; arguments = [ head ] } ->
      Instance { context; class_; head; members }
  | Type _ | Type_variable _ | Representation _ | Function _ | Tuple_type _ | Size _
  | Size_operation _ ->
      Reject.because (Instance_head head.span)

(* Foreign code *)

let expect_word expected (word : Ir.name) =
  if not (String.equal word.text expected) then
    Reject.because (Foreign_word { expected; found = word })

let foreign_signal_function ~word name ty symbol : Ir.declaration_desc =
  expect_word "sf" word;
  Foreign (Foreign_value { kind = Foreign_signal_function; name; ty; symbol })

let foreign_type name c_type ~word : Ir.declaration_desc =
  Option.iter (expect_word "copyable") word;
  Foreign (Foreign_type { name; c_type; copyable = Option.is_some word })

let foreign_include ~word header : Ir.declaration_desc =
  expect_word "include" word;
  Foreign (Foreign_include header)

(* The value of a literal without a decimal point; [None] if it does not fit in an [Int]. *)
let whole digits = Option.map Int32.to_int (Option.bind (Exact.of_literal digits) Exact.to_int32)

let size location (digits, decimal) =
  match whole digits with
  | Some n when not decimal -> n
  | Some _ | None -> Reject.because (Size_not_whole { at = span location; digits })

let sign_of_sizes location : string -> Ir.size_operator = function
  | "+" -> Plus_sizes
  | text -> Reject.because (Size_operator { at = span location; operator = text })

(* Units *)

let one span : Ir.unit_ = { desc = One; span }

let times left (right : Ir.unit_) ~over : Ir.unit_ =
  match left with
  | None when over ->
      { desc = Over (one { right.span with stop = right.span.start }, right); span = right.span }
  | None -> right
  | Some (left : Ir.unit_) ->
      {
        desc = (if over then Over (left, right) else Times (left, right));
        span = Span.merge left.span right.span;
      }

let product factors =
  let measure (f : Surface.factor) =
    match f.factor with
    | Measure unit_ -> unit_
    | Amount { digits = "1"; decimal = false } -> one f.span
    | Amount { digits; _ } -> Reject.because (Number_in_unit { at = f.span; digits })
  in
  let multiply left (f : Surface.factor) = Some (times left (measure f) ~over:f.over) in
  match List.fold_left multiply None (List.rev factors) with
  | Some unit_ -> unit_
  | None -> Diagnostic.bug ~stage:"Syntax.Build" "this unit has no factors"

let rec gcd a b = if b = 0 then a else gcd b (a mod b)

let exponent location ~negative numerator ~over : Ir.rational =
  let small digits =
    match whole digits with
    | Some n when n <= 1000 -> n
    | Some _ | None -> Reject.because (Exponent_too_large (span location))
  in
  let numerator = small numerator and denominator = small over in
  if denominator = 0 then Reject.because (Exponent_over_zero (span location));
  let divisor = gcd numerator denominator in
  let numerator = numerator / divisor in
  { numerator = (if negative then -numerator else numerator); denominator = denominator / divisor }

let scaled_unit ~(name : Ir.name) factors : Ir.declaration_desc =
  let reject span = Reject.because (Scale_of_unit span) in
  let add ((scale : Ir.scale), factor_seen, unit_) (f : Surface.factor) =
    match f.factor with
    | Amount { digits; _ } when f.over ->
        if scale.divided_by <> "1" then reject f.span
        else ({ scale with divided_by = digits }, factor_seen, unit_)
    | Amount { digits; _ } ->
        if factor_seen then reject f.span else ({ scale with factor = digits }, true, unit_)
    | Measure { desc = Unit_name { text = "pi"; _ }; _ } ->
        if f.over || scale.times_pi then reject f.span
        else ({ scale with times_pi = true }, factor_seen, unit_)
    | Measure measure -> (scale, factor_seen, Some (times unit_ measure ~over:f.over))
  in
  let start : Ir.scale = { factor = "1"; times_pi = false; divided_by = "1" } in
  let scale, _, unit_ = List.fold_left add (start, false, None) (List.rev factors) in
  let unit_ =
    match (unit_, factors) with
    | Some unit_, _ -> unit_
    | None, last :: _ -> one last.span
    | None, [] -> one name.span
  in
  Scaled_unit { name; scale; unit_ }

(* Statements *)

(* The name that a statement binds, if it binds a single variable. *)
let bound left = match (Term.to_pattern left).desc with Bound { text; _ } -> Some text | _ -> None

let do_body location statements : Ir.proc_body =
  (* [rec] has no effect: its statements are merged with the others. *)
  let rec flatten done_ work : Surface.statement list =
    match work with
    | [] -> done_
    | [] :: rest -> flatten done_ rest
    | (Surface.Rec inner :: statements) :: rest -> flatten done_ (inner :: statements :: rest)
    | (((Arrow_bind _ | Command_bind _ | Bare_command _ | Bare_expression _ | Let _) as s)
      :: statements)
      :: rest ->
        flatten (s :: done_) (statements :: rest)
  in
  let statement (s : Surface.statement) : Ir.statement =
    match s with
    | Arrow_bind { left; right } ->
        Bind_expr
          { pattern = Term.to_pattern left; expr = right; span = Span.merge left.span right.span }
    | Command_bind { left; command } -> Bind { pattern = Term.to_pattern left; command }
    | Bare_command command ->
        let before = { command.span with stop = command.span.start } in
        Bind { pattern = { desc = Any; span = before }; command }
    | Let declarations -> Let_equations declarations
    | Bare_expression term ->
        Reject.because (Expression_in_proc { expr = Term.to_expr term; is_last = false })
    | Rec _ -> Diagnostic.bug ~stage:"Syntax.Build" "a `rec` that was not flattened"
  in
  match flatten [] [ statements ] with
  | Bare_command result :: before -> Do { statements = List.rev_map statement before; result }
  | Bare_expression term :: _ ->
      Reject.because (Expression_in_proc { expr = Term.to_expr term; is_last = true })
  | (Arrow_bind { left; _ } | Command_bind { left; _ }) :: _ ->
      Reject.because (Output_binds { at = left.span; name = bound left })
  | Let declarations :: _ ->
      let name =
        match List.rev declarations with
        | { desc = Binding { left = Name name; _ }; _ } :: _ -> Some name.text
        | _ -> None
      in
      Reject.because (Output_is_let { at = span location; name })
  | Rec _ :: _ -> Diagnostic.bug ~stage:"Syntax.Build" "a `rec` that was not flattened"
  | [] -> Reject.because (Empty_proc (span location))

(* A [do] block of tasks. Its last statement is a task, whose result is the block's result. *)
let task_body location statements : Ir.expr_desc =
  let no_command (c : Ir.command) =
    raise (Reject.Command { command = c.span; block = fst location })
  in
  let no_rec span = Reject.because (Rec_in_task span) in
  let rec place (statements : Surface.statement list) =
    match statements with
    | (Bare_command { span; _ } | Bare_expression { span; _ }) :: _ -> span
    | (Arrow_bind { left; _ } | Command_bind { left; _ }) :: _ -> left.span
    | Let ({ span; _ } :: _) :: _ -> span
    | (Let [] | Rec []) :: others -> place others
    | Rec inner :: others -> place (inner @ others)
    | [] -> span location
  in
  let statement (s : Surface.statement) : Ir.task_statement =
    match s with
    | Arrow_bind { left; right } ->
        Task
          {
            pattern = Some (Term.to_pattern left);
            task = right;
            span = Span.merge left.span right.span;
          }
    | Bare_expression t -> Task { pattern = None; task = Term.to_expr t; span = t.span }
    | Let declarations -> Let_values declarations
    | Command_bind { command; _ } | Bare_command command -> no_command command
    | Rec inner -> no_rec (place inner)
  in
  match (List.rev statements : Surface.statement list) with
  | Bare_expression result :: before ->
      Sequence { statements = List.rev_map statement before; result = Term.to_expr result }
  | Arrow_bind { left; _ } :: _ ->
      Reject.because (Last_task_binds { at = left.span; name = bound left })
  | (Let _ as last) :: _ -> Reject.because (Last_task_is_let (place [ last ]))
  | (Bare_command command | Command_bind { command; _ }) :: _ -> no_command command
  | Rec inner :: _ -> no_rec (place inner)
  | [] -> Reject.because (Empty_task (span location))

(* Clauses *)

let where location = function
  | [] -> Reject.because (Empty_where (span location))
  | declarations -> declarations

let declarations list =
  let declarations, clauses = Clauses.joined list in
  List.iter Reject.because clauses;
  declarations
