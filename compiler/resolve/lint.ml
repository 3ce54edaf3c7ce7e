open Basis
module Int_set = Set.Make (Int)

let broken format = Diagnostic.bug ~stage:"Resolve.Lint" format

(* The names declared so far. [bound]: the local variables that have been bound so far. *)
type known = {
  tycons : (Ir.Global.t, int * int * bool) Hashtbl.t;
      (** the number of unit parameters and of type parameters, and whether the units may be omitted
      *)
  constructors : (Ir.Global.t, int) Hashtbl.t;
  units : (Ir.Global.t, unit) Hashtbl.t;
  classes : (Ir.Global.t, unit) Hashtbl.t;
  values : (Ir.Global.t, unit) Hashtbl.t;
  bound : (int, unit) Hashtbl.t;
}

let declare table what (g : Ir.Global.t) x =
  if Hashtbl.mem table g then broken "%s %s.%s is declared twice" what g.module_ g.name;
  Hashtbl.replace table g x

let find table what (g : Ir.Global.t) =
  match Hashtbl.find_opt table g with
  | Some x -> x
  | None -> broken "%s %s.%s is used before it is declared" what g.module_ g.name

(* Types and units *)

let unit_ known (u : Ir.unit_) =
  let factor ((f : Ir.unit_factor), (power : Syntax.Ir.rational)) =
    if power.denominator < 1 then broken "a power without a positive denominator";
    match f with Declared g -> find known.units "unit" g | Unit_variable _ -> ()
  in
  List.iter factor u.factors

let rec ty known (t : Ir.ty) =
  match t.desc with
  | Type_variable _ | Size _ -> ()
  | Representation { unit_ = u; _ } -> unit_ known u
  | Function (a, b) ->
      ty known a;
      ty known b
  | Tuple_type ts -> List.iter (ty known) ts
  | Named { tycon; units; arguments } ->
      let unit_arity, type_arity, optional = find known.tycons "type" tycon in
      let n = List.length units in
      if (not (n = unit_arity || (optional && n = 0))) || List.length arguments <> type_arity then
        broken "type %s has the wrong number of arguments" tycon.name;
      List.iter (unit_ known) units;
      List.iter (ty known) arguments

let class_ known (g : Ir.Global.t) =
  let builtin = String.equal g.module_ "Prelude" && List.mem g.name [ "Eq"; "Ord" ] in
  if not builtin then find known.classes "class" g

let constraint_ known (c : Ir.constraint_) =
  class_ known c.class_;
  ty known c.argument

let scheme known (s : Ir.scheme) =
  List.iter (constraint_ known) s.context;
  ty known s.ty

let type_declaration known (d : Ir.type_declaration) =
  let constructor i (c : Ir.constructor) =
    if c.index <> i then broken "constructor %s has the wrong index" c.constructor.name;
    List.iter (fun (f : Ir.field) -> ty known f.ty) c.fields;
    declare known.constructors "constructor" c.constructor (List.length c.fields)
  in
  let builtin =
    match d.definition with
    | Builtin ->
        if String.equal d.tycon.name "Bool" then
          List.iter
            (fun name -> declare known.constructors "constructor" { d.tycon with name } 0)
            [ "False"; "True" ];
        true
    | Foreign _ -> false
    | Alias t ->
        ty known t;
        false
    | Data [] -> broken "data type %s has no constructors" d.tycon.name
    | Data constructors ->
        List.iteri constructor constructors;
        false
  in
  let arities = (List.length d.unit_parameters, List.length d.type_parameters, builtin) in
  declare known.tycons "type" d.tycon arities

let unit_declaration known (d : Ir.unit_declaration) =
  (match d.definition with Base -> () | Scaled (_, u) -> unit_ known u);
  declare known.units "unit" d.unit_name ()

(* Patterns and expressions; [scope] contains the ids of the visible variables *)

let bind known scope (l : Ir.Local.t) =
  if Hashtbl.mem known.bound l.id then broken "variable %s@%d is bound twice" l.name l.id;
  Hashtbl.replace known.bound l.id ();
  Int_set.add l.id scope

let number known (n : Ir.number) = Option.iter (unit_ known) n.unit_

let rec pattern known scope (p : Ir.pattern) =
  match p.desc with
  | Any -> scope
  | Literal { number = n; _ } ->
      number known n;
      scope
  | Bound l -> bind known scope l
  | As (l, p) -> pattern known (bind known scope l) p
  | Tuple_of ps | Array_of ps -> List.fold_left (pattern known) scope ps
  | Constructed (g, ps) ->
      if find known.constructors "constructor" g <> List.length ps then
        broken "constructor %s has the wrong number of arguments" g.name;
      List.fold_left (pattern known) scope ps

