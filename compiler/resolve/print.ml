open Format

let bare ppf text =
  if Interface.is_operator text then fprintf ppf "(%s)" text else pp_print_string ppf text

(* Names of the prelude are printed without their module. *)
let global ppf (g : Ir.Global.t) =
  if String.equal g.module_ "Prelude" then bare ppf g.name
  else fprintf ppf "%s.%a" g.module_ bare g.name

(* Identifies a local variable by the place of its binding. Unlike an id, the place does not depend
   on the library. *)
let local ppf (l : Ir.Local.t) =
  fprintf ppf "%s@%d:%d" l.name (Basis.Span.line l.span.start) (Basis.Span.column l.span.start)

let tight_comma ppf () = pp_print_string ppf ", "
let comma ppf () = fprintf ppf ",@ "
let tuple pp ppf xs = fprintf ppf "@[<1>(%a)@]" (pp_print_list ~pp_sep:comma pp) xs
let array pp ppf xs = fprintf ppf "[%a]" (pp_print_list ~pp_sep:tight_comma pp) xs
let words pp ppf xs = List.iter (fun x -> fprintf ppf " %a" pp x) xs
let space ppf () = pp_print_char ppf ' '

(* Types *)

let rational ppf (r : Syntax.Ir.rational) =
  if r.denominator = 1 then fprintf ppf "%d" r.numerator
  else fprintf ppf "(%d/%d)" r.numerator r.denominator

let unit_factor ppf ((factor : Ir.unit_factor), (power : Syntax.Ir.rational)) =
  (match factor with Declared g -> global ppf g | Unit_variable name -> fprintf ppf "'%s" name);
  if power <> { numerator = 1; denominator = 1 } then fprintf ppf "^%a" rational power

let unit_ ppf (u : Ir.unit_) =
  match u.factors with
  | [] -> pp_print_string ppf "1"
  | factors -> pp_print_list ~pp_sep:space unit_factor ppf factors

let units ppf = function
  | [] -> ()
  | us -> fprintf ppf "[%a]" (pp_print_list ~pp_sep:tight_comma unit_) us

let rec ty ppf (t : Ir.ty) =
  match t.desc with
  | Function (a, b) -> fprintf ppf "%a -> %a" applied a ty b
  | Type_variable _ | Named _ | Representation _ | Tuple_type _ | Size _ -> applied ppf t

and applied ppf (t : Ir.ty) =
  match t.desc with
  | Type_variable name -> pp_print_string ppf name
  | Named { tycon; units = us; arguments } ->
      fprintf ppf "%a%a%a" global tycon units us (words argument) arguments
  | Representation { variable; unit_ = u } -> fprintf ppf "%s[%a]" variable unit_ u
  | Tuple_type ts -> tuple ty ppf ts
  | Size n -> pp_print_int ppf n
  | Function _ -> fprintf ppf "(%a)" ty t

and argument ppf (t : Ir.ty) =
  match t.desc with
  | Named { arguments = _ :: _; _ } -> fprintf ppf "(%a)" applied t
  | Named { arguments = []; _ }
  | Type_variable _ | Representation _ | Tuple_type _ | Size _ | Function _ ->
      applied ppf t

let constraint_ ppf (c : Ir.constraint_) = fprintf ppf "%a %a" global c.class_ argument c.argument

let scheme ppf (s : Ir.scheme) =
  match s.context with
  | [] -> ty ppf s.ty
  | context -> fprintf ppf "%a => %a" (tuple constraint_) context ty s.ty

(* Declarations of types and units *)

let parameter ppf (p : Ir.parameter) = pp_print_string ppf p.name

let unit_parameters ppf = function
  | [] -> ()
  | ps -> fprintf ppf "[%a]" (pp_print_list ~pp_sep:tight_comma parameter) ps

let field ppf (f : Ir.field) = fprintf ppf "%s :: %a" f.field_name ty f.ty

let constructor ppf (c : Ir.constructor) =
  if c.record then
    fprintf ppf "%a {%a}" global c.constructor (pp_print_list ~pp_sep:comma field) c.fields
  else
    fprintf ppf "%a%a" global c.constructor
      (words (fun ppf (f : Ir.field) -> argument ppf f.ty))
      c.fields

let type_declaration ppf (d : Ir.type_declaration) =
  let head ppf () =
    fprintf ppf "%a%a%a" global d.tycon unit_parameters d.unit_parameters (words parameter)
      d.type_parameters
  in
  match d.definition with
  | Builtin -> fprintf ppf "@[<2>builtin %a@]" head ()
  | Alias t -> fprintf ppf "@[<2>type %a =@ %a@]" head () ty t
  | Foreign { c_type; copyable } ->
      fprintf ppf "@[<2>foreign type %a =@ %S%s@]" head () c_type
        (if copyable then " copyable" else "")
  | Data constructors ->
      let bar ppf () = fprintf ppf "@ | " in
      fprintf ppf "@[<2>data %a =@ %a@]" head ()
        (pp_print_list ~pp_sep:bar constructor)
        constructors

