open Basis
open Interface

type 'a resolver = Env.t -> 'a -> Ir.expr
type right = Definition of Syntax.Ir.right | Run of Syntax.Ir.command | Judged of Syntax.Ir.expr
type item = { left : Syntax.Ir.left; right : right; doc : string option; span : Span.t }

(* The doc comment of a signature also documents the definition. *)
let docs declarations =
  let add docs (d : Syntax.Ir.declaration) =
    match (d.desc, d.doc) with
    | Signature { names; _ }, Some doc ->
        List.fold_left
          (fun docs (name : Syntax.Ir.name) -> String_map.add name.text doc docs)
          docs names
    | _, _ -> docs
  in
  List.fold_left add String_map.empty declarations

let items declarations =
  let docs = docs declarations in
  let doc (left : Syntax.Ir.left) own =
    match (own, left) with
    | None, (Name name | Function_name { name; _ }) -> String_map.find_opt name.text docs
    | _, _ -> own
  in
  let item (d : Syntax.Ir.declaration) =
    match d.desc with
    | Binding b ->
        Some { left = b.left; right = Definition b.right; doc = doc b.left d.doc; span = b.span }
    | Parameter { name; value; ty = _ } ->
        let right = Definition { body = Plain value; where = [] } in
        Some { left = Name name; right; doc = d.doc; span = d.span }
    | Check _ | Signature _ | Type_alias _ | Data _ | Base_unit _ | Scaled_unit _ | Class _
    | Instance _ | Primitive _ | Foreign _ | Claim _ ->
        None
  in
  let check (d : Syntax.Ir.declaration) =
    let defined (name, value) =
      let right = Definition { body = Plain value; where = [] } in
      { left = Name name; right; doc = d.doc; span = d.span }
    in
    List.map defined (Labels.checked d)
  in
  List.filter_map item declarations @ List.concat_map check declarations

let equations declarations =
  let claim (d : Syntax.Ir.declaration) =
    match d.desc with
    | Claim { kind; label; condition } ->
        let name = { label with text = Labels.name kind label.text } in
        Some { left = Name name; right = Judged condition; doc = d.doc; span = d.span }
    | _ -> None
  in
  items declarations @ List.filter_map claim declarations

let signatures declarations =
  let add reversed (d : Syntax.Ir.declaration) =
    match d.desc with
    | Signature { names; ty } -> List.fold_left (fun all n -> (n, ty) :: all) reversed names
    | Parameter { name; ty; value = _ } -> (name, ty) :: reversed
    | Check _ -> List.rev_append (Labels.check_signature d) reversed
    | Binding _ | Type_alias _ | Data _ | Base_unit _ | Scaled_unit _ | Class _ | Instance _
    | Primitive _ | Foreign _ | Claim _ ->
        reversed
  in
  List.rev (List.fold_left add [] declarations)

(* The signatures by name. Reports repeated signatures, and signatures of names that are not bound.
   [names]: the bound names, in source order. *)
let signature_table (scope : Scope.t) ~is_bound ~names signatures =
  let report = Context.report_definition scope.context in
  let add table ((name : Syntax.Ir.name), ty) =
    match String_map.find_opt name.text table with
    | Some (first, _) ->
        report (Two_signatures { first; second = name });
        table
    | None ->
        if not (is_bound name.text) then report (Signature_alone { name; bound = names });
        String_map.add name.text (name, Types.scheme scope ty) table
  in
  List.fold_left add String_map.empty signatures

(* The binder of an item, and the variables it binds. *)
let binder (scope : Scope.t) item : Ir.binder * Ir.Local.t list =
  let inner (name : Syntax.Ir.name) : Ir.binder * Ir.Local.t list =
    let local = Context.fresh scope.context name.text name.span in
    (Inner local, [ local ])
  in
  match item.left with
  | Name name | Function_name { name; _ } | Pattern { desc = Bound name; _ } -> inner name
  | Pattern p ->
      let p = Patterns.pattern scope p in
      (Destructure p, Patterns.variables p)

let bound binders =
  let add bound (local : Ir.Local.t) = String_map.add local.name local bound in
  Array.fold_left
    (fun bound (_, locals) -> List.fold_left add bound locals)
    String_map.empty binders

let variables group table binders =
  let variable index (local : Ir.Local.t) : Env.variable =
    { local; owner = Some { group; index; signed = String_map.mem local.name table } }
  in
  Array.mapi (fun i (_, locals) -> Long_list.map (variable i) locals) binders
  |> Array.to_list |> List.concat_map Fun.id

let signature_of table (local : Ir.Local.t) = Option.map snd (String_map.find_opt local.name table)

(* The signatures of variables bound by destructuring patterns. *)
let destructured table binders =
  let signed local = Option.map (fun s -> (local, s)) (signature_of table local) in
  let of_binder ((name : Ir.binder), locals) =
    match name with Destructure _ -> List.filter_map signed locals | Inner _ | Top _ -> []
  in
  List.concat_map of_binder (Array.to_list binders)

