type entry = Exports.entry = { name : string; space : Mentions.space; module_ : string }

type import = {
  of_module : string;
  alias : string option;
  qualified : bool;
  items : string list option;
}

(* {1 Imports} *)

let rec items found : Tokens.token list -> string list option = function
  | { token = LPAREN | COMMA; _ } :: rest -> items found rest
  | { token = UPPER name | LOWER name | OPERATOR name; _ } :: rest -> items (name :: found) rest
  | _ -> Some (List.rev found)

let imports tokens =
  let rec go found : Tokens.token list -> import list = function
    | { token = IMPORT; first = true; _ } :: rest -> (
        let qualified, rest =
          match rest with { token = QUALIFIED; _ } :: rest -> (true, rest) | _ -> (false, rest)
        in
        match rest with
        | { token = UPPER of_module; _ } :: rest ->
            let alias, rest =
              match rest with
              | { token = AS; _ } :: { token = UPPER alias; _ } :: rest -> (Some alias, rest)
              | _ -> (None, rest)
            in
            let items =
              match rest with
              | { token = LPAREN; first = false; _ } :: rest -> items [] rest
              | _ -> None
            in
            go ({ of_module; alias; qualified; items } :: found) rest
        | _ -> go found rest)
    | _ :: rest -> go found rest
    | [] -> List.rev found
  in
  go [] (Array.to_list tokens)

(* {1 Modules} *)

let parsed (ws : Workspace.t) path module_ =
  match Workspace.read ws path with
  | Error _ -> None
  | Ok text ->
      Text_cache.find ws.exports ~path text (fun before ->
          match Exports.of_text ~module_ ~path text with
          (* A module with syntax errors keeps its previous exports. *)
          | None -> Option.join before
          | exports -> exports)

let path_of ws ~directory module_ =
  let beside = Filename.concat directory (module_ ^ ".frob") in
  match Workspace.read ws beside with
  | Ok _ -> beside
  | Error _ -> Filename.concat ws.library (module_ ^ ".frob")

let rec groups_of ws ~directory ~on_the_way module_ =
  let path = path_of ws ~directory module_ in
  if List.mem path on_the_way then []
  else
    match parsed ws path module_ with
    | None -> []
    | Some { Exports.groups; tree } -> (
        match Option.bind tree.header (fun h -> h.exports) with
        | None -> groups
        | Some names ->
            let elsewhere =
              lazy
                (List.concat_map
                   (fun (i : Syntax.Ir.import) ->
                     groups_of ws ~directory:(Filename.dirname path)
                       ~on_the_way:(path :: on_the_way) i.module_.text)
                   tree.imports)
            in
            List.filter_map
              (fun (n : Syntax.Ir.name) ->
                match List.assoc_opt n.text groups with
                | Some entries -> Some (n.text, entries)
                | None ->
                    Option.map
                      (fun entries -> (n.text, entries))
                      (List.assoc_opt n.text (Lazy.force elsewhere)))
              names)

let exports ws ~directory module_ =
  List.concat_map snd (groups_of ws ~directory ~on_the_way:[] module_)

let built_in =
  List.map
    (fun name -> { name; space = Mentions.Type; module_ = "Prelude" })
    [ "Float"; "Int"; "Bool"; "String"; "Array"; "SF"; "Task"; "Program" ]
  @ List.map
      (fun name -> { name; space = Mentions.Constructor; module_ = "Prelude" })
      [ "True"; "False" ]
  @ List.map (fun name -> { name; space = Mentions.Class; module_ = "Prelude" }) [ "Eq"; "Ord" ]

let in_scope ws (doc : Document.t) imports =
  let directory = Filename.dirname doc.path in
  let own =
    match Document.names doc with
    | Some seen ->
        List.concat_map snd
          (Exports.groups (View.program seen.view).main_module (View.tree seen.view))
    | None -> []
  in
  let imported i =
    if i.qualified then []
    else
      let groups = groups_of ws ~directory ~on_the_way:[] i.of_module in
      match i.items with
      | None -> List.concat_map snd groups
      | Some items ->
          List.concat_map (fun item -> Option.value (List.assoc_opt item groups) ~default:[]) items
  in
  List.sort_uniq compare
    (own @ built_in @ exports ws ~directory:ws.library "Prelude" @ List.concat_map imported imports)

let library ws =
  Build.Program_file.files.modules_in ws.Workspace.library
  |> List.filter (( <> ) "Prelude")
  |> List.map (fun module_ -> (module_, exports ws ~directory:ws.library module_))

let modules ws ~directory =
  let in_ folder = Build.Program_file.files.modules_in folder in
  let is_module name = name <> "" && 'A' <= name.[0] && name.[0] <= 'Z' in
  List.filter is_module (List.sort_uniq String.compare (in_ ws.Workspace.library @ in_ directory))
