open Basis
open Syntax.Ir

type space = Value | Constructor | Type | Class | Unit | Field

type mention =
  | Declares of space * name * string option
  | Binds of name
  | Signs of { name : name; binder : name option }
  | Uses of { space : space; name : qualified; within : Span.t }
  | Selects of { field : name; within : Span.t }
  | Imports of { module_ : name; items : name list }
  | Exports of name
  | Local of { declaration : declaration; block : declaration list }

let rec patterns (p : pattern) =
  match p.desc with
  | Any | Literal _ -> []
  | Bound name -> [ name ]
  | As (name, p) -> name :: patterns p
  | Tuple_of ps | Array_of ps | Constructed (_, ps) -> List.concat_map patterns ps
  | Record_of (_, fields) -> List.concat_map (fun (_, p) -> patterns p) fields

(* {1 Types} *)

let unqualified (name : name) : qualified = { qualifier = None; name; span = name.span }

let rec unit_ add (u : unit_) =
  match u.desc with
  | One -> ()
  | Unit_name name -> add (Uses { space = Unit; name = unqualified name; within = name.span })
  | Times (a, b) | Over (a, b) ->
      unit_ add a;
      unit_ add b
  | To (a, _) -> unit_ add a

let rec ty add (t : ty) =
  match t.desc with
  | Type_variable _ | Size _ -> ()
  | Type { name; units; arguments } ->
      add (Uses { space = Type; name; within = t.span });
      List.iter (unit_ add) (Option.value units ~default:[]);
      List.iter (ty add) arguments
  | Representation { unit_ = u; _ } -> unit_ add u
  | Function (a, b) ->
      ty add a;
      ty add b
  | Tuple_type ts -> List.iter (ty add) ts
  | Size_operation { operator = _; left; right } ->
      ty add left;
      ty add right

let constraint_ add ((class_ : qualified), t) =
  add (Uses { space = Class; name = class_; within = class_.span });
  ty add t

let qualified_type add (t : qualified_type) =
  List.iter (constraint_ add) t.context;
  ty add t.ty

(* {1 Expressions} *)

let rec pattern add (p : pattern) =
  match p.desc with
  | Any -> ()
  | Bound name -> add (Binds name)
  | As (name, inner) ->
      add (Binds name);
      pattern add inner
  | Tuple_of ps | Array_of ps -> List.iter (pattern add) ps
  | Constructed (name, ps) ->
      add (Uses { space = Constructor; name; within = p.span });
      List.iter (pattern add) ps
  | Record_of (name, fields) ->
      add (Uses { space = Constructor; name; within = p.span });
      List.iter
        (fun (field, inner) ->
          add (Selects { field; within = p.span });
          pattern add inner)
        fields
  | Literal { number; _ } -> Option.iter (unit_ add) number.unit_

let rec expr add (e : expr) =
  let operator (name : qualified) = add (Uses { space = Value; name; within = name.span }) in
  match e.desc with
  | Variable name -> add (Uses { space = Value; name; within = e.span })
  | Constructor name -> add (Uses { space = Constructor; name; within = e.span })
  | Number number -> Option.iter (unit_ add) number.unit_
  | String _ -> ()
  | Tuple es | Array es -> List.iter (expr add) es
  | Tuple_section es -> List.iter (Option.iter (expr add)) es
  | Apply (a, b) ->
      expr add a;
      expr add b
  | Binary { operator = o; left; right } ->
      expr add left;
      operator o;
      expr add right
  | Negate a | Power { base = a; _ } | Parenthesized a -> expr add a
  | Left_section { left = a; operator = o } | Right_section { operator = o; right = a } ->
      operator o;
      expr add a
  | If { condition; then_; else_ } -> List.iter (expr add) [ condition; then_; else_ ]
  | Case { scrutinee; branches } ->
      expr add scrutinee;
      List.iter (branch add) branches
  | Let { bindings; body } ->
      declarations add bindings;
      expr add body
  | Lambda { parameters; body } ->
      List.iter (pattern add) parameters;
      expr add body
  | Lambda_case branches -> List.iter (branch add) branches
  | Proc { input; body } ->
      pattern add input;
      proc add body
  | Sequence { statements; result } ->
      List.iter
        (function
          | Task { pattern = p; task; _ } ->
              Option.iter (pattern add) p;
              expr add task
          | Let_values ds -> declarations add ds)
        statements;
      expr add result
  | Record { constructor; fields } ->
      add (Uses { space = Constructor; name = constructor; within = e.span });
      assignments add e.span fields
  | Update { record; fields } ->
      expr add record;
      assignments add e.span fields
  | Field { record; field } ->
      expr add record;
      add (Selects { field; within = e.span })
  | Annotated { expr = a; ty } ->
      expr add a;
      qualified_type add ty

and assignments add within fields =
  List.iter
    (fun (field, value) ->
      add (Selects { field; within });
      expr add value)
    fields

and branch add (b : branch) =
  pattern add b.pattern;
  (match b.body with Always e -> expr add e | If_guards guards -> guarded add guards);
  declarations add b.where

and guarded add guards =
  List.iter
    (fun (condition, value) ->
      expr add condition;
      expr add value)
    guards

