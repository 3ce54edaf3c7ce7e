open Basis
open Ir

type scope = {
  data : (Global.t, Ir.data) Hashtbl.t;
  fields : (Global.t, (string * ty) list array) Hashtbl.t;  (** fields by constructor *)
  globals : (Global.t, variable list * ty) Hashtbl.t;
  foreign : (Primitive.foreign * ty) list;
  bound : (int, unit) Hashtbl.t;  (** all variables bound so far *)
  locals : (int, ty) Hashtbl.t;  (** variables in scope *)
  parameters : (int, unit) Hashtbl.t;  (** type variables in scope *)
}

let fail (span : Span.t) format =
  Format.kasprintf (fun text -> Diagnostic.bug ~stage:"Core.Lint" "%a: %s" Span.pp span text) format

(* {1 Types} *)

let rec same (a : ty) (b : ty) =
  a == b
  ||
  match (a, b) with
  | Variable v, Variable w -> v.id = w.id
  | Bool, Bool | Int, Int | Float, Float | String, String -> true
  | Array (m, a), Array (n, b) -> same m n && same a b
  | Size m, Size n -> m = n
  | Tuple ts, Tuple us -> all_same ts us
  | Function (a, b), Function (c, d) | Signal_function (a, b), Signal_function (c, d) ->
      same a c && same b d
  | Data (t, ts), Data (u, us) -> t = u && all_same ts us
  | ( ( Variable _ | Bool | Int | Float | String | Tuple _ | Function _ | Signal_function _ | Data _
      | Array _ | Size _ ),
      _ ) ->
      false

and all_same ts us = List.compare_lengths ts us = 0 && List.for_all2 same ts us

let agree span ~expected ~found =
  if not (same expected found) then
    fail span "expected type %a, found %a" Print.ty expected Print.ty found

let rec closed s span = function
  | Variable v ->
      if not (Hashtbl.mem s.parameters v.id) then
        fail span "type variable `%s` is not in scope" v.name
  | Bool | Int | Float | String | Size _ -> ()
  | Tuple ts | Data (_, ts) -> List.iter (closed s span) ts
  | Function (a, b) | Signal_function (a, b) | Array (a, b) ->
      closed s span a;
      closed s span b

let instantiate s span (parameters, ty) types =
  List.iter (closed s span) types;
  if List.compare_lengths parameters types <> 0 then
    fail span "%d type arguments for %d parameters" (List.length types) (List.length parameters);
  if parameters = [] then ty else Erasure.substitute (List.combine parameters types) ty

let field_types s span ty constructor =
  match ty with
  | Data (tycon, types) -> (
      match (Hashtbl.find_opt s.data tycon, Hashtbl.find_opt s.fields tycon) with
      | Some d, Some fields when constructor >= 0 && constructor < Array.length fields ->
          List.map
            (fun (_, field) -> instantiate s span (d.parameters, field) types)
            fields.(constructor)
      | Some _, Some _ -> fail span "`%s` has no constructor %d" tycon.name constructor
      | _ -> fail span "`%s` is not a data type" tycon.name)
  | Variable _ | Bool | Int | Float | String | Tuple _ | Function _ | Signal_function _ | Array _
  | Size _ ->
      fail span "%a has no constructors" Print.ty ty

(* {1 Scopes} *)

let with_parameters s span (parameters : variable list) f =
  List.iter
    (fun (v : variable) ->
      if Hashtbl.mem s.parameters v.id then fail span "type variable `%s` is bound twice" v.name;
      Hashtbl.replace s.parameters v.id ())
    parameters;
  let result = f () in
  List.iter (fun (v : variable) -> Hashtbl.remove s.parameters v.id) parameters;
  result

let enter s ({ local; ty } : binder) =
  if Hashtbl.mem s.bound local.id then fail local.span "`%s` is bound twice" local.name;
  Hashtbl.replace s.bound local.id ();
  Hashtbl.replace s.locals local.id ty;
  closed s local.span ty

let leave s ({ local; _ } : binder) = Hashtbl.remove s.locals local.id

(* {1 Expressions} *)

let is (e : expr) found = agree e.span ~expected:e.ty ~found

