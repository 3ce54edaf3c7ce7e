open Basis
open Interface

type import = { declaration : Syntax.Ir.import option; module_ : string }

type t = {
  name : string;
  file : string;
  library : bool;
  syntax : Syntax.Ir.program;
  imports : import list;
  complete : bool;
}

(* Where a module is, before it is read. *)
type found = { path : string; shown : string; in_library : bool; text : string }
type state = Loading | Loaded of t | Failed

type loader = {
  sink : Diagnostic.sink;
  files : Files.t;
  remember : file:string -> string -> unit;
  library : string;
  also : string option;  (** the file of a module that is there unasked *)
  mutable texts : (string, Files.error) result String_map.t;  (** by path *)
  mutable states : (string * state) String_map.t;  (** by module name, with the file *)
  mutable clashes : String_set.t;  (** names of two modules, reported *)
  mutable loaded : t list;  (** latest first *)
}

let prelude = "Prelude"
let file_of name = name ^ ".frob"
let module_in file = Filename.remove_extension (Filename.basename file)

let beside directory name =
  if String.equal directory Filename.current_dir_name then file_of name
  else Filename.concat directory (file_of name)

let shown_in_library loader name = Filename.basename loader.library ^ "/" ^ file_of name

(* A written import, and the way to it from the program: for messages. *)
type place = { importer : string; written : bool; at : Span.t; target : Syntax.Ir.name }

let read loader path =
  match String_map.find_opt path loader.texts with
  | Some result -> result
  | None ->
      let result = loader.files.read path in
      loader.texts <- String_map.add path result loader.texts;
      result

let report_missing loader ~directory (target : Syntax.Ir.name) =
  let known = loader.files.modules_in loader.library @ loader.files.modules_in directory in
  let diagnostic =
    Diagnostic.error ~code:"E0201" ~at:target.span "there is no module `%s`" target.text
    |> Diagnostic.note
         (Printf.sprintf "looked for `%s` beside this file and in the library" (file_of target.text))
  in
  let is_module name = name <> "" && 'A' <= name.[0] && name.[0] <= 'Z' in
  let modules, others = List.partition is_module known in
  let same name = String.equal (String.capitalize_ascii name) target.text in
  let near = Suggest.closest target.text modules in
  (match (List.find_opt same others, Other_languages.module_ target.text, near) with
  | Some file, _, _ ->
      Diagnostic.hint
        (Printf.sprintf "a module's file begins with a capital too: call `%s` `%s`" (file_of file)
           (file_of target.text))
        diagnostic
  | None, Some hint, _ -> Diagnostic.hint hint diagnostic
  | None, None, Some near ->
      Diagnostic.hint (Printf.sprintf "did you mean `%s`?" near) diagnostic
      |> Diagnostic.write target.span near
  | None, None, None -> diagnostic)
  |> Diagnostic.emit loader.sink

let report_unreadable loader ~at shown reason =
  Diagnostic.error ~code:"E0201" ~at "cannot read `%s`: %s" shown reason
  |> Diagnostic.emit loader.sink

(* [way]: the imports that led here, the latest first. *)
let report_cycle loader way (target : Syntax.Ir.name) =
  let rec circle taken = function
    | [] -> taken
    | place :: rest ->
        let taken = place :: taken in
        if String.equal place.importer target.text then taken else circle taken rest
  in
  let places = circle [] way in
  let names = List.map (fun place -> Printf.sprintf "`%s`" place.importer) places in
  let path = String.concat " → " (names @ [ Printf.sprintf "`%s`" target.text ]) in
  let label diagnostic place =
    if Span.compare place.at target.span = 0 then diagnostic
    else
      Diagnostic.label ~at:place.at
        (Printf.sprintf "`%s` imports `%s`" place.importer place.target.text)
        diagnostic
  in
  List.fold_left label
    (Diagnostic.error ~code:"E0202" ~at:target.span "modules import each other: %s" path)
    places
  |> Diagnostic.emit loader.sink