and proc add = function
  | Output { output; equations } ->
      expr add output;
      declarations add equations
  | Command c -> command add c
  | Do { statements; result } ->
      List.iter
        (function
          | Bind { pattern = p; command = c } ->
              pattern add p;
              command add c
          | Bind_expr { pattern = p; expr = e; _ } ->
              pattern add p;
              expr add e
          | Let_equations ds -> declarations add ds)
        statements;
      command add result

and command add (c : command) =
  expr add c.signal_function;
  expr add c.argument

(* {1 Bindings} *)

and right add (r : right) =
  (match r.body with Plain e -> expr add e | Guarded guards -> guarded add guards);
  declarations add r.where

and binding add ~name (b : binding) =
  (match b.left with
  | Name n -> name n
  | Function_name { name = n; parameters } ->
      name n;
      List.iter (pattern add) parameters
  | Pattern p -> pattern add p);
  right add b.right

and binders (ds : declaration list) =
  List.concat_map
    (fun (d : declaration) ->
      match d.desc with
      | Binding { left = Name n | Function_name { name = n; _ }; _ } -> [ n ]
      | Binding { left = Pattern p; _ } -> patterns p
      | _ -> [])
    ds

and signature add binders (s : signature) =
  let sign (name : name) =
    let binder = List.find_opt (fun (n : name) -> String.equal n.text name.text) binders in
    add (Signs { name; binder })
  in
  List.iter sign s.names;
  qualified_type add s.ty

and declarations add ds =
  let all = lazy (binders ds) in
  List.iter
    (fun (d : declaration) ->
      add (Local { declaration = d; block = ds });
      match d.desc with
      | Signature s -> signature add (Lazy.force all) s
      | Binding b -> binding add ~name:(fun n -> add (Binds n)) b
      | Claim { condition; _ } -> expr add condition
      | _ -> ())
    ds

(* {1 Top-level declarations} *)

let constructor add (c : constructor) =
  add (Declares (Constructor, c.name, None));
  match c.fields with
  | Positional ts -> List.iter (ty add) ts
  | Named fields ->
      List.iter
        (fun (field, t) ->
          add (Declares (Field, field, Some c.name.text));
          ty add t)
        fields

let foreign add = function
  | Foreign_value { name; ty; _ } ->
      add (Declares (Value, name, None));
      qualified_type add ty
  | Foreign_type { name; _ } -> add (Declares (Type, name, None))
  | Foreign_include _ -> ()

let class_member add (d : declaration) =
  match d.desc with
  | Signature s ->
      List.iter (fun name -> add (Declares (Value, name, None))) s.names;
      qualified_type add s.ty
  | Binding b ->
      let name n = add (Uses { space = Value; name = unqualified n; within = n.span }) in
      binding add ~name b
  | _ -> ()

let top add signed (d : declaration) =
  match d.desc with
  | Signature s -> signature add signed s
  | Binding b -> binding add ~name:(fun n -> add (Declares (Value, n, None))) b
  | Type_alias { name; body; _ } ->
      add (Declares (Type, name, None));
      ty add body
  | Data { name; constructors; _ } ->
      add (Declares (Type, name, None));
      List.iter (constructor add) constructors
  | Base_unit name -> add (Declares (Unit, name, None))
  | Scaled_unit { name; unit_ = u; _ } ->
      add (Declares (Unit, name, None));
      unit_ add u
  | Class { superclasses; name; members; _ } ->
      add (Declares (Class, name, None));
      List.iter
        (fun (q : qualified) -> add (Uses { space = Class; name = q; within = q.span }))
        superclasses;
      List.iter (class_member add) members
  | Instance { context; class_; head; members } ->
      List.iter (constraint_ add) context;
      add (Uses { space = Class; name = class_; within = class_.span });
      ty add head;
      List.iter (class_member add) members
  | Primitive s ->
      List.iter (fun name -> add (Declares (Value, name, None))) s.names;
      qualified_type add s.ty
  | Foreign f -> foreign add f
  | Parameter { name; ty; value } ->
      add (Declares (Value, name, None));
      qualified_type add ty;
      expr add value
  | Claim { condition; _ } -> expr add condition
  | Check { value; _ } -> expr add value

let of_program (program : program) =
  let found = ref [] in
  let add mention = found := mention :: !found in
  List.iter
    (fun (i : import) ->
      add (Imports { module_ = i.module_; items = Option.value i.items ~default:[] }))
    program.imports;
  let exports (h : header) =
    List.iter (fun n -> add (Exports n)) (Option.value h.exports ~default:[])
  in
  Option.iter exports program.header;
  let signed = binders program.declarations in
  List.iter (top add signed) program.declarations;
  !found

type declared = (space * string * string option, Span.t) Hashtbl.t

let declared mentions : declared =
  let table = Hashtbl.create 64 in
  let add = function
    | Declares (space, name, record) ->
        Hashtbl.replace table (space, name.Syntax.Ir.text, record) name.span
    | Binds _ | Signs _ | Uses _ | Selects _ | Imports _ | Exports _ | Local _ -> ()
  in
  List.iter add mentions;
  table
