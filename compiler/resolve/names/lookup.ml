open Basis
open Interface

let find_qualified (t : Scope.t) space (qualifier : Syntax.Ir.name) (name : Syntax.Ir.name) =
  let meant (import : Visible.import) = List.mem qualifier.text import.qualifiers in
  let own =
    if String.equal qualifier.text t.visible.module_ then
      String_table.find_opt (space.table t.visible.own) name.text
    else None
  in
  match own with
  | Some entry -> Some entry
  | None when List.exists meant t.visible.imports -> (
      match Visible.imported t.visible space meant name.text with
      | [] ->
          let known =
            lazy
              (List.fold_left
                 (fun names (import : Visible.import) ->
                   if meant import then Visible.names_of (space.table import.names) names else names)
                 [] t.visible.imports)
          in
          if t.complete then
            Context.report_unresolved t.context
              (Unknown_in_module { space = Any space; qualifier; name; known });
          None
      | candidates -> Scope.choose t space name candidates)
  | None ->
      if t.complete then Context.report_unresolved t.context (Unknown_qualifier { qualifier; name });
      None

let find_with (t : Scope.t) space ~locals ~around (q : Syntax.Ir.qualified) =
  match q.qualifier with
  | Some qualifier -> find_qualified t space qualifier q.name
  | None -> (
      match Scope.look t space q.name with
      | Some entry -> Some entry
      | None ->
          if t.complete then
            Context.report_unresolved t.context
              (Unknown { space = Any space; name = q.name; locals; around });
          None)

let find t space q = find_with t space ~locals:(lazy []) ~around:[] q
let find_value t ~locals ~around q = find_with t values ~locals ~around q

let find_size (t : Scope.t) (q : Syntax.Ir.qualified) =
  match q.qualifier with
  | None -> Scope.size_named t q.name
  | Some qualifier -> (
      let meant (import : Visible.import) = List.mem qualifier.text import.qualifiers in
      let known space = Visible.imported t.visible space meant q.name.text in
      match (known constructors, known tycons) with [], [ (_, alias) ] -> alias.size | _ -> None)