(* Even where a file's name is not that of its module. *)
let imports_itself way (target : Syntax.Ir.name) =
  match way with
  | place :: _ -> String.equal place.importer target.text && place.written
  | [] -> false

let read_library loader name =
  let path = Filename.concat loader.library (file_of name) in
  match read loader path with
  | Ok text -> Ok { path; shown = shown_in_library loader name; in_library = true; text }
  | Error error -> Error error

let find loader ~directory ~importer_in_library (target : Syntax.Ir.name) =
  let name = target.text in
  let from_library () =
    match read_library loader name with
    | Ok found -> Some found
    | Error Missing ->
        report_missing loader ~directory target;
        None
    | Error (Unreadable reason) ->
        report_unreadable loader ~at:target.span (shown_in_library loader name) reason;
        None
  in
  if importer_in_library || String.equal name prelude then from_library ()
  else
    let path =
      match loader.also with
      | Some file when String.equal (module_in file) name -> file
      | Some _ | None -> beside directory name
    in
    match read loader path with
    | Ok text -> Some { path; shown = path; in_library = false; text }
    | Error Missing -> from_library ()
    | Error (Unreadable reason) ->
        report_unreadable loader ~at:target.span path reason;
        None

let is_module_name text =
  String.length text > 0
  && (match text.[0] with 'A' .. 'Z' -> true | _ -> false)
  && String.for_all
       (function 'a' .. 'z' | 'A' .. 'Z' | '0' .. '9' | '_' | '\'' -> true | _ -> false)
       text

(* The header's name; a header must say what the file's name does, unless the
   file's name is none for a module, as a program's may be. *)
let name_of loader ~file_name (syntax : Syntax.Ir.program) =
  match syntax.header with
  | None -> if is_module_name file_name then file_name else "Main"
  | Some { module_name; _ } ->
      if is_module_name file_name && not (String.equal file_name module_name.text) then
        Diagnostic.error ~code:"E0203" ~at:module_name.span "module `%s` is in a file named `%s`"
          module_name.text (file_of file_name)
        |> Diagnostic.hint
             (Printf.sprintf "name the module `%s` or the file `%s`" file_name
                (file_of module_name.text))
        |> Diagnostic.emit loader.sink;
      if is_module_name file_name then file_name else module_name.text

let report_two_files loader (target : Syntax.Ir.name) ~earlier ~later =
  loader.clashes <- String_set.add target.text loader.clashes;
  Diagnostic.error ~code:"E0203" ~at:target.span "two modules are named `%s`: `%s` and `%s`"
    target.text earlier later
  |> Diagnostic.hint "give your own module another name"
  |> Diagnostic.emit loader.sink

let parse loader found =
  match loader.files.parsed ~file:found.shown found.text with
  | Some syntax -> Some syntax
  | None -> Syntax.Parse.program loader.sink ~file:found.shown found.text

let rec load_found loader ~way ~name_hint found =
  loader.remember ~file:found.shown found.text;
  match parse loader found with
  | None -> None
  | Some syntax ->
      let name = name_of loader ~file_name:name_hint syntax in
      loader.states <- String_map.add name (found.shown, Loading) loader.states;
      let imports = load_imports loader ~way ~name found syntax in
      let t =
        {
          name;
          file = found.shown;
          library = found.in_library;
          syntax;
          imports = List.filter_map Fun.id imports;
          complete = List.for_all Option.is_some imports;
        }
      in
      loader.states <- String_map.add name (found.shown, Loaded t) loader.states;
      loader.loaded <- t :: loader.loaded;
      Some t

and load_imports loader ~way ~name found (syntax : Syntax.Ir.program) =
  let directory = Filename.dirname found.path in
  let import ~declaration (target : Syntax.Ir.name) at =
    let written = Option.is_some declaration in
    let place = { importer = name; written; at; target } in
    match
      import_module loader ~way:(place :: way) ~directory ~importer_in_library:found.in_library
        target
    with
    | true -> Some { declaration; module_ = target.text }
    | false -> None
  in
  let written (d : Syntax.Ir.import) = import ~declaration:(Some d) d.module_ d.module_.span in
  let implied =
    if found.in_library && String.equal name prelude then []
    else
      let at = Span.start_of_file found.shown in
      [ import ~declaration:None { text = prelude; span = at } at ]
  in
  implied @ Long_list.map written syntax.imports

(* Is the module there? Loads it if it is new. *)
and import_module loader ~way ~directory ~importer_in_library (target : Syntax.Ir.name) =
  let found =
    if imports_itself way target then (
      report_cycle loader way target;
      None)
    else find loader ~directory ~importer_in_library target
  in
  match found with
  | None -> false
  | Some found -> (
      match String_map.find_opt target.text loader.states with
      | Some (file, _) when not (String.equal file found.shown) ->
          if not (String_set.mem target.text loader.clashes) then
            report_two_files loader target ~earlier:file ~later:found.shown;
          false
      | Some (_, Loading) ->
          report_cycle loader way target;
          false
      | Some (_, Loaded _) -> true
      | Some (_, Failed) -> false
      | None -> (
          match load_found loader ~way ~name_hint:target.text found with
          | Some _ -> true
          | None ->
              loader.states <- String_map.add target.text (found.shown, Failed) loader.states;
              false))

let load sink ~files ~remember ~library ?also main =
  let loader =
    {
      sink;
      files;
      remember;
      library;
      also;
      texts = String_map.empty;
      clashes = String_set.empty;
      states = String_map.empty;
      loaded = [];
    }
  in
  let base = module_in main in
  let other file = not (String.equal file main) in
  (match also with
  | Some file when other file ->
      let target : Syntax.Ir.name = { text = module_in file; span = Span.start_of_file file } in
      ignore
        (import_module loader ~way:[] ~directory:(Filename.dirname file) ~importer_in_library:false
           target)
  | Some _ | None -> ());
  (match read loader main with
  | Error Missing ->
      report_unreadable loader ~at:(Span.start_of_file main) main "there is no such file"
  | Error (Unreadable reason) -> report_unreadable loader ~at:(Span.start_of_file main) main reason
  | Ok text ->
      let found =
        match read_library loader base with
        | Ok found when String.equal found.text text -> found
        | Ok _ | Error _ -> { path = main; shown = main; in_library = false; text }
      in
      ignore (load_found loader ~way:[] ~name_hint:base found));
  List.rev loader.loaded
