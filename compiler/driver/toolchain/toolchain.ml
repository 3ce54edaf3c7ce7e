let flags = [ "-std=c99"; "-O2"; "-ffp-contract=off" ]

type foreign = { sources : string list; folders : string list }

let ( / ) = Filename.concat

type machine = { compiler : string; cure : string; options : string list }

let this_machine () =
  {
    compiler = (match Sys.getenv_opt "CC" with Some cc when cc <> "" -> cc | _ -> "cc");
    cure =
      "install one (on Debian: apt-get install gcc) or name yours in the environment variable CC";
    options = [];
  }

let write path content =
  let channel = open_out_bin path in
  Fun.protect
    ~finally:(fun () -> close_out_noerr channel)
    (fun () ->
      output_string channel content;
      close_out channel)

(* Headers that generated code includes are part of what matters. *)
let headers_digest folder =
  let frob = folder / "frob" in
  let files = Sys.readdir frob in
  Array.sort compare files;
  String.concat "" (List.map (fun file -> Digest.file (frob / file)) (Array.to_list files))

let is_cpp file = List.mem (Filename.extension file) [ ".cc"; ".cpp"; ".cxx" ]
let include_flags folders = List.concat_map (fun folder -> [ "-I"; folder ]) folders

(* Anything else, an object or a library, is linked as it is. *)
let is_source file = Filename.extension file = ".c" || is_cpp file

(* The user's files are compiled as copies beside the generated headers: compilers look
   first where the file is that includes, and there may be a header of an older program. *)
let copy_of ~folder number file =
  if is_source file then folder / Printf.sprintf "own_%d%s" number (Filename.extension file)
  else file

let copy ~folder number file =
  let name = String.concat "\\\\" (String.split_on_char '\\' file) in
  Result.map
    (fun text ->
      write (copy_of ~folder number file) (Printf.sprintf "#line 1 \"%s\"\n%s" name text))
    (Own_headers.read file)

let copies ~folder { sources; _ } =
  List.fold_left
    (fun result (number, file) ->
      Result.bind result (fun () -> if is_source file then copy ~folder number file else Ok ()))
    (Ok ())
    (List.mapi (fun number file -> (number, file)) sources)

(* C++ is compiled first: what is linked in its place. *)
let object_of ~folder number file =
  if is_cpp file then folder / Printf.sprintf "cpp_%d.o" number else copy_of ~folder number file

let folders_of { sources; folders } =
  folders @ List.sort_uniq String.compare (List.map Filename.dirname sources)

(* A symbol that nobody defines is to be found now, not when a host starts. *)
let with_foreign ~folder = function
  | None -> []
  | Some ({ sources; _ } as foreign) ->
      include_flags (folder :: folders_of foreign)
      @ List.mapi (object_of ~folder) sources
      @ (if List.exists is_cpp sources then [ "-lstdc++" ] else [])
      @ [ "-Wl,--no-undefined" ]

type kind = Shared_object | Executable

let suffix = function Shared_object -> ".so" | Executable -> ""

(* Of a step that sets thousands of fields, gcc takes most of its time looking for some to
   set together; a trace is over before that pays. *)
let kind_flags = function
  | Shared_object -> [ "-fPIC"; "-shared"; "-fno-tree-slp-vectorize" ]
  | Executable -> []

let key machine ~headers ~inputs ~includes ~foreign ~name kind files =
  Digest.to_hex
    (Digest.string
       (String.concat "\000"
          (name :: suffix kind :: machine.compiler :: headers_digest headers
           :: List.map Digest.file (inputs @ includes)
          @ flags @ machine.options
          @ Option.fold foreign ~none:[] ~some:(fun f -> f.sources @ ("" :: f.folders))
          @ List.concat_map (fun (file, content) -> [ file; content ]) files)))

let explain machine = function
  | Process.Not_found program ->
      Printf.sprintf "there is no C compiler `%s` here; %s" program machine.cure
  | Process.Failed { status; errors } ->
      Printf.sprintf "the C compiler `%s` failed with status %d:\n%s" machine.compiler status errors

(* A C compiler takes C++ for what it is, but not with the flags of C. *)
let compile_cpp machine ~headers ~folder foreign =
  let one foreign number file =
    Process.run machine.compiler
      ([ "-std=c++17"; "-O2"; "-ffp-contract=off"; "-fPIC"; "-c" ]
      @ machine.options
      @ include_flags (headers :: folder :: folders_of foreign)
      @ [ "-o"; object_of ~folder number file; copy_of ~folder number file ])
  in
  match foreign with
  | None -> Ok ()
  | Some ({ sources; _ } as foreign) ->
      List.fold_left
        (fun result (number, file) ->
          match result with Ok () when is_cpp file -> one foreign number file | result -> result)
        (Ok ())
        (List.mapi (fun number file -> (number, file)) sources)

let compile machine ~headers ~inputs ~foreign ~folder ~result kind files =
  List.iter (fun (file, content) -> write (folder / file) content) files;
  let sources = List.filter (fun (file, _) -> Filename.check_suffix file ".c") files in
  let link () =
    Process.run machine.compiler
      (flags @ machine.options @ kind_flags kind @ [ "-I"; headers; "-o"; result ]
      @ List.map (fun (file, _) -> folder / file) sources
      @ with_foreign ~folder foreign @ inputs @ [ "-lm" ])
  in
  let ( let* ) = Result.bind in
  let* () = Option.fold foreign ~none:(Ok ()) ~some:(copies ~folder) in
  let* () = Result.map_error (explain machine) (compile_cpp machine ~headers ~folder foreign) in
  let* () = Result.map_error (explain machine) (link ()) in
  if Sys.file_exists result then Ok ()
  else
    Error
      (Printf.sprintf "the C compiler `%s` made no program, and gave no error; %s" machine.compiler
         machine.cure)

let build ?machine kind ~headers ~inputs ?(includes = []) ~foreign ~name files =
  let machine = match machine with Some machine -> machine | None -> this_machine () in
  (* What files of the user's include we do not know: they are compiled anew. *)
  Cache.entry ~name ~suffix:(suffix kind) ~reuse:(foreign = None)
    ~key:(key machine ~headers ~inputs ~includes ~foreign ~name kind files) (fun ~folder result ->
      compile machine ~headers ~inputs ~foreign ~folder ~result kind files)
