open Basis
open Json

type answer = (Json.t, int * string) result

(* The result of checking a text, and the processor time that the check took. *)
type look = { found : Document.found; seconds : float }

type t = {
  ws : Workspace.t;
  wire : Wire.t;
  waiting : Json.t Queue.t;
  mutable looks : (Document.t * look Worker.t) list;  (** texts that workers are checking *)
  mutable asked : (Json.t * answer Worker.t) list;  (** requests that workers are answering *)
  mutable later : (Document.t * Json.t) list;
      (** requests waiting for their text to be checked, latest first *)
  mutable cancelled : Json.t list;  (** ids of cancelled requests *)
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

(* Writes a message to the editor's log. *)
let log message =
  notify "window/logMessage" (Object [ ("type", Int 1); ("message", String message) ])

(* {1 Checking texts} *)

let publish t (doc : Document.t) =
  Option.iter log (Option.bind doc.latest (fun (a : Analysis.t) -> a.fault));
  match Analysis.guarded (fun () -> Diagnostics.parameters t.ws doc) with
  | Ok parameters -> notify "textDocument/publishDiagnostics" parameters
  | Error fault -> log fault

(* {2 Slow texts}

   The server checks a text itself if the check is so short that other requests can wait for it.
   Otherwise, a worker checks the text. An edit stops the worker. Requests about the text wait for
   the worker's result, but requests about other texts do not. *)

(* More concurrent workers would only slow each other down. *)
let most_workers = 4

(* If a worker checked a text in less time than this, the server checks the text itself next
   time. *)
let is_fast seconds = seconds < 0.04
let is_looked_at t doc = List.mem_assq doc t.looks

let drop t doc =
  Option.iter Worker.stop (List.assq_opt doc t.looks);
  t.looks <- List.remove_assq doc t.looks

let outdated t (doc : Document.t) =
  doc.changed <- true;
  drop t doc

(* Puts the requests about the text at the end of the queue of waiting requests. *)
let release t doc =
  let own, others = List.partition (fun (other, _) -> other == doc) t.later in
  t.later <- others;
  List.iter (fun (_, message) -> Queue.add message t.waiting) (List.rev own)

let looked t (doc : Document.t) found =
  (match Analysis.guarded (fun () -> Document.looked_at doc found) with
  | Ok () -> ()
  | Error fault ->
      doc.changed <- false;
      log fault);
  publish t doc;
  release t doc

let analysed t doc =
  let found = Workspace.analyse t.ws doc in
  ignore (Analysis.guarded (fun () -> Document.prepare found));
  found

let look_elsewhere t (doc : Document.t) =
  if List.length t.looks < most_workers then
    let look () =
      let before = Sys.time () in
      let found = analysed t doc in
      { found; seconds = Sys.time () -. before }
    in
    t.looks <- (doc, Worker.start look) :: t.looks

(* Checks the text here, or in a worker as soon as one is free. *)
let look t (doc : Document.t) =
  let here () = Analysis.at_once (fun () -> analysed t doc) in
  match if doc.slow then None else here () with
  | Some found -> looked t doc found
  | None ->
      doc.slow <- true;
      if not (is_looked_at t doc) then look_elsewhere t doc

(* Processes the results of workers whose descriptors are readable. *)
let advance t ready =
  let is_ready worker = List.mem (Worker.descriptor worker) ready in
  let end_of_look (doc : Document.t) worker =
    match Worker.progress worker with
    | Running -> ()
    | Done { found; seconds } ->
        t.looks <- List.remove_assq doc t.looks;
        doc.slow <- not (is_fast seconds);
        looked t doc found
    | Lost ->
        t.looks <- List.remove_assq doc t.looks;
        let reason = "frobc could not check this text: it ran out of memory or was killed" in
        let analysis = Analysis.given_up ~path:doc.path (Text.contents doc.text) reason in
        looked t doc { analysis; whole_view = None; partial_view = None }
  in
  let end_of_request id worker =
    let end_with result =
      t.asked <- List.filter (fun (_, other) -> other != worker) t.asked;
      answer id result
    in
    match Worker.progress worker with
    | Running -> ()
    | Done result ->
        (match result with
        | Error (code, fault) when code = internal_error -> log fault
        | Ok _ | Error _ -> ());
        end_with result
    | Lost -> end_with (Error (internal_error, "frobc ran out of memory or was killed"))
  in
  List.iter (fun (doc, w) -> if is_ready w && is_looked_at t doc then end_of_look doc w) t.looks;
  List.iter (fun (id, w) -> if is_ready w then end_of_request id w) t.asked

let descriptors t =
  List.map (fun (_, w) -> Worker.descriptor w) t.looks
  @ List.map (fun (_, w) -> Worker.descriptor w) t.asked

(* {2 Changed texts} *)

(* Marks each open text whose last check read this file or produced messages, so that the text is
   checked again. *)
let touched t path =
  Hashtbl.iter
    (fun _ (doc : Document.t) ->
      match doc.latest with
      | Some a when Source.text a.sources path <> None || a.diagnostics <> [] -> outdated t doc
      | Some _ -> ()
      | None -> outdated t doc)
    t.ws.documents

(* Checks one of the changed texts. Messages that have arrived in the meantime are processed before
   the other texts are checked. *)
let look_at_one t =
  let has_room = List.length t.looks < most_workers in
  let changed _ (doc : Document.t) found =
    match found with
    | None when doc.changed && (not (is_looked_at t doc)) && (has_room || not doc.slow) -> Some doc
    | Some _ | None -> found
  in
  match Hashtbl.fold changed t.ws.documents None with
  | None -> false
  | Some doc ->
      look t doc;
      true

(* {1 Notifications} *)

let uri params = Option.value (string (at [ "textDocument"; "uri" ] params)) ~default:""

let opened t params =
  let text = Option.value (string (at [ "textDocument"; "text" ] params)) ~default:"" in
  let version = at [ "textDocument"; "version" ] params in
  let doc = Document.opened ~uri:(uri params) ~version text in
  let replace before =
    drop t before;
    release t before
  in
  Option.iter replace (Workspace.document t.ws doc.uri);
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
    drop t doc;
    Document.change doc (List.fold_left one doc.text (list (member "contentChanges" params)));
    doc.version <- at [ "textDocument"; "version" ] params;
    touched t doc.path
  in
  Option.iter change (Workspace.document t.ws (uri params))

let closed t params =
  let close (doc : Document.t) =
    drop t doc;
    release t doc;
    Hashtbl.remove t.ws.documents doc.uri;
    touched t doc.path;
    notify "textDocument/publishDiagnostics" (Diagnostics.none doc.uri)
  in
  Option.iter close (Workspace.document t.ws (uri params))

let all_touched t = Hashtbl.iter (fun _ doc -> outdated t doc) t.ws.documents

let folders_of json =
  List.filter_map (fun f -> Option.map Uri.to_path (string (member "uri" f))) (list json)

let folders_changed t params =
  let added = folders_of (at [ "event"; "added" ] params) in
  let removed = folders_of (at [ "event"; "removed" ] params) in
  t.ws.roots <- List.filter (fun f -> not (List.mem f removed)) t.ws.roots @ added

(* {1 Initialization} *)

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
         ( "serverInfo",
           Object [ ("name", String "frobc"); ("version", String Build.Version.number) ] );
       ])

(* {1 Requests} *)

let on_document t params f =
  match Workspace.document t.ws (uri params) with None -> Ok Json.Null | Some doc -> f doc

let failed = Result.map_error (fun message -> (request_failed, message))

let request t method_ params : answer =
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

(* These requests also analyse other texts, or a modified version of this one, so they may take
   arbitrarily long. *)
let takes_long method_ =
  List.mem method_
    [
      "textDocument/codeAction";
      "textDocument/references";
      "textDocument/rename";
      "workspace/symbol";
    ]

let answered t method_ params : answer =
  match Analysis.guarded (fun () -> request t method_ params) with
  | Ok result -> result
  | Error fault -> Error (internal_error, fault)

let give_answer t id method_ params =
  let result = answered t method_ params in
  (match result with
  | Error (code, fault) when code = internal_error -> log (Printf.sprintf "%s: %s" method_ fault)
  | Ok _ | Error _ -> ());
  answer id result

let ask t message id method_ params =
  let doc = Workspace.document t.ws (uri params) in
  let needs_look (doc : Document.t) = doc.changed in
  (* A request may arrive directly after an edit, before the changed text has been checked. *)
  Option.iter (fun doc -> if needs_look doc then look t doc) doc;
  match doc with
  | Some doc when needs_look doc -> t.later <- (doc, message) :: t.later
  | Some _ | None ->
      if takes_long method_ then
        t.asked <- (id, Worker.start (fun () -> answered t method_ params)) :: t.asked
      else give_answer t id method_ params

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
  | Some method_, id -> ask t message id method_ params
  | None, Null -> answer Null (Error (invalid_request, "no method"))
  | None, _ -> () (* a response to a request from the server *)

let cancel t id =
  let is_it waiting = member "id" waiting = id in
  let asked, others = List.partition (fun (other, _) -> other = id) t.asked in
  let later, rest = List.partition (fun (_, message) -> is_it message) t.later in
  t.asked <- others;
  t.later <- rest;
  List.iter (fun (_, worker) -> Worker.stop worker) asked;
  if asked <> [] || later <> [] then answer id (Error (request_cancelled, "cancelled"))
  else if Queue.fold (fun found m -> found || is_it m) false t.waiting then
    t.cancelled <- id :: t.cancelled

(* Processes cancellations when they arrive, ahead of the requests that they cancel. *)
let rec receive t body =
  match of_string body with
  | None -> answer Null (Error (parse_error, "the message is not valid JSON"))
  | Some (List batch) -> List.iter (fun m -> receive t (Json.to_string m)) batch
  | Some message when member "method" message = String "$/cancelRequest" ->
      cancel t (at [ "params"; "id" ] message)
  | Some (Object _ as message) -> Queue.add message t.waiting
  | Some _ -> answer Null (Error (invalid_request, "the message must be a JSON object"))

let ready_now t =
  match descriptors t with
  | [] -> []
  | all -> (
      match Unix.select all [] [] 0. with
      | ready, _, _ -> ready
      | exception Unix.Unix_error (EINTR, _, _) -> [])

let rec serve t =
  advance t (ready_now t);
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
      if not (look_at_one t) then advance t (Wire.wait t.wire (descriptors t));
      serve t

(* A server runs for days, so, unlike a compilation, it must reclaim memory. *)
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
  match Build.Installation.find () with
  | Error text -> Build.Reporting.wrong_use text
  | Ok resources ->
      collect ();
      set_binary_mode_out stdout true;
      let ws = Workspace.create ?disk ~library:resources.library () in
      let t =
        {
          ws;
          wire = Wire.create Unix.stdin;
          waiting = Queue.create ();
          looks = [];
          asked = [];
          later = [];
          cancelled = [];
          shut_down = false;
          exit = None;
        }
      in
      let status = serve t in
      List.iter (fun (_, worker) -> Worker.stop worker) t.looks;
      List.iter (fun (_, worker) -> Worker.stop worker) t.asked;
      status
