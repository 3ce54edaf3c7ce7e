open Basis
open Interface

(* {1 Definitions of methods} *)

let report (scope : Scope.t) = Context.report_type scope.context

(* The methods that a block defines, with their names, in order and without duplicates. *)
let definitions (scope : Scope.t) (class_ : class_) members =
  let methods = String_set.of_list class_.methods in
  let add (seen, reversed) (item : Bindings.item) =
    match item.left with
    | Pattern { desc = Bound name; _ } | Name name | Function_name { name; _ } -> (
        match String_map.find_opt name.text seen with
        | Some first ->
            report scope (Method_twice { first; second = name });
            (seen, reversed)
        | None when not (String_set.mem name.text methods) ->
            (* The type checker rejects the whole instance of a built-in class. *)
            if not (is_builtin_class class_) then report scope (Not_a_method { class_; name });
            (seen, reversed)
        | None -> (String_map.add name.text name seen, (name, item) :: reversed))
    | Pattern _ ->
        report scope (Pattern_in_instance item.span);
        (seen, reversed)
  in
  let _, reversed = List.fold_left add (String_map.empty, []) (Bindings.items members) in
  List.rev reversed

let binding env ~expr ~command name (item : Bindings.item) span =
  Bindings.binding env ~expr ~command ~name:(Ir.Top (name, span)) ~signature:None item

(* {1 Classes} *)

let class_ env ~expr ~command (d : Syntax.Ir.declaration) : Ir.class_ option =
  let scope = Env.scope env in
  match d.desc with
  | Class { superclasses; name; variable; members } ->
      let global text : Ir.Global.t = { module_ = scope.visible.module_; name = text } in
      let superclass (q : Syntax.Ir.qualified) =
        Option.map (fun (c : class_) -> (c.global, q.span)) (Lookup.find scope classes q)
      in
      let texts = Long_list.map (fun (m : Syntax.Ir.name) -> m.text) (method_names members) in
      let own = { global = global name.text; methods = texts; span = name.span } in
      let add defaults ((name : Syntax.Ir.name), item) =
        String_map.add name.text
          (binding env ~expr ~command (global name.text) item name.span)
          defaults
      in
      let defaults = List.fold_left add String_map.empty (definitions scope own members) in
      let method_ scheme doc (name : Syntax.Ir.name) : Ir.method_ =
        if is_operator name.text && not scope.library then Bindings.report_operator scope name;
        {
          name = global name.text;
          scheme;
          default = String_map.find_opt name.text defaults;
          doc;
          span = name.span;
        }
      in
      let methods (m : Syntax.Ir.declaration) =
        match m.desc with
        | Signature { names; ty } -> Long_list.map (method_ (Types.scheme scope ty) m.doc) names
        | Binding _ | Type_alias _ | Data _ | Base_unit _ | Scaled_unit _ | Class _ | Instance _
        | Primitive _ | Foreign _ | Parameter _ | Claim _ | Check _ ->
            []
      in
      Some
        {
          class_ = own.global;
          variable = { name = variable.text; span = variable.span };
          superclasses = List.filter_map superclass superclasses;
          methods = List.concat_map methods members;
          doc = d.doc;
          span = name.span;
        }
  | Signature _ | Binding _ | Type_alias _ | Data _ | Base_unit _ | Scaled_unit _ | Instance _
  | Primitive _ | Foreign _ | Parameter _ | Claim _ | Check _ ->
      None

let report_circle scope = function
  | [] -> ()
  | main :: others -> report scope (Class_circle { main; others })

let classes env ~expr ~command (program : Syntax.Ir.program) =
  let scope = Env.scope env in
  let superclasses (c : Ir.class_) =
    List.filter_map
      (fun ((g : Ir.Global.t), _) ->
        if String.equal g.module_ scope.visible.module_ then Some g.name else None)
      c.superclasses
  in
  Declarations.sort
    (List.filter_map (class_ env ~expr ~command) program.declarations)
    ~name:(fun (c : Ir.class_) -> c.class_.name)
    ~uses:superclasses ~report:(report_circle scope)

(* {1 Instances} *)

let constructor_name (head : Ir.ty) =
  match head.desc with
  | Named { tycon; _ } -> tycon.name
  | Tuple_type parts -> "(" ^ String.concat "," (List.map (fun _ -> "") parts) ^ ")"
  | Function _ -> "(->)"
  | Type_variable name | Representation { variable = name; _ } -> name
  | Size n -> string_of_int n

(* Returns an unused name such as [area@Circle]. Names in source code do not contain [@], so they
   cannot clash with it. *)
let rec definition_name taken text =
  if Hashtbl.mem taken text then definition_name taken (text ^ "'")
  else (
    Hashtbl.replace taken text ();
    text)

let instance env ~expr ~command taken (d : Syntax.Ir.declaration) : Ir.instance option =
  let scope = Env.scope env in
  match d.desc with
  | Instance { context; class_; head; members } ->
      let span = Span.merge class_.span head.span in
      let context = Types.context scope context in
      let head = Types.ty scope Quantified head in
      let of_class (found : class_) : Ir.instance =
        List.iter
          (fun (name, _) -> report scope (Signature_in_instance { class_ = found; name }))
          (Bindings.signatures members);
        let definition ((name : Syntax.Ir.name), item) =
          let method_ : Ir.Global.t = { found.global with name = name.text } in
          let text = definition_name taken (name.text ^ "@" ^ constructor_name head) in
          let own : Ir.Global.t = { module_ = scope.visible.module_; name = text } in
          (method_, binding env ~expr ~command own item name.span)
        in
        let given = definitions scope found members in
        { class_ = found.global; context; head; definitions = Long_list.map definition given; span }
      in
      Option.map of_class (Lookup.find scope Interface.classes class_)
  | Signature _ | Binding _ | Type_alias _ | Data _ | Base_unit _ | Scaled_unit _ | Class _
  | Primitive _ | Foreign _ | Parameter _ | Claim _ | Check _ ->
      None

let instances env ~expr ~command (program : Syntax.Ir.program) =
  let taken = Hashtbl.create 16 in
  List.filter_map (instance env ~expr ~command taken) program.declarations
