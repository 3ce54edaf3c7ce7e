open Basis

(* Writes the explanation of a diagnostic code to a file, because every editor can open files. *)
let page_uri code =
  let make page ~folder:_ path =
    match open_out_bin path with
    | channel ->
        output_string channel page;
        close_out channel;
        Ok ()
    | exception Sys_error reason -> Error reason
  in
  let of_page page =
    let key = Digest.to_hex (Digest.string page) in
    match Build.Cache.entry ~name:code ~key ~suffix:".md" ~reuse:true (make page) with
    | Ok path -> Some (Uri.of_path path)
    | Error _ -> None
  in
  Option.bind (Explain.find code) of_page

let link (ws : Workspace.t) code =
  match Hashtbl.find_opt ws.explanations code with
  | Some uri -> uri
  | None ->
      let uri = page_uri code in
      Hashtbl.replace ws.explanations code uri;
      uri

let text (d : Diagnostic.t) =
  let show = Diagnostic.for_display in
  let here = List.map show (Option.to_list d.here) in
  let notes = List.map (fun note -> "note: " ^ show note) d.notes in
  let hints = List.map (fun (hint : Diagnostic.hint) -> "hint: " ^ show hint.text) d.hints in
  String.concat "\n" ((show d.message :: here) @ notes @ hints)

let is_unused code = List.mem code [ "W0304"; "W0305"; "W0306" ]

let related ws (a : Analysis.t) ((at : Span.t), message) : Json.t =
  Object
    [
      ("location", Workspace.location ws a.sources at);
      ("message", String (Diagnostic.for_display message));
    ]

let labels (d : Diagnostic.t) = List.map (fun (l : Diagnostic.label) -> (l.at, l.text)) d.labels

let make ws ~range ~severity ~message ?code ~related () : Json.t =
  let of_code code : (string * Json.t) list =
    let description =
      match link ws code with
      | Some uri -> [ ("codeDescription", Json.Object [ ("href", String uri) ]) ]
      | None -> []
    in
    (("code", Json.String code) :: description)
    @ if is_unused code then [ ("tags", List [ Int 1 ]) ] else []
  in
  Object
    ([ ("range", range); ("severity", Json.Int severity) ]
    @ Option.fold code ~none:[] ~some:of_code
    @ [
        ("source", Json.String "frobc");
        ("message", String message);
        ("relatedInformation", List related);
      ])

let severity (d : Diagnostic.t) = match d.severity with Error -> 1 | Warning -> 2

(* The place where another module is imported. Messages about that module are shown there. *)
let import_of text file =
  let module_ = Filename.remove_extension (Filename.basename file) in
  let lines = String.split_on_char '\n' text in
  let rec find offset = function
    | [] -> (0, 0)
    | line :: rest -> (
        match String.split_on_char ' ' line with
        | "import" :: words when List.mem module_ words ->
            (offset, offset + String.length (String.trim line))
        | _ -> find (offset + String.length line + 1) rest)
  in
  find 0 lines

let of_diagnostic ws (a : Analysis.t) (d : Diagnostic.t) =
  let severity = severity d in
  if String.equal d.at.file a.shown || String.equal d.at.file a.path then
    make ws
      ~range:(Workspace.span_range ws a.sources d.at)
      ~severity ~message:(text d) ~code:d.code
      ~related:(List.map (related ws a) (labels d))
      ()
  else
    make ws
      ~range:(Workspace.range ws a.text (import_of (Text.contents a.text) d.at.file))
      ~severity
      ~message:(Printf.sprintf "in %s: %s" (Filename.basename d.at.file) (text d))
      ~code:d.code
      ~related:(List.map (related ws a) ((d.at, d.message) :: labels d))
      ()

let parameters ws (doc : Document.t) : Json.t =
  let of_analysis (a : Analysis.t) =
    let fault message =
      make ws ~range:(Workspace.range ws a.text (0, 0)) ~severity:1 ~message ~related:[] ()
    in
    List.map (of_diagnostic ws a) a.diagnostics @ Option.to_list (Option.map fault a.fault)
  in
  Object
    [
      ("uri", String doc.uri);
      ("version", doc.version);
      ("diagnostics", List (Option.fold doc.latest ~none:[] ~some:of_analysis));
    ]

let none uri : Json.t = Object [ ("uri", String uri); ("diagnostics", List []) ]