let unit_declaration ppf (d : Ir.unit_declaration) =
  match d.definition with
  | Base -> fprintf ppf "unit %a" global d.unit_name
  | Scaled (scale, u) ->
      fprintf ppf "@[<2>unit %a =@ %s%s/%s@ %a@]" global d.unit_name scale.factor
        (if scale.times_pi then " pi" else "")
        scale.divided_by unit_ u

(* Patterns *)

let number ppf (n : Ir.number) =
  pp_print_string ppf n.digits;
  Option.iter (fun u -> fprintf ppf "[%a]" unit_ u) n.unit_

let rec pattern ppf (p : Ir.pattern) =
  match p.desc with
  | Any -> pp_print_string ppf "_"
  | Bound l -> local ppf l
  | As (l, p) -> fprintf ppf "%a@@%a" local l pattern p
  | Tuple_of ps -> tuple pattern ppf ps
  | Array_of ps -> array pattern ppf ps
  | Constructed (g, []) -> global ppf g
  | Constructed (g, ps) -> fprintf ppf "(%a%a)" global g (words pattern) ps
  | Literal { negative; number = n } -> fprintf ppf "%s%a" (if negative then "-" else "") number n

(* Expressions *)

let rec expr ppf (e : Ir.expr) =
  match e.desc with
  | If { condition; then_; else_ } ->
      fprintf ppf "@[<2>if %a@ then %a@ else %a@]" expr condition expr then_ expr else_
  | Case { scrutinee; branches } ->
      fprintf ppf "@[<v 2>case %a of" expr scrutinee;
      List.iter (fun b -> fprintf ppf "@,%a" branch b) branches;
      fprintf ppf "@]"
  | Let { declarations = ds; body } ->
      fprintf ppf "@[<v>@[<v 2>let%a@]@,in %a@]" declarations ds expr body
  | Lambda { parameters; body } ->
      fprintf ppf "@[<2>\\%a ->@ %a@]" (pp_print_list ~pp_sep:space pattern) parameters expr body
  | Proc { input; body } ->
      fprintf ppf "@[<v 2>proc %a -> %a%a@]" pattern input expr body.output where body.equations
  | Sequence { statements; result } ->
      let statement ppf : Ir.statement -> unit = function
        | Task { pattern = Some p; task } -> fprintf ppf "@[<2>%a <-@ %a@]" pattern p expr task
        | Task { pattern = None; task } -> expr ppf task
        | Values ds -> fprintf ppf "@[<v 2>let%a@]" declarations ds
      in
      fprintf ppf "@[<v 2>do";
      List.iter (fprintf ppf "@,%a" statement) statements;
      fprintf ppf "@,%a@]" expr result
  | Apply { head; argument; style = Command } ->
      fprintf ppf "@[<2>%a -<@ %a@]" application head expr argument
  | Apply _ -> application ppf e
  | Negate e -> fprintf ppf "-%a" atom e
  | Power { base; exponent } -> fprintf ppf "%a ^ %d" atom base exponent
  | Local _ | Global _ | Constructor _ | Number _ | String _ | Tuple _ | Array _ | Record _
  | Update _ | Field _ | Annotated _ ->
      atom ppf e

and application ppf (e : Ir.expr) =
  match e.desc with
  | Apply { head; argument; style = Juxtaposed | Operator _ } ->
      fprintf ppf "@[<2>%a@ %a@]" application head atom argument
  | _ -> atom ppf e

and atom ppf (e : Ir.expr) =
  match e.desc with
  | Local l -> local ppf l
  | Global g | Constructor g -> global ppf g
  | Number n -> number ppf n
  | String text -> fprintf ppf "%S" text
  | Tuple es -> tuple expr ppf es
  | Array es -> array expr ppf es
  | Record { constructor; fields } -> fprintf ppf "%a {%a}" global constructor assignments fields
  | Update { record; fields; candidates } ->
      fprintf ppf "%a {%a : %a}" atom record assignments fields candidate_list candidates
  | Field { record; field; candidates } ->
      fprintf ppf "%a.%s<%a>" atom record field.text candidate_list candidates
  | Annotated { expr = e; scheme = s } -> fprintf ppf "(%a :: %a)" expr e scheme s
  | If _ | Case _ | Let _ | Lambda _ | Proc _ | Sequence _ | Apply _ | Negate _ | Power _ ->
      fprintf ppf "(%a)" expr e

and candidate_list ppf gs = pp_print_list ~pp_sep:comma global ppf gs

and assignments ppf fields =
  let assignment ppf ((name : Syntax.Ir.name), e) = fprintf ppf "%s = %a" name.text expr e in
  pp_print_list ~pp_sep:comma assignment ppf fields

and branch ppf (b : Ir.branch) =
  right ~head:(fun ppf -> pattern ppf b.pattern) ~sign:"->" ppf b.right