let local s (e : expr) (x : Local.t) =
  match Hashtbl.find_opt s.locals x.id with
  | Some ty -> is e ty
  | None -> fail e.span "`%s` (%d) is not in scope" x.name x.id

let global s (e : expr) (g : Global.t) types =
  match Hashtbl.find_opt s.globals g with
  | Some scheme -> is e (instantiate s e.span scheme types)
  | None -> fail e.span "`%s.%s` is not defined" g.module_ g.name

let primitive s (e : expr) p types =
  List.iter (closed s e.span) types;
  match (Signature.of_primitive p types, p) with
  | Some ty, _ -> is e ty
  | None, Foreign f when types = [] -> (
      match List.assoc_opt f s.foreign with
      | Some ty -> is e ty
      | None -> fail e.span "`%s` is not imported" f.foreign_name)
  | None, _ ->
      fail e.span "primitive `%s` does not take %d type arguments" (Primitive_table.name p)
        (List.length types)

let method_ s (e : expr) ty types =
  List.iter (closed s e.span) (ty :: types);
  match ty with
  | Variable _ -> ()
  | Bool | Int | Float | String | Tuple _ | Function _ | Signal_function _ | Data _ | Array _
  | Size _ ->
      fail e.span "a method is used at the known type %a" Print.ty ty

let number (e : expr) =
  match e.ty with
  | Int | Float | Variable _ -> ()
  | Bool | String | Tuple _ | Function _ | Signal_function _ | Data _ | Array _ | Size _ ->
      fail e.span "a number cannot have type %a" Print.ty e.ty

let application (e : expr) (f : expr) (a : expr) =
  match f.ty with
  | Function (parameter, result) ->
      agree a.span ~expected:parameter ~found:a.ty;
      is e result
  | Variable _ | Bool | Int | Float | String | Tuple _ | Signal_function _ | Data _ | Array _
  | Size _ ->
      fail f.span "a value of type %a cannot be applied" Print.ty f.ty

let array (e : expr) elements =
  match e.ty with
  | Array (Size n, element) when n = List.length elements ->
      List.iter (fun (a : expr) -> agree a.span ~expected:element ~found:a.ty) elements
  | _ ->
      fail e.span "an array of %d elements cannot have type %a" (List.length elements) Print.ty e.ty

let index (e : expr) (array : expr) k =
  match array.ty with
  | Array (Size n, _) when k < 0 || k >= n ->
      fail e.span "there is no element %d in an array of %d elements" k n
  | Array (_, element) -> is e element
  | _ -> fail e.span "there is no element %d in a value of type %a" k Print.ty array.ty

let component (e : expr) (value : expr) index =
  match value.ty with
  | Tuple types when index >= 0 && index < List.length types -> is e (List.nth types index)
  | _ -> fail e.span "there is no component %d in a value of type %a" index Print.ty value.ty

let construct s (e : expr) (data : Global.t) constructor arguments =
  (match e.ty with
  | Data (tycon, _) when tycon = data -> ()
  | _ -> fail e.span "a `%s` cannot have type %a" data.name Print.ty e.ty);
  let fields = field_types s e.span e.ty constructor in
  if List.compare_lengths fields arguments <> 0 then
    fail e.span "%d arguments for %d fields" (List.length arguments) (List.length fields);
  List.iter2 (fun field (a : expr) -> agree a.span ~expected:field ~found:a.ty) fields arguments

let payload s (e : expr) (value : expr) constructor field =
  match List.nth_opt (field_types s e.span value.ty constructor) field with
  | Some ty -> is e ty
  | None -> fail e.span "constructor %d has no field %d" constructor field