let rec expr known scope (e : Ir.expr) =
  match e.desc with
  | Local l -> if not (Int_set.mem l.id scope) then broken "%s@%d is out of scope" l.name l.id
  | Global g -> find known.values "value" g
  | Constructor g -> ignore (find known.constructors "constructor" g)
  | Number n -> number known n
  | String _ -> ()
  | Tuple es | Array es -> List.iter (expr known scope) es
  | Apply { head; argument; style = _ } ->
      expr known scope head;
      expr known scope argument
  | Negate e | Power { base = e; exponent = _ } | Field { record = e; _ } -> expr known scope e
  | If { condition; then_; else_ } -> List.iter (expr known scope) [ condition; then_; else_ ]
  | Case { scrutinee; branches } ->
      expr known scope scrutinee;
      let branch (b : Ir.branch) = right known (pattern known scope b.pattern) b.right in
      List.iter branch branches
  | Let { declarations = ds; body } -> expr known (declarations known scope ds) body
  | Lambda { parameters; body } -> expr known (List.fold_left (pattern known) scope parameters) body
  | Proc { input; body } ->
      let scope = declarations known (pattern known scope input) body.equations in
      expr known scope body.output
  | Sequence { statements; result } ->
      let statement scope : Ir.statement -> _ = function
        | Task { pattern = p; task } ->
            expr known scope task;
            Option.fold ~none:scope ~some:(pattern known scope) p
        | Values ds -> declarations known scope ds
      in
      expr known (List.fold_left statement scope statements) result
  | Record { constructor; fields } ->
      if find known.constructors "constructor" constructor <> List.length fields then
        broken "a record of %s is not complete" constructor.name;
      List.iter (fun (_, e) -> expr known scope e) fields
  | Update { record; fields; candidates = _ } ->
      expr known scope record;
      List.iter (fun (_, e) -> expr known scope e) fields
  | Annotated { expr = e; scheme = s } ->
      scheme known s;
      expr known scope e

and right known scope (r : Ir.right) =
  if r.guards = [] then broken "a right-hand side without alternatives";
  let scope = declarations known scope r.where in
  let guarded (g : Ir.guarded) =
    Option.iter (expr known scope) g.condition;
    expr known scope g.value
  in
  List.iter guarded r.guards

and declarations known scope (ds : Ir.declarations) =
  let bindings = List.concat_map (fun (g : Ir.binding_group) -> g.bindings) ds.groups in
  let binder scope (b : Ir.binding) =
    match b.name with
    | Inner l -> bind known scope l
    | Destructure p -> pattern known scope p
    | Top (g, _) -> broken "%s is bound inside a definition as a top-level name" g.name
  in
  let scope = List.fold_left binder scope bindings in
  let signature ((l : Ir.Local.t), s) =
    if not (Int_set.mem l.id scope) then
      broken "the signature is for %s@%d, which is out of scope" l.name l.id;
    scheme known s
  in
  List.iter signature ds.signatures;
  List.iter (binding known scope) bindings;
  scope

and binding known scope (b : Ir.binding) =
  Option.iter (scheme known) b.signature;
  right known (List.fold_left (pattern known) scope b.parameters) b.body

let class_declaration known (c : Ir.class_) =
  List.iter (fun (g, _) -> class_ known g) c.superclasses;
  let method_ (m : Ir.method_) =
    declare known.values "value" m.name ();
    scheme known m.scheme;
    match m.default with
    | Some { name = Top (g, _); _ } when g = m.name -> ()
    | Some _ -> broken "the default of the method %s has a different name" m.name.name
    | None -> ()
  in
  List.iter method_ c.methods

let instance known (i : Ir.instance) =
  class_ known i.class_;
  List.iter (constraint_ known) i.context;
  ty known i.head;
  let definition ((m : Ir.Global.t), b) =
    find known.values "value" m;
    binding known Int_set.empty b
  in
  List.iter definition i.definitions

let program (p : Ir.program) =
  let known =
    {
      tycons = Hashtbl.create 64;
      constructors = Hashtbl.create 64;
      units = Hashtbl.create 64;
      classes = Hashtbl.create 16;
      values = Hashtbl.create 256;
      bound = Hashtbl.create 1024;
    }
  in
  List.iter (unit_declaration known) p.units;
  List.iter (type_declaration known) p.types;
  let name_class (c : Ir.class_) = declare known.classes "class" c.class_ () in
  List.iter name_class p.classes;
  let primitive (x : Ir.primitive) =
    declare known.values "value" x.name ();
    scheme known x.scheme
  in
  List.iter primitive p.primitives;
  let bindings = List.concat_map (fun (g : Ir.binding_group) -> g.bindings) p.groups in
  let binder (b : Ir.binding) =
    match b.name with
    | Top (g, _) -> declare known.values "value" g ()
    | Inner l -> broken "%s is bound at top level as a local variable" l.name
    | Destructure _ -> broken "a pattern is bound at top level"
  in
  List.iter binder bindings;
  List.iter (class_declaration known) p.classes;
  let definition (_, (b : Ir.binding)) = binder b in
  List.iter (fun (i : Ir.instance) -> List.iter definition i.definitions) p.instances;
  let default (m : Ir.method_) = Option.iter (binding known Int_set.empty) m.default in
  List.iter (fun (c : Ir.class_) -> List.iter default c.methods) p.classes;
  List.iter (instance known) p.instances;
  List.iter (binding known Int_set.empty) bindings
