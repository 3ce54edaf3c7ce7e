open Basis
open Interface

type import = { declaration : Syntax.Ir.import option; module_ : string }

type t = {
  name : string;
  file : string;
  text : string;
  library : bool;
  syntax : Syntax.Ir.program;
  imports : import list;
  complete : bool;
  program : string option;
}

(* A module that has been found and read, but not parsed yet. *)
type found = { path : string; shown : string; in_library : bool; text : string }
type state = Loading | Loaded of t | Failed

type loader = {
  context : Context.t;
  files : Files.t;
  remember : file:string -> string -> unit;
  library : string;
  also : string option;  (** the file of a module that is loaded even if nothing imports it *)
  mutable texts : (string, Files.error) result String_map.t;  (** texts by path *)
  mutable beside : string list String_map.t;  (** module names by folder *)
  mutable states : (string * state) String_map.t;  (** state and file of each module, by name *)
  mutable clashes : String_set.t;  (** names shared by two modules, already reported *)
  mutable loaded : t list;  (** newest first *)
  mutable missing : int;  (** number of modules that were reported as missing *)
}

let prelude = "Prelude"
let file_of name = name ^ ".frob"
let module_in file = Filename.remove_extension (Filename.basename file)

let beside directory name =
  if String.equal directory Filename.current_dir_name then file_of name
  else Filename.concat directory (file_of name)

let shown_in_library loader name = Filename.basename loader.library ^ "/" ^ file_of name

(* An import. [written]: whether it is explicit. *)
type place = { written : bool; place : Fact.import_place }

let report loader fact = Context.report loader.context (In_modules fact)

let read loader path =
  match String_map.find_opt path loader.texts with
  | Some result -> result
  | None ->
      let result = loader.files.read path in
      loader.texts <- String_map.add path result loader.texts;
      result

let modules_in loader directory =
  match String_map.find_opt directory loader.beside with
  | Some names -> names
  | None ->
      let names = loader.files.modules_in directory in
      loader.beside <- String_map.add directory names loader.beside;
      names

(* Messages beyond this number are not displayed, so they do not need suggestions. *)
let most_suggestions = 1_000

(* [imported]: the modules that the importing module names in its imports. *)
let report_missing loader ~imported ~directory (target : Syntax.Ir.name) =
  loader.missing <- loader.missing + 1;
  let known =
    if loader.missing > most_suggestions then []
    else modules_in loader loader.library @ modules_in loader directory
  in
  report loader (Missing_module { target; imported; known })

(* [way]: the imports that led to this module, newest first. *)
let report_cycle loader way (target : Syntax.Ir.name) =
  let rec circle taken = function
    | [] -> taken
    | { place; _ } :: rest ->
        let taken = place :: taken in
        if String.equal place.importer target.text then taken else circle taken rest
  in
  let places = circle [] way in
  report loader (Import_cycle { target; places })

(* Does the module import itself? Detects this even if the file name differs from the module
   name. *)
let imports_itself way (target : Syntax.Ir.name) =
  match way with
  | { place; written } :: _ -> String.equal place.importer target.text && written
  | [] -> false

let read_library loader name =
  let path = Filename.concat loader.library (file_of name) in
  match read loader path with
  | Ok text -> Ok { path; shown = shown_in_library loader name; in_library = true; text }
  | Error error -> Error error

let find loader ~directory ~imported ~importer_in_library (target : Syntax.Ir.name) =
  let name = target.text in
  let from_library () =
    match read_library loader name with
    | Ok found -> Some found
    | Error Missing ->
        report_missing loader ~imported ~directory target;
        None
    | Error (Unreadable reason) ->
        let file = shown_in_library loader name in
        report loader (Unreadable_file { at = target.span; file; reason });
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
        report loader (Unreadable_file { at = target.span; file = path; reason });
        None

let is_module_name text =
  String.length text > 0
  && (match text.[0] with 'A' .. 'Z' -> true | _ -> false)
  && String.for_all
       (function 'a' .. 'z' | 'A' .. 'Z' | '0' .. '9' | '_' | '\'' -> true | _ -> false)
       text

(* The module's name. If the file name is a valid module name, the header must agree with it. The
   file name of a program need not be a valid module name. *)
let name_of loader ~file_name (syntax : Syntax.Ir.program) =
  match syntax.header with
  | None -> if is_module_name file_name then file_name else "Main"
  | Some { module_name; _ } ->
      if is_module_name file_name && not (String.equal file_name module_name.text) then
        report loader (Other_file_name { module_ = module_name; file = file_name });
      if is_module_name file_name then file_name else module_name.text

let report_two_files loader (target : Syntax.Ir.name) ~earlier ~later =
  loader.clashes <- String_set.add target.text loader.clashes;
  report loader (Two_files { target; earlier; later })

let parse loader found =
  match loader.files.parsed ~file:found.shown found.text with
  | Some syntax -> Some syntax
  | None -> Context.parse loader.context ~file:found.shown found.text

