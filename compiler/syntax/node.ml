type t =
  | Declaration of Ir.declaration
  | Binding of Ir.binding
  | Constructor of Ir.constructor
  | Expression of Ir.expr
  | Branch of Ir.branch
  | Command of Ir.command
  | Pattern of Ir.pattern
  | Type of Ir.ty
  | Unit of Ir.unit_
  | Name of Ir.name
  | Qualified of Ir.qualified

let span = function
  | Declaration d -> d.span
  | Binding b -> b.span
  | Constructor c -> c.span
  | Expression e -> e.span
  | Branch b -> b.span
  | Command c -> c.span
  | Pattern p -> p.span
  | Type t -> t.span
  | Unit u -> u.span
  | Name x -> x.span
  | Qualified q -> q.span

(* The functions below prepend the children of a node to [rest]. The order of the children is
   irrelevant. *)

let all wrap list rest = List.fold_left (fun rest x -> wrap x :: rest) rest list
let names = all (fun x -> Name x)
let declarations = all (fun d -> Declaration d)
let expressions = all (fun e -> Expression e)
let patterns = all (fun p -> Pattern p)
let types = all (fun t -> Type t)
let units = all (fun u -> Unit u)

let constraints context rest =
  List.fold_left (fun rest (c, t) -> Qualified c :: Type t :: rest) rest context

let qualified_type (q : Ir.qualified_type) rest = constraints q.context (Type q.ty :: rest)
let signature (s : Ir.signature) rest = names s.names (qualified_type s.ty rest)
let parameters (p : Ir.type_parameters) rest = names p.units (names p.types rest)

let guards list rest =
  List.fold_left (fun rest (g, e) -> Expression g :: Expression e :: rest) rest list

let expression_fields list rest =
  List.fold_left (fun rest (x, e) -> Name x :: Expression e :: rest) rest list

let pattern_fields list rest =
  List.fold_left (fun rest (x, p) -> Name x :: Pattern p :: rest) rest list

let number (n : Ir.number) rest = match n.unit_ with None -> rest | Some u -> Unit u :: rest

let declaration (desc : Ir.declaration_desc) =
  match desc with
  | Signature s | Primitive s -> signature s []
  | Binding b -> [ Binding b ]
  | Type_alias { name; parameters = p; body } -> Name name :: parameters p [ Type body ]
  | Data { name; parameters = p; constructors } ->
      Name name :: parameters p (all (fun c -> Constructor c) constructors [])
  | Class { superclasses; name; variable; members } ->
      Name name :: Name variable
      :: all (fun q -> Qualified q) superclasses (declarations members [])
  | Instance { context; class_; head; members } ->
      Qualified class_ :: Type head :: constraints context (declarations members [])
  | Base_unit name -> [ Name name ]
  | Scaled_unit { name; scale = _; unit_ } -> [ Name name; Unit unit_ ]
  | Foreign (Foreign_value { kind = _; name; ty; symbol }) ->
      Name name :: qualified_type ty [ Name symbol ]
  | Foreign (Foreign_type { name; c_type; copyable = _ }) -> [ Name name; Name c_type ]
  | Foreign (Foreign_include header) -> [ Name header ]
  | Parameter { name; ty; value } -> Name name :: qualified_type ty [ Expression value ]
  | Claim { kind = _; label; condition } -> [ Name label; Expression condition ]
  | Check { kind = _; label; value } -> [ Name label; Expression value ]

let of_right (r : Ir.right) =
  let rest = declarations r.where [] in
  match r.body with Plain e -> Expression e :: rest | Guarded list -> guards list rest

let binding (b : Ir.binding) =
  let rest = of_right b.right in
  match b.left with
  | Name x -> Name x :: rest
  | Function_name { name; parameters } -> Name name :: patterns parameters rest
  | Pattern p -> Pattern p :: rest

let statement (s : Ir.statement) rest =
  match s with
  | Bind { pattern; command } -> Pattern pattern :: Command command :: rest
  | Bind_expr { pattern; expr; span = _ } -> Pattern pattern :: Expression expr :: rest
  | Let_equations ds -> declarations ds rest

let proc_body (body : Ir.proc_body) =
  match body with
  | Output { output; equations } -> Expression output :: declarations equations []
  | Command c -> [ Command c ]
  | Do { statements; result } ->
      List.fold_left (fun rest s -> statement s rest) [ Command result ] statements