(* Prints the guarded alternatives after their head, then the [where]. *)
and right ~head ~sign ppf (r : Ir.right) =
  let guarded (g : Ir.guarded) =
    Option.iter
      (fun c -> fprintf ppf "@,@[<hv 2>| %a %s@ @[%a@]@]" expr c sign expr g.value)
      g.condition
  in
  (match r.guards with
  | [ { condition = None; value } ] ->
      fprintf ppf "@[<v 2>@[<hv 2>%t %s@ @[%a@]@]" head sign expr value
  | guards ->
      fprintf ppf "@[<v 2>%t" head;
      List.iter guarded guards);
  fprintf ppf "%a@]" where r.where

and where ppf (ds : Ir.declarations) =
  match ds.groups with [] -> () | _ -> fprintf ppf "@,@[<v 2>where%a@]" declarations ds

and declarations ppf (ds : Ir.declarations) =
  List.iter (fun (l, s) -> fprintf ppf "@,%a :: %a" local l scheme s) ds.signatures;
  List.iter (fun g -> fprintf ppf "@,%a" group g) ds.groups

and group ppf (g : Ir.binding_group) =
  match g.bindings with
  | [ b ] when not g.recursive -> binding ppf b
  | bindings ->
      fprintf ppf "@[<v 2>rec%a@]"
        (fun ppf -> List.iter (fun b -> fprintf ppf "@,%a" binding b))
        bindings

and binding ppf (b : Ir.binding) =
  let name ppf (binder : Ir.binder) =
    match binder with
    | Top (g, _) -> global ppf g
    | Inner l -> local ppf l
    | Destructure p -> pattern ppf p
  in
  Option.iter (fun s -> fprintf ppf "@[<2>%a :: %a@]@," name b.name scheme s) b.signature;
  let head ppf = fprintf ppf "%a%a" name b.name (words pattern) b.parameters in
  right ~head ~sign:"=" ppf b.body

(* Classes *)

let class_ ppf (c : Ir.class_) =
  let variable ppf () = pp_print_string ppf c.variable.name in
  let superclass ppf (g, _) = fprintf ppf "%a %a" global g variable () in
  let method_ (m : Ir.method_) =
    fprintf ppf "@,@[<2>%a :: %a@]" global m.name scheme m.scheme;
    Option.iter (fprintf ppf "@,%a" binding) m.default
  in
  fprintf ppf "@[<v 2>class ";
  if c.superclasses <> [] then fprintf ppf "%a => " (tuple superclass) c.superclasses;
  fprintf ppf "%a %a" global c.class_ variable ();
  List.iter method_ c.methods;
  fprintf ppf "@]"

let instance ppf (i : Ir.instance) =
  fprintf ppf "@[<v 2>instance ";
  if i.context <> [] then fprintf ppf "%a => " (tuple constraint_) i.context;
  fprintf ppf "%a %a" global i.class_ argument i.head;
  List.iter (fun (m, b) -> fprintf ppf "@,@[<v 2>%a by@,%a@]" global m binding b) i.definitions;
  fprintf ppf "@]"

(* Programs *)

let of_user (program : Ir.program) =
  let users =
    List.filter_map
      (fun (m : Ir.module_) -> if m.library then None else Some m.name)
      program.modules
  in
  fun (g : Ir.Global.t) -> List.mem g.module_ users

(* An instance belongs to the module that defines its methods or, if it defines none, to the module
   of its class. *)
let shown_instance shown (i : Ir.instance) =
  match i.definitions with
  | (_, { name = Top (g, _); _ }) :: _ -> shown g
  | (_, { name = Inner _ | Destructure _; _ }) :: _ | [] -> shown i.class_

let program ppf (p : Ir.program) =
  let shown = of_user p in
  let line pp x = fprintf ppf "%a@," pp x in
  let module_ ppf (m : Ir.module_) =
    fprintf ppf "%smodule %s" (if m.library then "library " else "") m.name
  in
  let of_shown_group (g : Ir.binding_group) =
    List.exists
      (fun (b : Ir.binding) ->
        match b.name with Top (g, _) -> shown g | Inner _ | Destructure _ -> false)
      g.bindings
  in
  let parameter ppf (p : Ir.param) = fprintf ppf "param %a" global p.param in
  fprintf ppf "@[<v>";
  List.iter (line module_) p.modules;
  List.iter (line unit_declaration)
    (List.filter (fun (d : Ir.unit_declaration) -> shown d.unit_name) p.units);
  List.iter (line type_declaration)
    (List.filter (fun (d : Ir.type_declaration) -> shown d.tycon) p.types);
  List.iter (line class_) (List.filter (fun (c : Ir.class_) -> shown c.class_) p.classes);
  List.iter (line group) (List.filter of_shown_group p.groups);
  List.iter (fun (param : Ir.param) -> if shown param.param then line parameter param) p.params;
  List.iter (line instance)
    (List.filter (fun (i : Ir.instance) -> shown_instance shown i) p.instances);
  fprintf ppf "@]"