let parameters item =
  match item.left with Function_name { parameters; _ } -> parameters | Name _ | Pattern _ -> []

let sizes (name : Ir.binder) signature parameters =
  match (name, signature) with
  | Top ({ name; _ }, _), Some scheme | Inner { name; _ }, Some scheme ->
      Sizes.of_signature ~name scheme parameters
  | _ -> []

let rec right env ~expr ~command (r : Syntax.Ir.right) : Ir.right =
  let guards =
    match r.body with
    | Plain value -> [ (None, value) ]
    | Guarded guards -> Long_list.map (fun (condition, value) -> (Some condition, value)) guards
  in
  let env = Env.inside env r in
  guarded env ~expr ~command ~guards ~where:r.where

and guarded env ~expr ~command ~guards ~where : Ir.right =
  let env, where =
    declarations env ~expr ~command ~items:(items where) ~signatures:(signatures where)
  in
  let guard (condition, value) : Ir.guarded =
    let condition = Option.map (expr env) condition in
    { condition; value = expr env value }
  in
  { guards = Long_list.map guard guards; where }

and binding env ~expr ~command ~name ~signature item : Ir.binding =
  let env, parameters = Patterns.bind env (parameters item) in
  let env = Env.with_sizes env (sizes name signature parameters) in
  let body =
    match item.right with
    | Definition r -> right env ~expr ~command r
    | Run c ->
        let value : Ir.guarded = { condition = None; value = command env c } in
        { guards = [ value ]; where = { groups = []; signatures = [] } }
    | Judged condition ->
        let argument = expr env condition in
        let head : Ir.expr = { desc = Global Labels.verdict; span = argument.span } in
        let desc : Ir.expr_desc = Apply { head; argument; style = Juxtaposed } in
        let value : Ir.guarded = { condition = None; value = { desc; span = argument.span } } in
        { guards = [ value ]; where = { groups = []; signatures = [] } }
  in
  { name; signature; parameters; body; doc = item.doc; span = item.span }

and declarations env ~expr ~command ~items ~signatures =
  match (items, signatures) with
  | [], [] -> (env, { groups = []; signatures = [] })
  | _ ->
      let items = Array.of_list items in
      let binders = Array.map (binder (Env.scope env)) items in
      let group = Groups.create (Array.length binders) in
      let bound = bound binders in
      let table =
        signature_table (Env.scope env) signatures
          ~is_bound:(fun name -> String_map.mem name bound)
          ~names:(lazy (List.map fst (String_map.bindings bound)))
      in
      let env = Env.bind env (variables group table binders) in
      let resolve i item =
        let name = fst binders.(i) in
        let signature =
          match name with Inner local -> signature_of table local | Top _ | Destructure _ -> None
        in
        Groups.within group i (fun () -> binding env ~expr ~command ~name ~signature item)
      in
      let bindings = Array.mapi resolve items in
      (env, { groups = Groups.sort group bindings; signatures = destructured table binders })

let report_operator (scope : Scope.t) (name : Syntax.Ir.name) =
  Context.report_definition scope.context (Operator_defined name)

(* The definitions of a module by name, in order. Keeps only the first definition of a name.
   {!Declared} reports the others when it collects the module's names. *)
let definitions (scope : Scope.t) declarations =
  let index = String_table.create 16 in
  let add ((count, reversed) as all) item =
    match item.left with
    | Pattern { desc = Bound name; _ } | Name name | Function_name { name; _ } ->
        if is_operator name.text && not scope.library then report_operator scope name;
        if String_table.mem index name.text then all
        else (
          String_table.add index name.text count;
          (count + 1, (name, item) :: reversed))
    | Pattern pattern ->
        Context.report_definition scope.context (Top_level_pattern { at = item.span; pattern });
        all
  in
  let _, reversed = List.fold_left add (0, []) (items declarations) in
  (index, Array.of_list (List.rev reversed))

let top_level (scope : Scope.t) ~expr ~command declarations =
  let index, definitions = definitions scope declarations in
  let group = Groups.create (Array.length definitions) in
  let env = Env.top scope group index in
  let table =
    signature_table scope (signatures declarations) ~is_bound:(String_table.mem index)
      ~names:(lazy (in_order index))
  in
  let resolve i ((name : Syntax.Ir.name), item) =
    let signature = Option.map snd (String_map.find_opt name.text table) in
    let global : Ir.Global.t = { module_ = scope.visible.module_; name = name.text } in
    let name : Ir.binder = Top (global, name.span) in
    Groups.within group i (fun () -> binding env ~expr ~command ~name ~signature item)
  in
  Groups.sort group (Array.mapi resolve definitions)