let task_statement rest (s : Ir.task_statement) =
  match s with
  | Task { pattern; task; span = _ } ->
      Expression task :: Option.fold ~none:rest ~some:(fun p -> Pattern p :: rest) pattern
  | Let_values ds -> declarations ds rest

let expression (desc : Ir.expr_desc) =
  match desc with
  | Variable x | Constructor x -> [ Qualified x ]
  | Number n -> number n []
  | String _ -> []
  | Tuple es | Array es -> expressions es []
  | Tuple_section places -> expressions (List.filter_map Fun.id places) []
  | Apply (f, x) -> [ Expression f; Expression x ]
  | Binary { operator; left; right } -> [ Qualified operator; Expression left; Expression right ]
  | Negate e | Parenthesized e -> [ Expression e ]
  | Left_section { left = e; operator } | Right_section { operator; right = e } ->
      [ Qualified operator; Expression e ]
  | Power { base; exponent = _ } -> [ Expression base ]
  | If { condition; then_; else_ } -> [ Expression condition; Expression then_; Expression else_ ]
  | Case { scrutinee; branches } -> Expression scrutinee :: all (fun b -> Branch b) branches []
  | Lambda_case branches -> all (fun b -> Branch b) branches []
  | Let { bindings; body } -> Expression body :: declarations bindings []
  | Lambda { parameters; body } -> Expression body :: patterns parameters []
  | Proc { input; body } -> Pattern input :: proc_body body
  | Sequence { statements; result } ->
      List.fold_left task_statement [ Expression result ] statements
  | Record { constructor; fields } -> Qualified constructor :: expression_fields fields []
  | Update { record; fields } -> Expression record :: expression_fields fields []
  | Field { record; field } -> [ Expression record; Name field ]
  | Annotated { expr; ty } -> Expression expr :: qualified_type ty []

let branch (b : Ir.branch) =
  let rest = declarations b.where [ Pattern b.pattern ] in
  match b.body with Always e -> Expression e :: rest | If_guards list -> guards list rest

let pattern (desc : Ir.pattern_desc) =
  match desc with
  | Any -> []
  | Bound x -> [ Name x ]
  | As (x, p) -> [ Name x; Pattern p ]
  | Tuple_of ps | Array_of ps -> patterns ps []
  | Constructed (c, ps) -> Qualified c :: patterns ps []
  | Record_of (c, fields) -> Qualified c :: pattern_fields fields []
  | Literal { negative = _; number = n } -> number n []

let ty (desc : Ir.ty_desc) =
  match desc with
  | Type_variable x -> [ Name x ]
  | Type { name; units = us; arguments } ->
      Qualified name :: types arguments (units (Option.value ~default:[] us) [])
  | Representation { name; unit_ } -> [ Name name; Unit unit_ ]
  | Function (a, b) -> [ Type a; Type b ]
  | Tuple_type ts -> types ts []
  | Size _ -> []
  | Size_operation { operator = _; left; right } -> [ Type left; Type right ]

let unit_ (desc : Ir.unit_desc) =
  match desc with
  | One -> []
  | Unit_name x -> [ Name x ]
  | Times (a, b) | Over (a, b) -> [ Unit a; Unit b ]
  | To (u, _) -> [ Unit u ]

let constructor (c : Ir.constructor) =
  match c.fields with
  | Positional ts -> Name c.name :: types ts []
  | Named fields ->
      List.fold_left (fun rest (x, t) -> Name x :: Type t :: rest) [ Name c.name ] fields

let children = function
  | Declaration d -> declaration d.desc
  | Binding b -> binding b
  | Constructor c -> constructor c
  | Expression e -> expression e.desc
  | Branch b -> branch b
  | Command c -> [ Expression c.signal_function; Expression c.argument ]
  | Pattern p -> pattern p.desc
  | Type t -> ty t.desc
  | Unit u -> unit_ u.desc
  | Qualified { qualifier; name; span = _ } -> (
      match qualifier with None -> [ Name name ] | Some q -> [ Name q; Name name ])
  | Name _ -> []

let depth_exceeds limit node =
  let rec walk = function
    | [] -> None
    | (depth, node) :: work ->
        if depth > limit then Some (span node)
        else
          walk (List.fold_left (fun work child -> (depth + 1, child) :: work) work (children node))
  in
  walk [ (1, node) ]
