open Basis
open Ir

type scope = {
  data : (Global.t, data) Hashtbl.t;
  globals : (Global.t, scheme) Hashtbl.t;  (** schemes of definitions and primitives *)
  methods : (Global.t, scheme) Hashtbl.t;
  bound : (int, unit) Hashtbl.t;  (** all variables bound so far *)
  locals : (int, scheme) Hashtbl.t;  (** variables in scope *)
  parameters : (int, unit) Hashtbl.t;  (** parameters in scope: types, representations and units *)
}

let fail (span : Span.t) format =
  Format.kasprintf
    (fun text -> Diagnostic.bug ~stage:"Typing.Lint" "%a: %s" Span.pp span text)
    format

(* {1 Types} *)

type units = Exactly | But_for_units

let same_power (v, p) (w, q) = v = w && p = q

let same_unit (u : unit_) (v : unit_) =
  List.compare_lengths u.base v.base = 0
  && List.compare_lengths u.variables v.variables = 0
  && List.for_all2 same_power u.base v.base
  && List.for_all2
       (fun ((x : variable), p) ((y : variable), q) -> same_power (x.id, p) (y.id, q))
       u.variables v.variables

let same_representation r s =
  match (r, s) with
  | Int, Int | Float, Float -> true
  | Representation_variable v, Representation_variable w -> v.id = w.id
  | (Int | Float | Representation_variable _), _ -> false

let rec same units (a : ty) (b : ty) =
  a == b
  ||
  match (a, b) with
  | Variable v, Variable w -> v.id = w.id
  | Number (r, u), Number (s, v) ->
      same_representation r s && (units = But_for_units || same_unit u v)
  | Bool, Bool | String, String -> true
  | Size m, Size n -> m = n
  | Tuple ts, Tuple us -> all_same units ts us
  | Function (a, b), Function (c, d) | Signal_function (a, b), Signal_function (c, d) ->
      same units a c && same units b d
  | Data a, Data b ->
      a.tycon = b.tycon
      && all_same units a.arguments b.arguments
      && (units = But_for_units
         || (List.compare_lengths a.units b.units = 0 && List.for_all2 same_unit a.units b.units))
  | ( ( Variable _ | Number _ | Bool | String | Tuple _ | Function _ | Signal_function _ | Data _
      | Size _ ),
      _ ) ->
      false

and all_same units ts us = List.compare_lengths ts us = 0 && List.for_all2 (same units) ts us

let agree ?(units = Exactly) span what ~expected ~found =
  if not (same units expected found) then fail span "%s does not have the expected type" what

let in_scope s span (v : variable) =
  if not (Hashtbl.mem s.parameters v.id) then
    fail span "the type variable `%s` is not in scope" v.name

let closed_unit s span (u : unit_) = List.iter (fun (v, _) -> in_scope s span v) u.variables

let closed_representation s span = function
  | Int | Float -> ()
  | Representation_variable v -> in_scope s span v

let rec closed s span : ty -> unit = function
  | Variable v -> in_scope s span v
  | Number (r, u) ->
      closed_representation s span r;
      closed_unit s span u
  | Bool | String | Size _ -> ()
  | Tuple ts -> List.iter (closed s span) ts
  | Function (a, b) | Signal_function (a, b) ->
      closed s span a;
      closed s span b
  | Data { units; arguments; tycon = _ } ->
      List.iter (closed_unit s span) units;
      List.iter (closed s span) arguments

(* {1 Instances of types} *)

type substitution = { types : (int * ty) list; representations : (int * representation) list }

let rec substitute by : ty -> ty = function
  | Variable v as t -> Option.value (List.assoc_opt v.id by.types) ~default:t
  | Number (Representation_variable v, u) as t -> (
      match List.assoc_opt v.id by.representations with Some r -> Number (r, u) | None -> t)
  | (Number ((Int | Float), _) | Bool | String | Size _) as t -> t
  | Tuple ts -> Tuple (substitutes by ts)
  | Function (a, b) -> Function (substitute by a, substitute by b)
  | Signal_function (a, b) -> Signal_function (substitute by a, substitute by b)
  | Data d -> Data { d with arguments = substitutes by d.arguments }

and substitutes by ts = Long_list.map (substitute by) ts

