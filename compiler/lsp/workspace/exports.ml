open Basis

type entry = { name : string; space : Mentions.space; module_ : string }
type t = { groups : (string * entry list) list; tree : Syntax.Ir.program }

let groups module_ (tree : Syntax.Ir.program) =
  let entry space (name : Syntax.Ir.name) = { name = name.text; space; module_ } in
  let value (name : Syntax.Ir.name) = (name.text, [ entry Mentions.Value name ]) in
  let constructor (c : Syntax.Ir.constructor) =
    entry Mentions.Constructor c.name
    ::
    (match c.fields with
    | Positional _ -> []
    | Named fields -> List.map (fun (f, _) -> entry Mentions.Field f) fields)
  in
  let declaration (d : Syntax.Ir.declaration) =
    match d.desc with
    | Signature _ | Instance _ | Claim _ | Check _ | Foreign (Foreign_include _) -> []
    | Binding { left = Name n | Function_name { name = n; _ }; _ } -> [ value n ]
    | Binding { left = Pattern _; _ } -> []
    | Type_alias { name; _ } | Foreign (Foreign_type { name; _ }) ->
        [ (name.text, [ entry Type name ]) ]
    | Data { name; constructors; _ } ->
        [ (name.text, entry Type name :: List.concat_map constructor constructors) ]
    | Base_unit name | Scaled_unit { name; _ } -> [ (name.text, [ entry Unit name ]) ]
    | Class { name; members; _ } ->
        let methods =
          List.concat_map
            (fun (d : Syntax.Ir.declaration) ->
              match d.desc with Signature s -> s.names | _ -> [])
            members
        in
        [ (name.text, entry Class name :: List.map (entry Mentions.Value) methods) ]
    | Primitive s -> List.map value s.names
    | Foreign (Foreign_value { name; _ }) | Parameter { name; _ } -> [ value name ]
  in
  List.concat_map declaration tree.declarations

let of_text ~module_ ~path text =
  let file = Filename.basename (Filename.dirname path) ^ "/" ^ Filename.basename path in
  let tree =
    match Prepared.Library.tree ~file text with
    | Some tree -> Some tree
    | None -> Syntax.Parse.program (Facts.ignored ()) ~file:path text
  in
  Option.map (fun tree -> { groups = groups module_ tree; tree }) tree
