open Basis
open Json_reader

type t = {
  ws : Workspace.t;
  wire : Wire.t;
  waiting : Json.t Queue.t;
  mutable cancelled : Json.t list;  (** ids of requests *)
  mutable shut_down : bool;
  mutable exit : int option;
}

let send message = Wire.write stdout message

let notify method_ params =
  send (Object [ ("jsonrpc", String "2.0"); ("method", String method_); ("params", params) ])

let answer id = function
  | Ok result -> send (Object [ ("jsonrpc", String "2.0"); ("id", id); ("result", result) ])
  | Error (code, message) ->
      let error = Json.Object [ ("code", Int code); ("message", String message) ] in
      send (Object [ ("jsonrpc", String "2.0"); ("id", id); ("error", error) ])

let parse_error = -32700
let invalid_request = -32600
let method_not_found = -32601
let internal_error = -32603
let request_cancelled = -32800
let request_failed = -32803

(* In the editor's log. *)
let log message =
  notify "window/logMessage" (Object [ ("type", Int 1); ("message", String message) ])

(* {1 Looking at texts} *)

let publish t (doc : Document.t) =
  Option.iter log (Option.bind doc.latest (fun (a : Analysis.t) -> a.fault));
  match Analysis.guarded (fun () -> Diagnostics.parameters t.ws doc) with
  | Ok parameters -> notify "textDocument/publishDiagnostics" parameters
  | Error fault -> log fault

(* A text is looked at again when a module that it reads may have changed. *)
let touched t path =
  Hashtbl.iter
    (fun _ (doc : Document.t) ->
      match doc.latest with
      | Some a when Source.text a.sources path <> None || a.diagnostics <> [] -> doc.changed <- true
      | Some _ | None -> ())
    t.ws.documents

(* One of those that wait; the other ones' turn comes after messages that have arrived meanwhile. *)
let look_at_one t =
  let changed _ (doc : Document.t) found =
    match found with Some _ -> found | None -> if doc.changed then Some doc else None
  in
  match Hashtbl.fold changed t.ws.documents None with
  | None -> false
  | Some doc ->
      (match Analysis.guarded (fun () -> Workspace.look t.ws doc) with
      | Ok () -> ()
      | Error fault ->
          doc.changed <- false;
          log fault);
      (* What the next question will need, so that it is answered at once. *)
      let prepare (v : Document.version) =
        ignore (Analysis.guarded (fun () -> View.prepare v.view))
      in
      Option.iter prepare doc.named;
      publish t doc;
      true

(* {1 Notifications} *)

let uri params = Option.value (string (at [ "textDocument"; "uri" ] params)) ~default:""

let opened t params =
  let text = Option.value (string (at [ "textDocument"; "text" ] params)) ~default:"" in
  let version = at [ "textDocument"; "version" ] params in
  let doc = Document.opened ~uri:(uri params) ~version text in
  Hashtbl.replace t.ws.documents doc.uri doc;
  touched t doc.path

let changed t params =
  let change (doc : Document.t) =
    let one text change =
      match (member "range" change, string (member "text" change)) with
      | _, None -> text
      | Null, Some whole -> Text.of_string whole
      | range, Some piece ->
          let start, stop = Workspace.offsets t.ws text range in
          Text.replace text start stop piece
    in
    Document.change doc (List.fold_left one doc.text (list (member "contentChanges" params)));
    doc.version <- at [ "textDocument"; "version" ] params;
    touched t doc.path
  in
  Option.iter change (Workspace.document t.ws (uri params))

let closed t params =
  let close (doc : Document.t) =
    Hashtbl.remove t.ws.documents doc.uri;
    touched t doc.path;
    notify "textDocument/publishDiagnostics" (Diagnostics.none doc.uri)
  in
  Option.iter close (Workspace.document t.ws (uri params))

let all_touched t = Hashtbl.iter (fun _ (d : Document.t) -> d.changed <- true) t.ws.documents

let folders_of json =
  List.filter_map (fun f -> Option.map Uri.to_path (string (member "uri" f))) (list json)

let folders_changed t params =
  let added = folders_of (at [ "event"; "added" ] params) in
  let removed = folders_of (at [ "event"; "removed" ] params) in
  t.ws.roots <- List.filter (fun f -> not (List.mem f removed)) t.ws.roots @ added

(* {1 The beginning} *)

let settings t json =
  match member "inlayHints" json with Bool b -> t.ws.inlay_hints <- b | _ -> ()

let encodings = [ ("utf-8", Text.Utf8); ("utf-16", Utf16); ("utf-32", Utf32) ]

let initialize t params =
  let offered =
    List.filter_map string (list (at [ "capabilities"; "general"; "positionEncodings" ] params))
  in
  let name, encoding =
    Option.value
      (List.find_map
         (fun name -> Option.map (fun e -> (name, e)) (List.assoc_opt name encodings))
         offered)
      ~default:("utf-16", Text.Utf16)
  in
  t.ws.encoding <- encoding;
  t.ws.roots <-
    (match (folders_of (member "workspaceFolders" params), string (member "rootUri" params)) with
    | [], Some root -> [ Uri.to_path root ]
    | folders, _ -> folders);
  t.ws.snippets <-
    at [ "capabilities"; "textDocument"; "completion"; "completionItem"; "snippetSupport" ] params
    = Bool true;
  settings t (member "initializationOptions" params);
  Ok
    (Json.Object
       [
         ("capabilities", Capabilities.all ~encoding:name);
         ("serverInfo", Object [ ("name", String "frobc"); ("version", String "0.1") ]);
       ])

(* {1 Requests} *)

let on_document t params f =
  match Workspace.document t.ws (uri params) with
  | None -> Ok Json.Null
  | Some doc ->
      (* A request may come right behind the change that it is about. *)
      if doc.changed then (
        Workspace.look t.ws doc;
        publish t doc);
      f doc

let failed = Result.map_error (fun message -> (request_failed, message))

let request t method_ params : (Json.t, int * string) result =
  match method_ with
  | "initialize" -> initialize t params
  | "shutdown" ->
      t.shut_down <- true;
      Ok Null
  | "textDocument/formatting" ->
      on_document t params (fun doc -> failed (Document_format.edits t.ws doc))
  | "textDocument/hover" -> on_document t params (fun doc -> Ok (Hover.answer t.ws doc params))
  | "textDocument/definition" ->
      on_document t params (fun doc -> Ok (Definition.answer t.ws doc params))
  | "textDocument/documentSymbol" ->
      on_document t params (fun doc -> Ok (Symbols.of_document t.ws doc))
  | "workspace/symbol" ->
      Ok (Symbols.of_workspace t.ws (Option.value (string (member "query" params)) ~default:""))
  | "textDocument/references" ->
      on_document t params (fun doc -> Ok (References.answer t.ws doc params))
  | "textDocument/documentHighlight" ->
      on_document t params (fun doc -> Ok (References.highlights t.ws doc params))
  | "textDocument/prepareRename" ->
      on_document t params (fun doc -> Ok (Rename.prepare t.ws doc params))
  | "textDocument/rename" ->
      on_document t params (fun doc -> failed (Rename.answer t.ws doc params))
  | "textDocument/codeAction" ->
      on_document t params (fun doc -> Ok (Code_actions.answer t.ws doc params))
  | "textDocument/completion" ->
      on_document t params (fun doc -> Ok (Completion.answer t.ws doc params))
  | "completionItem/resolve" -> Ok (Completion.resolve t.ws params)
  | "textDocument/signatureHelp" ->
      on_document t params (fun doc -> Ok (Signature_help.answer t.ws doc params))
  | "textDocument/codeLens" -> on_document t params (fun doc -> Ok (Code_lenses.answer t.ws doc))
  | "textDocument/inlayHint" ->
      on_document t params (fun doc -> Ok (Inlay_hints.answer t.ws doc params))
  | "textDocument/semanticTokens/full" ->
      on_document t params (fun doc -> Ok (Semantic_tokens.answer t.ws doc))
  | "textDocument/foldingRange" -> on_document t params (fun doc -> Ok (Folding.ranges doc))
  | "textDocument/selectionRange" ->
      on_document t params (fun doc -> Ok (Folding.selections t.ws doc params))
  | _ -> Error (method_not_found, Printf.sprintf "there is no method %s" method_)

let notification t method_ params =
  match method_ with
  | "exit" -> t.exit <- Some (if t.shut_down then 0 else 1)
  | "textDocument/didOpen" -> opened t params
  | "textDocument/didChange" -> changed t params
  | "textDocument/didClose" -> closed t params
  | "textDocument/didSave" | "workspace/didChangeWatchedFiles" -> all_touched t
  | "workspace/didChangeWorkspaceFolders" -> folders_changed t params
  | "workspace/didChangeConfiguration" -> settings t (at [ "settings"; "frob" ] params)
  | _ -> ()

(* {1 Messages} *)

let handle t message =
  let params = member "params" message in
  match (string (member "method" message), member "id" message) with
  | Some method_, Null -> (
      match Analysis.guarded (fun () -> notification t method_ params) with
      | Ok () -> ()
      | Error fault -> log (Printf.sprintf "%s: %s" method_ fault))
  | Some _, id when List.mem id t.cancelled ->
      t.cancelled <- List.filter (( <> ) id) t.cancelled;
      answer id (Error (request_cancelled, "cancelled"))
  | Some method_, id -> (
      match Analysis.guarded (fun () -> request t method_ params) with
      | Ok result -> answer id result
      | Error fault ->
          log (Printf.sprintf "%s: %s" method_ fault);
          answer id (Error (internal_error, fault)))
  | None, Null -> answer Null (Error (invalid_request, "no method"))
  | None, _ -> () (* an answer *)

(* What cancels is looked at when it arrives, before what it is to cancel. *)
let rec receive t body =
  match of_string body with
  | None -> answer Null (Error (parse_error, "this is no JSON"))
  | Some (List batch) -> List.iter (fun m -> receive t (Json.to_string m)) batch
  | Some message when member "method" message = String "$/cancelRequest" ->
      let id = at [ "params"; "id" ] message in
      let is_it waiting = member "id" waiting = id in
      if Queue.fold (fun found m -> found || is_it m) false t.waiting then
        t.cancelled <- id :: t.cancelled
  | Some (Object _ as message) -> Queue.add message t.waiting
  | Some _ -> answer Null (Error (invalid_request, "a message is an object"))

let rec serve t =
  match (t.exit, Wire.next t.wire ~timeout:0.) with
  | Some status, _ -> status
  | None, Message body ->
      receive t body;
      serve t
  | None, event when not (Queue.is_empty t.waiting) ->
      ignore event;
      handle t (Queue.pop t.waiting);
      serve t
  | None, End -> if t.shut_down then 0 else 1
  | None, Nothing ->
      (if not (look_at_one t) then
         match Wire.next t.wire ~timeout:(-1.) with
         | Message body -> receive t body
         | Nothing | End -> ());
      serve t

(* A server runs for days, so what is free is used again, unlike in a compilation. *)
let collect () =
  Gc.set
    {
      (Gc.get ()) with
      space_overhead = 200;
      max_overhead = 500;
      allocation_policy = 2;
      custom_major_ratio = 44;
      minor_heap_size = 4 * 1024 * 1024;
    }

let run ?disk () =
  match Driver.Resources.find () with
  | Error text -> Driver.General.wrong_use text
  | Ok resources ->
      collect ();
      set_binary_mode_out stdout true;
      let ws = Workspace.create ?disk ~library:resources.library () in
      serve
        {
          ws;
          wire = Wire.create Unix.stdin;
          waiting = Queue.create ();
          cancelled = [];
          shut_down = false;
          exit = None;
        }