let pair span (variables : variable list) values =
  if List.compare_lengths variables values <> 0 then
    fail span "%d types for %d type parameters" (List.length values) (List.length variables);
  List.map2 (fun (v : variable) value -> (v.id, value)) variables values

let is_instance s (e : expr) (scheme : scheme) (i : instantiation) =
  List.iter (closed s e.span) i.types;
  List.iter (closed_representation s e.span) i.representations;
  let types = pair e.span scheme.types i.types in
  let representations = pair e.span scheme.representations i.representations in
  let units = if scheme.units = [] then Exactly else But_for_units in
  agree e.span "a use" ~units
    ~expected:(substitute { types; representations } scheme.ty)
    ~found:e.ty

let field_types s span (ty : ty) (c : constructor) =
  match ty with
  | Bool -> []
  | Data { tycon; arguments; _ } -> (
      match Hashtbl.find_opt s.data tycon with
      | Some d ->
          let types = pair span d.type_parameters arguments in
          List.map (fun (_, t) -> substitute { types; representations = [] } t) c.fields
      | None -> fail span "no data type `%s`" tycon.name)
  | Variable _ | Number _ | String | Tuple _ | Function _ | Signal_function _ | Size _ ->
      fail span "the constructor `%s` does not build a value of this type" c.constructor.name

(* {1 Scopes} *)

let with_parameters s (scheme : scheme) f =
  let all = scheme.types @ scheme.representations @ scheme.units in
  List.iter (fun (v : variable) -> Hashtbl.add s.parameters v.id ()) all;
  f ();
  List.iter (fun (v : variable) -> Hashtbl.remove s.parameters v.id) all

let monomorphic ty = { types = []; representations = []; units = []; context = []; ty }

let bind s (x : Local.t) scheme entered =
  if Hashtbl.mem s.bound x.id then fail x.span "`%s` is bound twice" x.name;
  Hashtbl.replace s.bound x.id ();
  Hashtbl.replace s.locals x.id scheme;
  x :: entered

let leave s entered = List.iter (fun (x : Local.t) -> Hashtbl.remove s.locals x.id) entered

(* The element type of the array, which must have this number of elements. *)
let element span (array : ty) parts =
  match array with
  | Data { arguments = [ Size n; element ]; _ } when n = List.length parts -> element
  | _ -> fail span "the type is not that of an array of %d elements" (List.length parts)

let rec pattern s entered (p : pattern) =
  closed s p.span p.ty;
  match p.desc with
  | Any -> entered
  | Bound x -> bind s x (monomorphic p.ty) entered
  | As (x, inner) ->
      agree p.span "a pattern" ~expected:p.ty ~found:inner.ty;
      pattern s (bind s x (monomorphic p.ty) entered) inner
  | Literal _ -> (
      match p.ty with
      | Number _ -> entered
      | Variable _ | Bool | String | Tuple _ | Function _ | Signal_function _ | Data _ | Size _ ->
          fail p.span "a number whose type is not numeric")
  | Tuple_of ps ->
      let types = List.map (fun (p : pattern) -> p.ty) ps in
      agree p.span "a pattern" ~expected:p.ty ~found:(Tuple types);
      List.fold_left (pattern s) entered ps
  | Array_of ps ->
      let expected = element p.span p.ty ps in
      List.iter (fun (p : pattern) -> agree p.span "a pattern" ~expected ~found:p.ty) ps;
      List.fold_left (pattern s) entered ps
  | Constructed (c, ps) ->
      let fields = field_types s p.span p.ty c in
      if List.compare_lengths fields ps <> 0 then
        fail p.span "`%s` has a different number of fields" c.constructor.name;
      List.iter2
        (fun expected (p : pattern) ->
          agree p.span "a pattern" ~units:But_for_units ~expected ~found:p.ty)
        fields ps;
      List.fold_left (pattern s) entered ps

(* {1 Expressions} *)

let is (e : expr) what found = agree e.span what ~expected:e.ty ~found
let types_of es = Long_list.map (fun (e : expr) -> e.ty) es

let local s (e : expr) (x : Local.t) i =
  match Hashtbl.find_opt s.locals x.id with
  | Some scheme -> is_instance s e scheme i
  | None -> fail e.span "`%s` is not in scope" x.name

