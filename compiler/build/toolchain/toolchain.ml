let ( / ) = Filename.concat
let flags = [ "-std=c99"; "-O2"; "-ffp-contract=off" ]

type foreign = { sources : string list; folders : string list; allowed : string list }
type machine = { compiler : string; fix : string; options : string list }

let install_one = "install one (on Debian: apt-get install gcc), or set the environment variable CC"

let is_on_path name =
  let folders = String.split_on_char ':' (Option.value (Sys.getenv_opt "PATH") ~default:"") in
  let is_program path =
    match Unix.access path [ X_OK ] with
    | () -> not (Sys.is_directory path)
    | exception (Unix.Unix_error _ | Sys_error _) -> false
  in
  List.exists (fun folder -> is_program (Filename.concat folder name)) folders

let default_compiler () =
  match List.find_opt is_on_path [ "cc"; "gcc"; "clang" ] with
  | Some name -> name
  | None -> (
      match Installation.find () with
      | Ok { own_compiler; _ } when Sys.file_exists own_compiler -> own_compiler
      | Ok _ | Error _ -> "cc")

let this_machine () =
  {
    compiler =
      (match Sys.getenv_opt "CC" with Some cc when cc <> "" -> cc | _ -> default_compiler ());
    fix = install_one;
    options = [];
  }

let write path content =
  let channel = open_out_bin path in
  Fun.protect
    ~finally:(fun () -> close_out_noerr channel)
    (fun () ->
      output_string channel content;
      close_out channel)

(* A digest of the headers that generated code includes, because the result depends on them. *)
let headers_digest folder =
  let frob = folder / "frob" in
  let files = Sys.readdir frob in
  Array.sort compare files;
  String.concat "" (List.map (fun file -> Digest.file (frob / file)) (Array.to_list files))

let is_cpp file = List.mem (Filename.extension file) [ ".cc"; ".cpp"; ".cxx" ]
let include_flags folders = List.concat_map (fun folder -> [ "-I"; folder ]) folders

(* Applies only to includes in quotes, so that a file in the user's folders cannot replace a
   standard header of the same name. *)
let quote_flags folders =
  List.concat_map (fun folder -> [ "-iquote"; Included.in_folder folder ]) folders

(* Other files, such as objects and libraries, are passed to the linker. *)
let is_source file = Filename.extension file = ".c" || is_cpp file

(* A C compiler would interpret some file names as options. *)
let as_argument file = if file <> "" && (file.[0] = '-' || file.[0] = '@') then "." / file else file

(* The user's files are compiled as copies next to the generated headers. C compilers first search
   the folder of the including file, which may contain a header from an older version of the
   program. *)
let copy_of ~folder number file =
  folder / Printf.sprintf "own_%d%s" number (Filename.extension file)

(* An empty header that each copy includes. If a compiler does not list it, that compiler ignores
   {!Included.option}. *)
let listed = "frob_listed.h"

let copy ~folder number file =
  Result.map
    (fun text ->
      write (copy_of ~folder number file)
        (Printf.sprintf "#include \"%s\"\n#line 1 %s\n%s" listed (Basis.C_string.literal file) text))
    (Own_headers.read file)

let copies ~folder { sources; _ } =
  write (folder / listed) "";
  List.fold_left
    (fun result (number, file) ->
      Result.bind result (fun () -> if is_source file then copy ~folder number file else Ok ()))
    (Ok ())
    (List.mapi (fun number file -> (number, file)) sources)