let rec load_found loader ~way ~name_hint found =
  loader.remember ~file:found.shown found.text;
  match parse loader found with
  | None -> None
  | Some syntax ->
      let name = name_of loader ~file_name:name_hint syntax in
      loader.states <- String_map.add name (found.shown, Loading) loader.states;
      let prelude = not (found.in_library && String.equal name prelude) in
      let imports = load_imports loader ~way ~name ~prelude found syntax in
      Some (add_loaded loader ~name ~imports found syntax)

and add_loaded loader ~name ~imports ?program found syntax =
  let t =
    {
      name;
      file = found.shown;
      text = found.text;
      library = found.in_library;
      syntax;
      imports = List.filter_map Fun.id imports;
      complete = List.for_all Option.is_some imports;
      program;
    }
  in
  loader.states <- String_map.add name (found.shown, Loaded t) loader.states;
  loader.loaded <- t :: loader.loaded;
  t

(* [prelude]: whether to add the implicit import of the prelude. *)
and load_imports loader ~way ~name ~prelude:implicit found (syntax : Syntax.Ir.program) =
  let directory = Filename.dirname found.path in
  let imported = List.map (fun (d : Syntax.Ir.import) -> d.module_.text) syntax.imports in
  let import ~declaration (target : Syntax.Ir.name) at =
    let written = Option.is_some declaration in
    let place = { written; place = { importer = name; at; target } } in
    match
      import_module loader ~way:(place :: way) ~directory ~imported
        ~importer_in_library:found.in_library target
    with
    | true -> Some { declaration; module_ = target.text }
    | false -> None
  in
  let written (d : Syntax.Ir.import) = import ~declaration:(Some d) d.module_ d.module_.span in
  let implied =
    let at = Span.start_of_file found.shown in
    if implicit then [ import ~declaration:None { text = prelude; span = at } at ] else []
  in
  let of_tests = List.map written (Option.to_list (Labels.import syntax)) in
  implied @ of_tests @ Long_list.map written syntax.imports

(* Finds the module and loads it unless it is already loaded. Returns whether it can be imported. *)
and import_module loader ~way ~directory ~imported ~importer_in_library (target : Syntax.Ir.name) =
  let found =
    if imports_itself way target then (
      report_cycle loader way target;
      None)
    else find loader ~directory ~imported ~importer_in_library target
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

let load_program loader file text =
  let base = module_in file in
  let found =
    match read_library loader base with
    | Ok found when String.equal found.text text -> found
    | Ok _ | Error _ -> { path = file; shown = file; in_library = false; text }
  in
  load_found loader ~way:[] ~name_hint:base found

(* {1 Test files} *)

(* Reports and removes the header and the [main] of a test file, which are not allowed there. *)
let without_program loader (syntax : Syntax.Ir.program) : Syntax.Ir.program =
  Option.iter
    (fun (h : Syntax.Ir.header) -> report loader (Header_in_tests h.module_name.span))
    syntax.header;
  let is_other (d : Syntax.Ir.declaration) =
    match d.desc with
    | Binding { left = Name name | Function_name { name; _ }; _ } when name.text = "main" ->
        report loader (Main_in_tests name.span);
        false
    | Signature { names = [ { text = "main"; _ } ]; _ } -> false
    | _ -> true
  in
  { syntax with header = None; declarations = List.filter is_other syntax.declarations }

(* If a test file's program is missing, the names in the file cannot be resolved, so only its syntax
   is checked. *)
let load_tests loader ~program file text =
  let found = { path = file; shown = file; in_library = false; text } in
  let no_program reason = report loader (No_program { tests = file; program; reason }) in
  let tested =
    match read loader program with
    | Ok text -> load_program loader program text
    | Error Missing ->
        no_program None;
        None
    | Error (Unreadable reason) ->
        no_program (Some reason);
        None
  in
  loader.remember ~file text;
  match (parse loader found, tested) with
  | Some syntax, Some (tested : t) ->
      let syntax = without_program loader syntax in
      let name = Test_file.module_ tested.name in
      let imports = load_imports loader ~way:[] ~name ~prelude:false found syntax in
      ignore (add_loaded loader ~name ~imports ~program:tested.name found syntax)
  | _, _ -> ()

let load context ~files ~remember ~library ?also main =
  let loader =
    {
      context;
      files;
      remember;
      library;
      also;
      texts = String_map.empty;
      beside = String_map.empty;
      missing = 0;
      clashes = String_set.empty;
      states = String_map.empty;
      loaded = [];
    }
  in
  let other file = not (String.equal file main) in
  (match also with
  | Some file when other file ->
      let target : Syntax.Ir.name = { text = module_in file; span = Span.start_of_file file } in
      ignore
        (import_module loader ~way:[] ~directory:(Filename.dirname file) ~imported:[]
           ~importer_in_library:false target)
  | Some _ | None -> ());
  let at = Span.start_of_file main in
  (match read loader main with
  | Error Missing -> report loader (Missing_file { at; file = main })
  | Error (Unreadable reason) -> report loader (Unreadable_file { at; file = main; reason })
  | Ok text -> (
      match Test_file.program main with
      | Some program -> load_tests loader ~program main text
      | None -> ignore (load_program loader main text)));
  List.rev loader.loaded
