open Syntax.Ir

let span = Basis.Span.start_of_file ""
let all f list = List.rev (List.rev_map f list)
let name (x : name) : name = { x with span }

let qualified (q : qualified) : qualified =
  { qualifier = Option.map name q.qualifier; name = name q.name; span }

let rec unit_ (u : unit_) : unit_ =
  let desc =
    match u.desc with
    | One -> One
    | Unit_name x -> Unit_name (name x)
    | Times (a, b) -> Times (unit_ a, unit_ b)
    | Over (a, b) -> Over (unit_ a, unit_ b)
    | To (u, r) -> To (unit_ u, r)
  in
  { desc; span }

let rec ty (t : ty) : ty =
  let desc =
    match t.desc with
    | Type_variable x -> Type_variable (name x)
    | Type { name = x; units; arguments } ->
        Type
          { name = qualified x; units = Option.map (all unit_) units; arguments = all ty arguments }
    | Representation { name = x; unit_ = u } -> Representation { name = name x; unit_ = unit_ u }
    | Function (a, b) -> Function (ty a, ty b)
    | Tuple_type ts -> Tuple_type (all ty ts)
    | Size n -> Size n
    | Size_operation { operator; left; right } ->
        Size_operation { operator; left = ty left; right = ty right }
  in
  { desc; span }

let qualified_type (t : qualified_type) : qualified_type =
  { context = all (fun (c, t) -> (qualified c, ty t)) t.context; ty = ty t.ty }

let signature (s : signature) : signature = { names = all name s.names; ty = qualified_type s.ty }
let number (n : number) = { n with unit_ = Option.map unit_ n.unit_ }

let rec pattern (p : pattern) : pattern =
  let desc =
    match p.desc with
    | Any -> Any
    | Bound x -> Bound (name x)
    | As (x, p) -> As (name x, pattern p)
    | Tuple_of ps -> Tuple_of (all pattern ps)
    | Array_of ps -> Array_of (all pattern ps)
    | Constructed (c, ps) -> Constructed (qualified c, all pattern ps)
    | Record_of (c, fields) ->
        Record_of (qualified c, all (fun (x, p) -> (name x, pattern p)) fields)
    | Literal { negative; number = n } -> Literal { negative; number = number n }
  in
  { desc; span }

let rec expr (e : expr) : expr =
  let fields = all (fun (x, e) -> (name x, expr e)) in
  let desc =
    match e.desc with
    | Variable x -> Variable (qualified x)
    | Constructor x -> Constructor (qualified x)
    | Number n -> Number (number n)
    | String s -> String s
    | Array es -> Array (all expr es)
    | Tuple es -> Tuple (all expr es)
    | Tuple_section places -> Tuple_section (all (Option.map expr) places)
    | Apply (f, x) -> Apply (expr f, expr x)
    | Binary { operator; left; right } ->
        Binary { operator = qualified operator; left = expr left; right = expr right }
    | Negate e -> Negate (expr e)
    | Left_section { left; operator } ->
        Left_section { left = expr left; operator = qualified operator }
    | Right_section { operator; right } ->
        Right_section { operator = qualified operator; right = expr right }
    | Power { base; exponent } -> Power { base = expr base; exponent }
    | If { condition; then_; else_ } ->
        If { condition = expr condition; then_ = expr then_; else_ = expr else_ }
    | Case { scrutinee; branches } ->
        Case { scrutinee = expr scrutinee; branches = all branch branches }
    | Lambda_case branches -> Lambda_case (all branch branches)
    | Let { bindings; body } -> Let { bindings = all declaration bindings; body = expr body }
    | Lambda { parameters; body } ->
        Lambda { parameters = all pattern parameters; body = expr body }
    | Proc { input; body } -> Proc { input = pattern input; body = proc_body body }
    | Sequence { statements; result } ->
        Sequence { statements = all task_statement statements; result = expr result }
    | Record { constructor; fields = fs } ->
        Record { constructor = qualified constructor; fields = fields fs }
    | Update { record; fields = fs } -> Update { record = expr record; fields = fields fs }
    | Field { record; field } -> Field { record = expr record; field = name field }
    | Annotated { expr = e; ty = t } -> Annotated { expr = expr e; ty = qualified_type t }
    | Parenthesized e -> Parenthesized (expr e)
  in
  { desc; span }

