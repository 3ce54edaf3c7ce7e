open Basis

let contains text word =
  let n = String.length word in
  let rec from i =
    match String.index_from_opt text i word.[0] with
    | Some i when i + n > String.length text -> false
    | Some i -> String.equal (String.sub text i n) word || from (i + 1)
    | None -> false
  in
  n > 0 && from 0

let in_analysis (ws : Workspace.t) symbol (a : Analysis.t) =
  match View.of_analysis ws.declared a with
  | None -> []
  | Some view ->
      let is_it (o : Index.occurrence) = Index.same o.symbol symbol in
      List.map (fun o -> (a, o)) (List.filter is_it (Index.all (View.index view)))

(* Skips files that do not contain the name. *)
let in_file ws (symbol : Index.symbol) path =
  match Workspace.read ws path with
  | Ok text when contains text symbol.name ->
      Option.fold (Workspace.analysis_of ws path) ~none:[] ~some:(in_analysis ws symbol)
  | Ok _ | Error _ -> []

let of_symbol ws (doc : Document.t) params =
  match Definition.symbol_at ws doc params with
  | None -> None
  | Some (seen, { symbol; _ }) ->
      let path = (View.analysis seen.view).path in
      let is_it (o : Index.occurrence) = Index.same o.symbol symbol in
      let here =
        List.filter is_it (Index.all (View.index seen.view))
        |> List.map (fun o -> (View.analysis seen.view, o))
      in
      let elsewhere =
        match symbol.what with
        | Local -> []
        | _ ->
            let others = List.filter (fun p -> not (String.equal p path)) (Workspace.files ws) in
            let declared = Analysis.path_of ~library:ws.library symbol.at.file in
            let others =
              if List.mem declared (path :: others) || symbol.at.file = "" then others
              else declared :: others
            in
            List.concat_map (in_file ws symbol) others
      in
      Some (symbol, here @ elsewhere)

let declares (o : Index.occurrence) = o.declares

let answer ws (doc : Document.t) params : Json.t =
  let with_declaration = Json.(at [ "context"; "includeDeclaration" ] params) <> Json.Bool false in
  match of_symbol ws doc params with
  | None -> List []
  | Some (_, found) ->
      List
        (List.filter_map
           (fun ((a : Analysis.t), (o : Index.occurrence)) ->
             if declares o && not with_declaration then None
             else if String.equal a.path doc.path then
               Option.map
                 (fun range ->
                   Json.Object
                     [ ("uri", String doc.uri); ("range", Workspace.range ws doc.text range) ])
                 (Option.bind (Document.names doc) (fun seen -> View.place seen o.place))
             else Some (Workspace.location ws a.sources o.place))
           found)

let highlights ws (doc : Document.t) params : Json.t =
  match Definition.symbol_at ws doc params with
  | None -> List []
  | Some (seen, { symbol; _ }) ->
      let highlight (o : Index.occurrence) =
        if not (Index.same o.symbol symbol) then None
        else
          Option.map
            (fun range ->
              Json.Object
                [
                  ("range", Workspace.range ws doc.text range);
                  ("kind", Int (if declares o then 3 else 2));
                ])
            (View.place seen o.place)
      in
      List (List.filter_map highlight (Index.all (View.index seen.view)))