(* The file to link for one of the user's files: the object file of a source, or the file itself. *)
let object_of ~folder number file =
  if is_source file then folder / Printf.sprintf "own_%d.o" number else as_argument file

(* Undefined symbols must be reported now, not when a host starts. *)
let with_foreign ~folder = function
  | None -> []
  | Some { sources; folders; allowed = _ } ->
      (Included.option :: quote_flags (folder :: folders))
      @ List.mapi (object_of ~folder) sources
      @ (if List.exists is_cpp sources then [ "-lstdc++" ] else [])
      @ [ "-Wl,--no-undefined" ]

type kind = Shared_object | Executable

let suffix = function Shared_object -> ".so" | Executable -> ""

(* For a step that assigns thousands of fields, gcc spends most of its time searching for
   assignments to vectorize. That does not pay off for a trace. *)
let compile_flags = function
  | Shared_object -> [ "-fPIC"; "-fno-tree-slp-vectorize" ]
  | Executable -> []

let link_flags = function Shared_object -> [ "-shared" ] | Executable -> []

(* frob-tcc has the same path in every version of frobc, so the key depends on its content. *)
let own_compiler machine =
  if Tcc.is_own machine.compiler && Sys.file_exists machine.compiler then [ machine.compiler ]
  else []

let key machine ~headers ~inputs ~includes ~foreign ~name kind files =
  Digest.to_hex
    (Digest.string
       (String.concat "\000"
          (name :: suffix kind :: machine.compiler :: headers_digest headers
           :: List.map Digest.file (own_compiler machine @ inputs @ includes)
          @ flags @ machine.options
          @ Option.fold foreign ~none:[] ~some:(fun f -> f.sources @ ("" :: f.folders))
          @ List.concat_map (fun (file, content) -> [ file; content ]) files)))

let words text = List.filter (( <> ) "") (String.split_on_char ' ' text)

(* Explains why the compiler cannot be started. The variable CC may contain any text. *)
let not_found machine program =
  let shown = Basis.Printable.name program in
  let is_path = String.contains program '/' in
  match words program with
  | _ when is_path && Sys.file_exists program && Sys.is_directory program ->
      Printf.sprintf "`%s` is a folder, not a C compiler; %s" shown machine.fix
  | _ when is_path && Sys.file_exists program ->
      Printf.sprintf
        "the C compiler `%s` cannot be started: it is not executable; run `chmod +x %s`" shown
        (Basis.Printable.path program)
  | first :: _ when first <> program && not is_path ->
      Printf.sprintf
        "there is no C compiler `%s`: frobc takes the whole value of CC as the name of one \
         program; set CC to a program without options, or to a script that adds them"
        shown
  | _ -> Printf.sprintf "there is no C compiler `%s`; %s" shown machine.fix

let explain machine = function
  | Process.Not_found program -> not_found machine program
  | Process.Failed { status; errors } ->
      Printf.sprintf "the C compiler `%s` failed with status %d:\n%s" machine.compiler status
        (Included.other_lines errors)

let lists_nothing machine =
  Printf.sprintf
    "the C compiler `%s` does not list the files that it includes, so frobc cannot check whether \
     the command line allows them: use gcc or clang, which list them with the option %s"
    machine.compiler Included.option

(* Compiles, and rejects the result if the compiler included a file that the user does not allow.
   [lists]: whether C or C++ is compiled; if so, the compiler must list at least one file. *)
let compile_allowed machine ~lists foreign arguments =
  let open Basis.Let_syntax.Result in
  let* output = Result.map_error (explain machine) (Process.output machine.compiler arguments) in
  match foreign with
  | None -> Ok ()
  | Some _ when lists && not (Included.lists_some output) -> Error (lists_nothing machine)
  | Some { sources; folders; allowed } -> Included.check ~allowed ~sources ~folders output

(* The flags for one of the user's files. A C compiler recognizes a C++ file by its name, but then
   rejects the flags for C. *)
let own_flags kind file =
  if is_cpp file then [ "-std=c++17"; "-O2"; "-ffp-contract=off"; "-fPIC" ]
  else flags @ compile_flags kind

(* Compiles each of the user's files separately, so that it finds the headers in its own folder
   first: another folder may have headers with the same names. *)
let compile_own machine ~headers ~folder kind foreign =
  let one foreign number file =
    compile_allowed machine ~lists:true (Some foreign)
      ((Included.option :: own_flags kind file)
      @ machine.options @ include_flags [ headers ]
      @ quote_flags (Filename.dirname file :: folder :: foreign.folders)
      @ [ "-c"; "-o"; object_of ~folder number file; copy_of ~folder number file ])
  in
  match foreign with
  | None -> Ok ()
  | Some ({ sources; _ } as foreign) ->
      List.fold_left
        (fun result (number, file) ->
          match result with
          | Ok () when is_source file -> one foreign number file
          | result -> result)
        (Ok ())
        (List.mapi (fun number file -> (number, file)) sources)

let adapted machine text = if Tcc.is_named machine.compiler then Tcc.adapted text else text

let compile machine ~headers ~inputs ~foreign ~folder ~result kind files =
  List.iter (fun (file, content) -> write (folder / file) (adapted machine content)) files;
  let sources = List.filter (fun (file, _) -> Filename.check_suffix file ".c") files in
  let link () =
    compile_allowed machine ~lists:(sources <> []) foreign
      (flags @ machine.options @ compile_flags kind @ link_flags kind
     @ [ "-I"; headers; "-o"; result ]
      @ List.map (fun (file, _) -> folder / file) sources
      @ with_foreign ~folder foreign @ inputs @ [ "-lm" ])
  in
  let open Basis.Let_syntax.Result in
  let* () = Option.fold foreign ~none:(Ok ()) ~some:(copies ~folder) in
  let* () = compile_own machine ~headers ~folder kind foreign in
  let* () = link () in
  if Sys.file_exists result then Ok ()
  else
    Error
      (Printf.sprintf "the C compiler `%s` reported no error but produced no program; %s"
         machine.compiler machine.fix)

(* [frob-tcc] cannot list the files that it includes. A program that only calls vision kernels
   includes none of the user's files. *)
let without_own_files machine foreign =
  match foreign with
  | Some { sources = []; allowed = []; _ } when Tcc.is_own machine.compiler -> Ok None
  | Some _ when Tcc.is_own machine.compiler ->
      Error
        ("the program uses C files, but the only C compiler here is the one inside frobc, which \
          compiles only what frobc generates; " ^ install_one)
  | _ -> Ok foreign

let build ?machine kind ~headers ~inputs ?(includes = []) ~foreign ~name files =
  let machine = match machine with Some machine -> machine | None -> this_machine () in
  let open Basis.Let_syntax.Result in
  let* foreign = without_own_files machine foreign in
  let inputs = if Tcc.is_named machine.compiler then List.map Tcc.archive inputs else inputs in
  (* frobc does not know which files the user's files include, so it always recompiles them. *)
  Cache.entry ~name ~suffix:(suffix kind) ~reuse:(foreign = None)
    ~key:(key machine ~headers ~inputs ~includes ~foreign ~name kind files) (fun ~folder result ->
      compile machine ~headers ~inputs ~foreign ~folder ~result kind files)