and pairs list = all (fun (a, b) -> (expr a, expr b)) list

and branch (b : branch) : branch =
  let body =
    match b.body with Always e -> Always (expr e) | If_guards list -> If_guards (pairs list)
  in
  { pattern = pattern b.pattern; body; where = all declaration b.where; span }

and command (c : command) : command =
  { signal_function = expr c.signal_function; argument = expr c.argument; span }

and proc_body = function
  | Output { output; equations } ->
      Output { output = expr output; equations = all declaration equations }
  | Command c -> Command (command c)
  | Do { statements; result } ->
      Do { statements = all statement statements; result = command result }

and statement = function
  | Bind { pattern = p; command = c } -> Bind { pattern = pattern p; command = command c }
  | Bind_expr { pattern = p; expr = e; span = _ } ->
      Bind_expr { pattern = pattern p; expr = expr e; span }
  | Let_equations ds -> Let_equations (all declaration ds)

and task_statement = function
  | Task { pattern = p; task; span = _ } ->
      Task { pattern = Option.map pattern p; task = expr task; span }
  | Let_values ds -> Let_values (all declaration ds)

and binding (b : binding) : binding =
  let left =
    match b.left with
    | Name x -> Name (name x)
    | Function_name { name = x; parameters } ->
        Function_name { name = name x; parameters = all pattern parameters }
    | Pattern p -> Pattern (pattern p)
  in
  let body =
    match b.right.body with Plain e -> Plain (expr e) | Guarded list -> Guarded (pairs list)
  in
  { left; right = { body; where = all declaration b.right.where }; span }

and parameters (p : type_parameters) = { units = all name p.units; types = all name p.types }

and constructor (c : constructor) : constructor =
  let fields =
    match c.fields with
    | Positional ts -> Positional (all ty ts)
    | Named fields -> Named (all (fun (x, t) -> (name x, ty t)) fields)
  in
  { name = name c.name; fields; span; doc = c.doc }

and declaration (d : declaration) : declaration =
  let desc =
    match d.desc with
    | Signature s -> Signature (signature s)
    | Primitive s -> Primitive (signature s)
    | Binding b -> Binding (binding b)
    | Type_alias { name = x; parameters = p; body } ->
        Type_alias { name = name x; parameters = parameters p; body = ty body }
    | Data { name = x; parameters = p; constructors } ->
        Data
          { name = name x; parameters = parameters p; constructors = all constructor constructors }
    | Class { superclasses; name = x; variable; members } ->
        Class
          {
            superclasses = all qualified superclasses;
            name = name x;
            variable = name variable;
            members = all declaration members;
          }
    | Instance { context; class_; head; members } ->
        Instance
          {
            context = all (fun (c, t) -> (qualified c, ty t)) context;
            class_ = qualified class_;
            head = ty head;
            members = all declaration members;
          }
    | Base_unit x -> Base_unit (name x)
    | Scaled_unit { name = x; scale; unit_ = u } ->
        Scaled_unit { name = name x; scale; unit_ = unit_ u }
    | Foreign (Foreign_value { kind; name = x; ty = t; symbol }) ->
        Foreign (Foreign_value { kind; name = name x; ty = qualified_type t; symbol = name symbol })
    | Foreign (Foreign_type { name = x; c_type; copyable }) ->
        Foreign (Foreign_type { name = name x; c_type = name c_type; copyable })
    | Foreign (Foreign_include header) -> Foreign (Foreign_include (name header))
    | Parameter { name = x; ty = t; value } ->
        Parameter { name = name x; ty = qualified_type t; value = expr value }
    | Claim { kind; label; condition } ->
        Claim { kind; label = name label; condition = expr condition }
    | Check { kind; label; value } -> Check { kind; label = name label; value = expr value }
  in
  { desc; span; doc = d.doc }

let header (h : header) : header =
  { module_name = name h.module_name; exports = Option.map (all name) h.exports; span }

let import (i : import) : import =
  {
    i with
    module_ = name i.module_;
    alias = Option.map name i.alias;
    items = Option.map (all name) i.items;
    span;
  }

let program (p : program) : program =
  {
    p with
    header = Option.map header p.header;
    imports = all import p.imports;
    declarations = all declaration p.declarations;
  }