let rec expr s (e : expr) =
  closed s e.span e.ty;
  match e.desc with
  | Local x -> local s e x
  | Global (g, types) -> global s e g types
  | Primitive (p, types) -> primitive s e p types
  | Method { ty; types; _ } -> method_ s e ty types
  | Number _ -> number e
  | Boolean _ -> is e Bool
  | String _ -> is e String
  | Lambda (b, body) ->
      enter s b;
      expr s body;
      leave s b;
      is e (Function (b.ty, body.ty))
  | Apply (f, a) ->
      expr s f;
      expr s a;
      application e f a
  | Let _ -> lets s e.ty [] e
  | Tuple parts ->
      List.iter (expr s) parts;
      is e (Tuple (Long_list.map (fun (e : expr) -> e.ty) parts))
  | Array elements ->
      List.iter (expr s) elements;
      array e elements
  | Index (array, k) ->
      expr s array;
      index e array k
  | Component (value, index) ->
      expr s value;
      component e value index
  | Construct { data; constructor; arguments } ->
      List.iter (expr s) arguments;
      construct s e data constructor arguments
  | Is_constructor (value, constructor) ->
      expr s value;
      ignore (field_types s e.span value.ty constructor);
      is e Bool
  | Payload { value; constructor; field } ->
      expr s value;
      payload s e value constructor field
  | If (condition, a, b) ->
      expr s condition;
      agree condition.span ~expected:Bool ~found:condition.ty;
      expr s a;
      is e a.ty;
      expr s b;
      is e b.ty
  | Proc p -> is e (proc s p)

(* A chain of bindings may be as long as the program, so this loop is tail-recursive. *)
and lets s ty entered (e : expr) =
  match e.desc with
  | Let { binder; value; body } ->
      expr s value;
      agree value.span ~expected:binder.ty ~found:value.ty;
      enter s binder;
      agree e.span ~expected:ty ~found:e.ty;
      lets s ty (binder :: entered) body
  | _ ->
      expr s e;
      agree e.span ~expected:ty ~found:e.ty;
      List.iter (leave s) entered

and proc s (p : proc) =
  enter s p.input;
  List.iter (fun (eq : equation) -> enter s eq.binder) p.equations;
  List.iter (equation s) p.equations;
  expr s p.output;
  List.iter (fun (eq : equation) -> leave s eq.binder) p.equations;
  leave s p.input;
  Signal_function (p.input.ty, p.output.ty)

and equation s (eq : equation) =
  match eq.rhs with
  | Pure value ->
      expr s value;
      agree eq.span ~expected:eq.binder.ty ~found:value.ty
  | Run { signal_function; input } ->
      expr s signal_function;
      expr s input;
      agree eq.span ~expected:(Signal_function (input.ty, eq.binder.ty)) ~found:signal_function.ty

(* {1 Programs} *)

let instance s (i : instance) =
  List.iter
    (fun (name, implementation) ->
      let definition = match implementation with Given g | Default g -> g in
      if not (Hashtbl.mem s.globals definition) then
        Diagnostic.bug ~stage:"Core.Lint" "the method `%s` has no definition" name)
    i.methods

let program (p : program) =
  let s =
    {
      data = Hashtbl.create 64;
      fields = Hashtbl.create 64;
      globals = Hashtbl.create 256;
      foreign = p.foreign.values;
      bound = Hashtbl.create 1024;
      locals = Hashtbl.create 64;
      parameters = Hashtbl.create 16;
    }
  in
  List.iter
    (fun (d : data) ->
      let fields = Array.of_list (List.map (fun (c : constructor) -> c.fields) d.constructors) in
      with_parameters s d.span d.parameters (fun () ->
          Array.iter (List.iter (fun (_, ty) -> closed s d.span ty)) fields);
      Hashtbl.replace s.data d.tycon d;
      Hashtbl.replace s.fields d.tycon fields)
    p.data;
  List.iter
    (fun (d : definition) ->
      if Hashtbl.mem s.globals d.name then fail d.span "`%s` is defined twice" d.name.name;
      Hashtbl.replace s.globals d.name (d.parameters, d.ty))
    p.definitions;
  List.iter (instance s) p.instances;
  List.iter
    (fun (d : definition) ->
      with_parameters s d.span d.parameters (fun () ->
          expr s d.body;
          agree d.span ~expected:d.ty ~found:d.body.ty))
    p.definitions;
  List.iter
    (fun (param : param) ->
      let check g =
        match Hashtbl.find_opt s.globals g with
        | Some ([], ty) -> agree param.span ~expected:param.ty ~found:ty
        | Some (_ :: _, _) | None -> fail param.span "the parameter `%s` has no value" param.label
      in
      List.iter check (param.param :: Option.to_list param.given))
    p.params
