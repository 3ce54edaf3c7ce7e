open Basis
open Interface

type owner = { group : Groups.t; index : int; signed : bool }
type variable = { local : Ir.Local.t; owner : owner option }

type t = {
  scope : Scope.t;
  locals : variable String_map.t;
  around : Syntax.Ir.right list;  (** see {!Fact.unresolved} *)
  sizes : Sizes.t list;  (** variables of the enclosing signatures, innermost first *)
  top_level : Groups.t;
  top_index : int String_table.t;
}

let top scope top_level top_index =
  { scope; locals = String_map.empty; around = []; sizes = []; top_level; top_index }

let inside t (r : Syntax.Ir.right) =
  if t.around <> [] && r.where = [] then t else { t with around = r :: t.around }

let with_sizes t sizes = if sizes = [] then t else { t with sizes = sizes @ t.sizes }
let of_module scope = top scope (Groups.create 0) (String_table.create 1)
let scope t = t.scope
let context t = t.scope.context

let report_twice t ~is_equation (first : Ir.Local.t) (second : Ir.Local.t) =
  Context.report_definition (context t)
    (if Labels.is_name second.name then Two_labels { first = first.span; second = second.span }
     else Defined_twice { first; second; is_equation; text = t.scope.visible.text })

(* Warns about a variable that hides a parameter of the program: within the variable's scope,
   setting the parameter has no effect. *)
let warn_of_param t (inner : Ir.Local.t) =
  let is_it (param : Syntax.Ir.name) = String.equal param.text inner.name in
  match List.find_opt is_it (Lazy.force t.scope.params) with
  | Some param -> Context.warn (context t) (Hides_parameter { param; inner })
  | None -> ()

let bind t variables =
  let add (fresh, locals) variable =
    let name = variable.local.name in
    match String_map.find_opt name fresh with
    | Some first ->
        report_twice t ~is_equation:(Option.is_some variable.owner) first variable.local;
        (fresh, locals)
    | None ->
        (match String_map.find_opt name t.locals with
        | Some outer ->
            Context.warn (context t) (Hides_local { outer = outer.local; inner = variable.local })
        (* no warning for a function's parameter, because callers may pass it the value of the
           program's parameter *)
        | None -> if Option.is_some variable.owner then warn_of_param t variable.local);
        (String_map.add name variable.local fresh, String_map.add name variable locals)
  in
  let _, locals = List.fold_left add (String_map.empty, t.locals) variables in
  { t with locals }

let refer_to_local variable : Ir.expr_desc =
  (match variable.owner with
  | Some { group; index; signed } -> Groups.refer group ~signed index
  | None -> ());
  Local variable.local

let refer_to_value t (value : value) : Ir.expr_desc =
  (if String.equal value.global.module_ t.scope.visible.module_ then
     match String_table.find_opt t.top_index value.global.name with
     | Some index -> Groups.refer t.top_level ~signed:value.signed index
     | None -> ());
  Global value.global

let names t = lazy (String_map.fold (fun name _ names -> name :: names) t.locals [])

let module_level t q =
  Option.map (refer_to_value t) (Lookup.find_value t.scope ~locals:(names t) ~around:t.around q)

let variable t (q : Syntax.Ir.qualified) =
  match q.qualifier with
  | Some _ -> module_level t q
  | None -> (
      match String_map.find_opt q.name.text t.locals with
      | Some variable -> Some (refer_to_local variable)
      | None -> (
          match Sizes.find t.sizes q.name.text with
          | Some size when t.scope.complete && Scope.look t.scope values q.name = None ->
              Context.report_unresolved (context t) (Size_as_value { size; name = q.name });
              None
          | Some _ | None -> module_level t q))

let is_known t (name : Syntax.Ir.name) =
  String_map.mem name.text t.locals || Scope.look t.scope values name <> None
