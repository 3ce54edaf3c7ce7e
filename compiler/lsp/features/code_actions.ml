open Basis

let action ?(more = []) ~title ~kind changes : Json.t =
  Object
    ([
       ("title", Json.String title);
       ("kind", String kind);
       ("edit", Object [ ("changes", Object changes) ]);
     ]
    @ more)

let edit range text : Json.t = Object [ ("range", range); ("newText", String text) ]

(* {1 Fixes} *)

let of_fix ws (a : Analysis.t) (d : Diagnostic.t) (fix : Diagnostic.fix) =
  let by_file files (e : Diagnostic.edit) =
    let uri = Workspace.uri_of ws e.span.file in
    let edits = Option.value (List.assoc_opt uri files) ~default:[] in
    let one = edit (Workspace.span_range ws a.sources e.span) e.text in
    (uri, edits @ [ one ]) :: List.remove_assoc uri files
  in
  let changes = List.rev (List.fold_left by_file [] fix.edits) in
  action
    ~title:(Diagnostic.for_display fix.title)
    ~kind:"quickfix"
    (List.map (fun (uri, edits) -> (uri, Json.List edits)) changes)
    ~more:
      [ ("isPreferred", Bool fix.safe); ("diagnostics", List [ Diagnostics.of_diagnostic ws a d ]) ]

let fixes ws (a : Analysis.t) (start, stop) =
  let offset = Source.offset a.sources a.shown in
  let meets (d : Diagnostic.t) =
    String.equal d.at.file a.shown && offset d.at.start <= stop && start <= offset d.at.stop
  in
  List.concat_map
    (fun (d : Diagnostic.t) ->
      List.map (of_fix ws a d) (List.filter_map (Kept_comments.fix a.sources) d.fixes))
    (List.filter meets a.diagnostics)

(* {1 Signatures} *)

let signature ws (doc : Document.t) view facts (a : Analysis.t) (start, stop) =
  let module_ = (View.program view).main_module in
  let offset = Source.offset a.sources a.shown in
  let tree = View.tree view in
  let signed =
    List.concat_map
      (fun (d : Syntax.Ir.declaration) ->
        match d.desc with
        | Signature s -> List.map (fun (n : Syntax.Ir.name) -> n.text) s.names
        | _ -> [])
      tree.declarations
  in
  let of_declaration (d : Syntax.Ir.declaration) =
    match d.desc with
    | Binding { left = Name name | Function_name { name; _ }; _ }
      when (not (List.mem name.text signed))
           && offset d.span.start <= start
           && stop <= offset d.span.stop -> (
        match Place_types.global facts { module_; name = name.text } with
        | None -> None
        | Some scheme ->
            let at = offset d.span.start in
            let line = Printf.sprintf "%s :: %s\n" name.text (Typing.Show.scheme scheme) in
            Some
              (action ~kind:"refactor.rewrite"
                 ~title:(Printf.sprintf "add the signature of `%s`" name.text)
                 [ (doc.uri, List [ edit (Workspace.range ws doc.text (at, at)) line ]) ]))
    | _ -> None
  in
  List.filter_map of_declaration tree.declarations

(* {1 Lifting} *)

let lift ws (doc : Document.t) view range =
  let of_lift (l : Lift.t) =
    let edits = List.map (fun (at, text) -> edit (Workspace.range ws doc.text at) text) l.edits in
    action ~kind:"refactor.extract"
      ~title:(Printf.sprintf "lift `%s` to the top level" l.name)
      [ (doc.uri, List edits) ]
  in
  Option.to_list (Option.map of_lift (Lift.at ws doc view range))

let answer ws (doc : Document.t) params : Json.t =
  let range = Workspace.offsets ws doc.text (Json.member "range" params) in
  let wanted = List.filter_map Json.string Json.(list (at [ "context"; "only" ] params)) in
  let is_wanted kind =
    let is_it w = String.equal w kind || String.starts_with ~prefix:(w ^ ".") kind in
    wanted = [] || List.exists is_it wanted
  in
  match doc.latest with
  | None -> List []
  | Some a ->
      let of_types kind actions =
        match (doc.typed, a.typed) with
        | Some { view; _ }, Some _ when is_wanted kind -> actions view
        | _ -> []
      in
      let signatures view =
        Option.fold (View.facts view) ~none:[] ~some:(fun facts ->
            signature ws doc view facts a range)
      in
      List
        ((if is_wanted "quickfix" then fixes ws a range else [])
        @ of_types "refactor.rewrite" signatures
        @ of_types "refactor.extract" (fun view -> lift ws doc view range))
