open Basis

let can_be_renamed ws (symbol : Index.symbol) =
  match symbol.what with
  | Module -> Error "a module has the name of its file: rename the file"
  | _ when symbol.at.file = "" -> Error (Printf.sprintf "`%s` is built in" symbol.name)
  | _ when Analysis.path_of ~library:ws.Workspace.library symbol.at.file <> symbol.at.file ->
      Error (Printf.sprintf "`%s` belongs to the library" symbol.name)
  | _ -> Ok ()

let prepare ws (doc : Document.t) params : Json.t =
  match Definition.symbol_at ws doc params with
  | Some (seen, { symbol; place; _ }) when can_be_renamed ws symbol = Ok () ->
      Option.fold (View.place seen place) ~none:Json.Null ~some:(fun range : Json.t ->
          Object
            [ ("range", Workspace.range ws doc.text range); ("placeholder", String symbol.name) ])
  | Some _ | None -> Null

(* {1 Names} *)

let tokens_of text =
  let lexer = Syntax.Lexer.create ignore ~file:"" text in
  let first = (Syntax.Lexer.next lexer).token in
  (first, (Syntax.Lexer.next lexer).token)

let check_name (symbol : Index.symbol) name =
  let capital =
    match symbol.what with
    | Constructor _ | Type _ | Class _ -> Some true
    | Local | Value _ | Field _ -> Some false
    | Unit _ | Module -> None
  in
  match (tokens_of name, capital) with
  | (UPPER t, END), (Some true | None) when String.equal t name -> Ok ()
  | (LOWER t, END), (Some false | None) when String.equal t name -> Ok ()
  | ((UPPER _ | LOWER _), END), Some capital ->
      Error
        (Printf.sprintf "this name must begin with a %s letter, unlike `%s`"
           (if capital then "capital" else "lower-case")
           name)
  | _ -> Error (Printf.sprintf "`%s` is not a valid name" name)

(* {1 Edits} *)

(* Renames within one file, from the end to the start, so that the remaining offsets stay valid. *)
let renamed (a : Analysis.t) places name =
  let offset = Source.offset a.sources a.shown in
  let replace text (span : Span.t) =
    Text.replace text (offset span.start) (offset span.stop) name
  in
  List.fold_left replace a.text (List.sort (fun x y -> Span.compare y x) places)

let by_file found =
  let add files ((a : Analysis.t), (o : Index.occurrence)) =
    let places = match List.assoc_opt a.path files with Some (_, ps) -> ps | None -> [] in
    let places = if List.mem o.place places then places else o.place :: places in
    (a.path, (a, places)) :: List.remove_assoc a.path files
  in
  List.rev (List.fold_left add [] found)

let errors (a : Analysis.t) =
  List.filter_map
    (fun (d : Diagnostic.t) -> if d.severity = Error then Some d.code else None)
    a.diagnostics

(* Represents the meaning of each occurrence by a number that does not depend on names, so that
   meanings can be compared before and after renaming. *)
let meaning (ws : Workspace.t) (a : Analysis.t) =
  match View.of_analysis ws.declared a with
  | None -> []
  | Some view ->
      let all = Index.all (View.index view) in
      let numbers = Hashtbl.create 64 in
      List.iteri
        (fun n (o : Index.occurrence) -> if o.declares then Hashtbl.replace numbers o.symbol.at n)
        all;
      let number (symbol : Index.symbol) =
        if String.equal symbol.at.file a.shown then Hashtbl.find_opt numbers symbol.at else None
      in
      List.map (fun (o : Index.occurrence) -> (o.declares, number o.symbol)) all

(* Checks each program after the change, together with the changed versions of the other files. *)
let check ws files name =
  let texts =
    List.map (fun (path, (a, places)) -> (path, Text.contents (renamed a places name))) files
  in
  let read path =
    match List.assoc_opt path texts with Some text -> Ok text | None -> Workspace.read ws path
  in
  let one (path, ((a : Analysis.t), _)) =
    let after = Analysis.check ~library:ws.library ~read ~path (List.assoc path texts) in
    if errors after <> errors a || meaning ws after <> meaning ws a then
      Error
        (Printf.sprintf "`%s` already has a different meaning in %s" name (Filename.basename path))
    else Ok ()
  in
  List.fold_left (fun result file -> Result.bind result (fun () -> one file)) (Ok ()) files

let answer ws (doc : Document.t) params =
  let open Basis.Let_syntax.Result in
  let name = Option.value Json.(string (member "newName" params)) ~default:"" in
  (* Updates the analysis first, because the places must refer to the current text. *)
  Workspace.look ws doc;
  match (References.of_symbol ws doc params, doc.latest) with
  | None, _ -> Error "there is no name here"
  | Some _, Some { resolved = None; _ } ->
      Error "frobc cannot resolve the names in this program: fix its errors first"
  | Some (symbol, found), _ ->
      let* () = can_be_renamed ws symbol in
      let* () = check_name symbol name in
      let files = by_file found in
      let* () = check ws files name in
      let edits (path, ((a : Analysis.t), places)) =
        let edit (place : Span.t) : Json.t =
          Object [ ("range", Workspace.span_range ws a.sources place); ("newText", String name) ]
        in
        (Workspace.uri_of ws path, Json.List (List.map edit places))
      in
      Ok (Json.Object [ ("changes", Object (List.map edits files)) ])