let global s (e : expr) (g : Global.t) i =
  match Hashtbl.find_opt s.globals g with
  | Some scheme -> is_instance s e scheme i
  | None -> fail e.span "`%s.%s` is not defined" g.module_ g.name

let method_ s (e : expr) (g : Global.t) i =
  match Hashtbl.find_opt s.methods g with
  | Some scheme -> is_instance s e scheme i
  | None -> fail e.span "`%s` is not a method" g.name

let constructor s (e : expr) (c : constructor) =
  let rec result fields (ty : ty) =
    match (fields, ty) with
    | [], _ -> ty
    | _ :: fields, Function (_, ty) -> result fields ty
    | _ :: _, _ -> fail e.span "`%s` lacks fields" c.constructor.name
  in
  let made = result c.fields e.ty in
  let fields = field_types s e.span made c in
  agree e.span "a constructor" ~units:But_for_units ~found:e.ty
    ~expected:(List.fold_right (fun a b : ty -> Function (a, b)) fields made)

let number (e : expr) =
  match e.ty with
  | Number _ -> ()
  | Variable _ | Bool | String | Tuple _ | Function _ | Signal_function _ | Data _ | Size _ ->
      fail e.span "a number whose type is not numeric"

let index (e : expr) (array : expr) k =
  match array.ty with
  | Data { arguments = [ Size n; _ ]; _ } when k < 0 || k >= n ->
      fail e.span "index %d in an array of %d elements" k n
  | Data { arguments = [ _; element ]; _ } -> is e "an element" element
  | _ -> fail e.span "an element of a value that is not an array"

let rec expr s (e : expr) =
  closed s e.span e.ty;
  match e.desc with
  | Local (x, i) -> local s e x i
  | Global (g, i) | Primitive (g, i) -> global s e g i
  | Method { method_ = g; instantiation; class_ = _ } -> method_ s e g instantiation
  | Constructor (c, _) -> constructor s e c
  | Number _ -> number e
  | String _ -> is e "a string" String
  | Tuple es ->
      List.iter (expr s) es;
      is e "a tuple" (Tuple (types_of es))
  | Array es ->
      List.iter (expr s) es;
      let expected = element e.span e.ty es in
      List.iter (fun (a : expr) -> agree a.span "an element" ~expected ~found:a.ty) es
  | Index (a, k) ->
      expr s a;
      index e a k
  | Apply (f, a) ->
      expr s f;
      expr s a;
      agree e.span "what is applied" ~expected:(Function (a.ty, e.ty)) ~found:f.ty
  | Run (h, input) ->
      expr s h;
      expr s input;
      agree e.span "what is run" ~expected:(Signal_function (input.ty, e.ty)) ~found:h.ty
  | Negate a ->
      expr s a;
      is e "a negation" a.ty
  | Power (a, _) ->
      expr s a;
      agree e.span "a power" ~units:But_for_units ~expected:e.ty ~found:a.ty
  | If (condition, a, b) ->
      truth s "a condition" condition;
      expr s a;
      expr s b;
      is e "a branch" a.ty;
      is e "a branch" b.ty
  | Case (scrutinee, branches) ->
      expr s scrutinee;
      List.iter (branch s e scrutinee) branches
  | Let (bindings, body) -> let_ s e bindings body
  | Lambda (patterns, body) ->
      let entered = List.fold_left (pattern s) [] patterns in
      expr s body;
      is e "a function"
        (List.fold_right (fun (p : pattern) b : ty -> Function (p.ty, b)) patterns body.ty);
      leave s entered
  | Guards (guarded, last) ->
      List.iter
        (fun (guard, value) ->
          truth s "a guard" guard;
          guarded_value s e value)
        guarded;
      Option.iter (guarded_value s e) last
  | Proc { input; equations; output } ->
      let entered = List.fold_left (binder s) (pattern s [] input) equations in
      List.iter (value s) equations;
      expr s output;
      is e "a proc" (Signal_function (input.ty, output.ty));
      leave s entered
  | Record (c, fields) -> record s e e.ty c fields
  | Update (r, c, fields) ->
      expr s r;
      agree e.span "an update" ~units:But_for_units ~expected:e.ty ~found:r.ty;
      record s e e.ty c fields
  | Field (r, c, index) ->
      expr s r;
      agree e.span "a field" ~units:But_for_units ~found:e.ty
        ~expected:(field s e.span r.ty c index)

