open Basis
open Interface

type owner = { group : Groups.t; index : int; signed : bool }
type variable = { local : Ir.Local.t; owner : owner option }

type t = {
  scope : Scope.t;
  locals : variable String_map.t;
  signals : Proc_signals.t list Lazy.t option;
  sizes : Sizes.t list;  (** of the enclosing signatures, innermost first *)
  top_level : Groups.t;
  top_index : int String_table.t;
}

let top scope top_level top_index =
  { scope; locals = String_map.empty; signals = None; sizes = []; top_level; top_index }

let beside_procs t (r : Syntax.Ir.right) =
  match t.signals with
  | None -> { t with signals = Some (lazy Proc_signals.(of_body r.body @ of_right r)) }
  | Some _ when r.where = [] -> t
  | Some around ->
      { t with signals = Some (lazy (Proc_signals.of_body r.body @ Lazy.force around)) }

let with_sizes t sizes = if sizes = [] then t else { t with sizes = sizes @ t.sizes }
let of_module scope = top scope (Groups.create 0) (String_table.create 1)
let scope t = t.scope
let context t = t.scope.context

let report_label_twice t (first : Ir.Local.t) (second : Ir.Local.t) =
  Diagnostic.error ~code:"E0212" ~at:second.span "two assertions here have the same label"
  |> Diagnostic.label ~at:first.span "the first"
  |> Context.emit (context t)

(* The right-hand side of an equation on one line. *)
let value_of t (x : Ir.Local.t) =
  Option.bind (Name_in_text.equation ~text:t.scope.text x.span) (fun equation ->
      let start = String.length x.name + String.length " = " in
      let value = String.sub equation start (String.length equation - start) in
      let is_plain = not (List.mem "where" (String.split_on_char ' ' value)) in
      if is_plain && not (String.contains value '|') then Some value else None)

(* The hint for a second equation: one equation with both values. *)
let one_equation t (first : Ir.Local.t) (second : Ir.Local.t) =
  let name = second.name in
  let because = "an equation holds at every instant, unlike an assignment" in
  match (value_of t first, value_of t second) with
  | Some before, Some after -> (
      let is_constant =
        match before with
        | "True" | "False" -> true
        | _ ->
            let first =
              if before.[0] = '-' && String.length before > 1 then before.[1] else before.[0]
            in
            Character.is_digit first && not (String.contains before ' ')
      in
      (* `v = if stop then 0 else v` overrides a number; with a truth value, it is a latch *)
      let overrides =
        before <> "True" && before <> "False"
        && String.starts_with ~prefix:"if " after
        && String.ends_with ~suffix:(" else " ^ name) after
      in
      let is_constant = is_constant && not overrides in
      let by =
        let previous = Printf.sprintf "delay %s %s" (Source.grouped before) name in
        if not is_constant then Source.grouped before
        else if String.starts_with ~prefix:(name ^ " ") after then previous
        else Source.grouped previous
      in
      match Name_in_text.replaced ~name ~by after with
      | Some (1, value) when is_constant ->
          Printf.sprintf
            "write one equation, in which `delay` returns the previous value: `%s = %s`" name value
      | Some (1, value) -> Printf.sprintf "write one equation, `%s = %s`: %s" name value because
      | None when String.length before + String.length after < 60 ->
          Printf.sprintf
            "write one equation, because %s; to choose between the two values, write `%s = if c \
             then %s else %s`, with your condition for `c`"
            because name after before
      | Some _ | None -> Printf.sprintf "write one equation for `%s`: %s" name because)
  | _ ->
      Printf.sprintf
        "write one equation for `%s`, because %s; for its previous value, write `delay 0 %s`, \
         where 0 is the initial value"
        name because name

let report_twice t ~is_equation (first : Ir.Local.t) (second : Ir.Local.t) =
  if Labels.is_name second.name then report_label_twice t first second
  else
    Diagnostic.error ~code:"E0212" ~at:second.span "`%s` is defined twice here" second.name
    |> Diagnostic.label ~at:first.span "first defined here"
    |> (if not is_equation then Fun.id else Diagnostic.hint (one_equation t first second))
    |> Context.emit (context t)

let warn_hidden t (outer : Ir.Local.t) (inner : Ir.Local.t) =
  Diagnostic.warning ~code:"W0201" ~at:inner.span "`%s` hides a local variable of the same name"
    inner.name
  |> Diagnostic.label ~at:outer.span "this variable is hidden"
  |> Context.emit (context t)

(* Warns about a variable that hides a parameter of the program: within the variable's scope,
   setting the parameter has no effect. *)
let warn_of_param t (inner : Ir.Local.t) =
  let is_it (param : Syntax.Ir.name) = String.equal param.text inner.name in
  match List.find_opt is_it (Lazy.force t.scope.params) with
  | Some param ->
      Diagnostic.warning ~code:"W0201" ~at:inner.span "`%s` hides the parameter of the same name"
        inner.name
      |> Diagnostic.label ~at:param.span "setting this parameter has no effect where it is hidden"
      |> Diagnostic.hint "give one of them another name"
      |> Context.emit (context t)
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
        | Some outer -> warn_hidden t outer.local variable.local
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
  (if String.equal value.global.module_ t.scope.module_ then
     match String_table.find_opt t.top_index value.global.name with
     | Some index -> Groups.refer t.top_level ~signed:value.signed index
     | None -> ());
  Global value.global

let names t = lazy (String_map.fold (fun name _ names -> name :: names) t.locals [])

let module_level t q =
  Option.map (refer_to_value t)
    (Lookup.find_value t.scope ~locals:(names t)
       ~signals:(Option.value t.signals ~default:(lazy []))
       q)

let variable t (q : Syntax.Ir.qualified) =
  match q.qualifier with
  | Some _ -> module_level t q
  | None -> (
      match String_map.find_opt q.name.text t.locals with
      | Some variable -> Some (refer_to_local variable)
      | None -> (
          match Sizes.find t.sizes q.name.text with
          | Some size when t.scope.complete && Scope.look t.scope values q.name = None ->
              Sizes.report (context t) size q.name;
              None
          | Some _ | None -> module_level t q))

let is_known t (name : Syntax.Ir.name) =
  String_map.mem name.text t.locals || Scope.look t.scope values name <> None

let global t text span = module_level t { qualifier = None; name = { text; span }; span }
