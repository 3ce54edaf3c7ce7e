open Basis
open Interface
open Scope

let find_qualified t space (qualifier : Syntax.Ir.name) (name : Syntax.Ir.name) =
  let meant (import : import) = List.mem qualifier.text import.qualifiers in
  let own =
    if String.equal qualifier.text t.module_ then
      String_table.find_opt (space.table t.own) name.text
    else None
  in
  match own with
  | Some entry -> Some entry
  | None when List.exists meant t.imports -> (
      match imported t space meant name.text with
      | [] ->
          if t.complete then
            Diagnostic.error ~code:space.unknown ~at:name.span "module `%s` has no %s `%s`"
              qualifier.text space.noun name.text
            |> Context.suggest t.context name.text
                 (lazy
                   (List.fold_left
                      (fun names (import : import) ->
                        if meant import then names_of (space.table import.names) names else names)
                      [] t.imports))
            |> Context.emit t.context;
          None
      | candidates -> choose t space name candidates)
  | None ->
      if t.complete then Unknown_name.report_module t qualifier name;
      None

let find_with t space ~locals ~signals (q : Syntax.Ir.qualified) =
  match q.qualifier with
  | Some qualifier -> find_qualified t space qualifier q.name
  | None -> (
      match look t space q.name with
      | Some entry -> Some entry
      | None ->
          if t.complete then Unknown_name.report t space ~locals ~signals q.name;
          None)

let find t space q = find_with t space ~locals:(lazy []) ~signals:(lazy []) q
let find_value t ~locals ~signals q = find_with t values ~locals ~signals q

let find_size t (q : Syntax.Ir.qualified) =
  match q.qualifier with
  | None -> size_named t q.name
  | Some qualifier -> (
      let meant (import : import) = List.mem qualifier.text import.qualifiers in
      match (imported t constructors meant q.name.text, imported t tycons meant q.name.text) with
      | [], [ (_, alias) ] -> alias.size
      | _ -> None)
