open Basis

type t = {
  library : string;
  disk : string -> (string, Resolve.Files.error) result;
  documents : (string, Document.t) Hashtbl.t;
  mutable encoding : Text.encoding;
  mutable roots : string list;
  mutable inlay_hints : bool;
  mutable snippets : bool;
  trees : Syntax.Ir.program option Text_cache.t;
  exports : Exports.t option Text_cache.t;
  declared : Mentions.declared Text_cache.t;
  explanations : (string, string option) Hashtbl.t;
}

let create ?(disk = Build.Program_file.files.read) ~library () =
  {
    library;
    disk;
    documents = Hashtbl.create 16;
    encoding = Utf16;
    roots = [];
    inlay_hints = false;
    snippets = false;
    trees = Text_cache.create ();
    exports = Text_cache.create ();
    declared = Text_cache.create ();
    explanations = Hashtbl.create 16;
  }

let document t uri = Hashtbl.find_opt t.documents uri

let read t path =
  let is_it _ (d : Document.t) found =
    if String.equal d.path path then Some (Text.contents d.text) else found
  in
  match Hashtbl.fold is_it t.documents None with Some text -> Ok text | None -> t.disk path

let check t ~path text = Analysis.check ~library:t.library ~read:(read t) ~path text

let analyse t (d : Document.t) =
  let partial = Analysis.partial ~library:t.library ~read:(read t) in
  Document.found d ~declared:t.declared ~partial (check t ~path:d.path (Text.contents d.text))

let look t (d : Document.t) = if d.changed then Document.looked_at d (analyse t d)

let analysis_of t path =
  let is_it _ (d : Document.t) found = if String.equal d.path path then Some d else found in
  match Hashtbl.fold is_it t.documents None with
  | Some d ->
      look t d;
      d.latest
  | None -> ( match t.disk path with Ok text -> Some (check t ~path text) | Error _ -> None)

(* {1 Files} *)

let most_files = 10_000
let deepest = 12

(* Folders that do not contain the user's own programs. *)
let is_skipped name =
  name = "" || name.[0] = '.' || name.[0] = '_' || String.equal name "node_modules"

let files t =
  let count = ref 0 in
  let rec walk depth found path =
    match Sys.readdir path with
    | exception Sys_error _ -> found
    | names ->
        Array.sort String.compare names;
        Array.fold_left
          (fun found name ->
            let path = Filename.concat path name in
            if is_skipped name || !count >= most_files then found
            else
              match (Unix.stat path).st_kind with
              | S_DIR when depth < deepest -> walk (depth + 1) found path
              | S_REG when Filename.check_suffix name ".frob" ->
                  incr count;
                  path :: found
              | _ -> found
              | exception Unix.Unix_error _ -> found)
          found names
  in
  let on_disk = List.fold_left (walk 0) [] t.roots in
  let opened = Hashtbl.fold (fun _ (d : Document.t) all -> d.path :: all) t.documents [] in
  List.sort_uniq String.compare (on_disk @ opened)

(* {1 Places in the protocol's format} *)

let position t text offset : Json.t =
  let { Text.line; character } = Text.position t.encoding text offset in
  Object [ ("line", Int line); ("character", Int character) ]

let range t text (start, stop) : Json.t =
  Object [ ("start", position t text start); ("end", position t text stop) ]

let offset t text json =
  let number name = Option.value Json.(int (member name json)) ~default:0 in
  Text.offset t.encoding text { line = number "line"; character = number "character" }

let offsets t text json =
  let start = offset t text (Json.member "start" json) in
  (start, max start (offset t text (Json.member "end" json)))

let span_range t sources (span : Span.t) =
  let text = Text.of_string (Option.value (Source.text sources span.file) ~default:"") in
  let offset = Source.offset sources span.file in
  range t text (offset span.start, offset span.stop)

(* The URI that the editor uses for this file. *)
let uri_of t file =
  let path = Analysis.path_of ~library:t.library file in
  let is_it uri (d : Document.t) found = if String.equal d.path path then Some uri else found in
  Option.value (Hashtbl.fold is_it t.documents None) ~default:(Uri.of_path path)

let location t sources (span : Span.t) : Json.t =
  Object [ ("uri", String (uri_of t span.file)); ("range", span_range t sources span) ]