and truth s what (e : expr) =
  expr s e;
  agree e.span what ~expected:Bool ~found:e.ty

and guarded_value s e (value : expr) =
  expr s value;
  is e "a guarded value" value.ty

and branch s e (scrutinee : expr) (b : branch) =
  let entered = pattern s [] b.pattern in
  agree b.pattern.span "a pattern" ~expected:scrutinee.ty ~found:b.pattern.ty;
  expr s b.value;
  is e "a branch" b.value.ty;
  leave s entered

(* Recursive bindings are in scope in all bindings of the list; other bindings are in scope only
   after their own definition. *)
and let_ s e bindings (body : expr) =
  let enter recursive entered b = if b.recursive = recursive then binder s entered b else entered in
  let entered = List.fold_left (enter true) [] bindings in
  let define entered b =
    value s b;
    enter false entered b
  in
  let entered = List.fold_left define entered bindings in
  expr s body;
  is e "a body" body.ty;
  leave s entered

and field s span ty c index =
  match List.nth_opt (field_types s span ty c) index with
  | Some ty -> ty
  | None -> fail span "`%s` has no field %d" c.constructor.name index

and record s e ty c fields =
  let types = Array.of_list (field_types s e.span ty c) in
  List.iter
    (fun (index, (value : expr)) ->
      expr s value;
      if index < 0 || index >= Array.length types then
        fail e.span "`%s` has no field %d" c.constructor.name index;
      agree value.span "a field" ~units:But_for_units ~expected:types.(index) ~found:value.ty)
    fields

and binder s entered (b : binding) =
  let result = ref entered in
  with_parameters s b.scheme (fun () ->
      agree b.span "a pattern" ~expected:b.scheme.ty ~found:b.pattern.ty;
      result :=
        match b.pattern.desc with
        | Bound x -> bind s x b.scheme entered
        | Any | As _ | Tuple_of _ | Array_of _ | Constructed _ | Literal _ ->
            pattern s entered b.pattern);
  !result

and value s (b : binding) =
  with_parameters s b.scheme (fun () ->
      expr s b.value;
      agree b.span "a right side" ~expected:b.scheme.ty ~found:b.value.ty)

(* {1 Classes} *)

let instance s (i : instance) =
  List.iter
    (fun (method_, implementation) ->
      let definition, parameters =
        match implementation with
        | Given g -> (g, i.parameters)
        | Default g -> (g, [ (Hashtbl.find s.methods method_).types |> List.hd ])
      in
      match Hashtbl.find_opt s.globals definition with
      | None -> fail i.span "`%s` is not defined" definition.name
      | Some scheme ->
          let first = List.filteri (fun k _ -> k < List.length parameters) scheme.types in
          if
            List.map (fun (v : variable) -> v.id) first
            <> List.map (fun (v : variable) -> v.id) parameters
          then
            fail i.span "the type parameters of `%s` do not begin with those of its instance"
              definition.name)
    i.methods

(* {1 Programs} *)

let program (p : program) =
  let s =
    {
      data = Hashtbl.create 64;
      globals = Hashtbl.create 256;
      methods = Hashtbl.create 16;
      bound = Hashtbl.create 1024;
      locals = Hashtbl.create 64;
      parameters = Hashtbl.create 16;
    }
  in
  List.iter (fun (d : data) -> Hashtbl.replace s.data d.tycon d) p.data;
  List.iter (fun (g, scheme) -> Hashtbl.replace s.globals g scheme) p.primitives;
  List.iter
    (fun (d : definition) ->
      if Hashtbl.mem s.globals d.name then fail d.span "`%s` is defined twice" d.name.name;
      Hashtbl.replace s.globals d.name d.scheme)
    p.definitions;
  let method_ (g, scheme) = Hashtbl.replace s.methods g scheme in
  List.iter (fun (c : class_declaration) -> List.iter method_ c.methods) p.classes;
  List.iter (instance s) p.instances;
  List.iter
    (fun (d : definition) ->
      with_parameters s d.scheme (fun () ->
          expr s d.value;
          agree d.span "a definition" ~expected:d.scheme.ty ~found:d.value.ty))
    p.definitions
