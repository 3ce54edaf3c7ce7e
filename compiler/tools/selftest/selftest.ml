open Basis

type compiler = {
  cc : string option;
  cflags : string option;
  runner : string option;
  real : Real.t;
}

let ( / ) = Filename.concat

open Basis.Let_syntax.Result

type group = {
  name : string;  (** the program's file without its extension *)
  entry : string;
  meant : string;  (** the equivalent entry that the interpreter runs *)
  sources : string list;  (** C files with functions that the program calls *)
}

let group name = { name; entry = "main"; meant = "main"; sources = [] }

let groups =
  List.map group [ "numbers"; "functions"; "time"; "data"; "arrays"; "switches"; "tasks"; "rounds" ]
  @ [ { (group "foreign") with meant = "meant"; sources = [ "calls.c" ] } ]

let programs = List.map (fun g -> (g.name ^ ".frob", g.entry)) groups

(* {1 The C compiler} *)

type t = {
  compile : string list;  (** the command with its flags *)
  run : string list;
  resources : Resources.t;
  folder : string;
  real : Real.t;
  mutable warned : bool;
}

(* Reasons to stop: the compiler cannot be tested, or it fails the test. *)
type failure = Untried of string | Unfit of string

let words text = List.filter (( <> ) "") (String.split_on_char ' ' text)
let command t = String.concat " " t.compile

let call = function
  | [] -> Error (Process.Not_found "")
  | program :: arguments -> Process.output program arguments

(* Shortens the output of a compiler, which may be long. *)
let beginning text =
  let lines = String.split_on_char '\n' (String.trim text) in
  let shown = List.filteri (fun k _ -> k < 20) lines in
  String.concat "\n" (if List.length lines > 20 then shown @ [ "…" ] else shown)

(* Returns the compiler's output. If the exit status is 0, this output consists of warnings. *)
let compiled t arguments =
  match call (t.compile @ arguments) with
  | Ok said -> Ok (String.trim said)
  | Error (Not_found program) ->
      Error (Untried (Printf.sprintf "there is no C compiler `%s`" program))
  | Error (Failed { status; errors }) ->
      Error
        (Unfit
           (Printf.sprintf "`%s` failed with status %d:\n%s" (command t) status (beginning errors)))

let warn t said =
  if not (String.equal said "") then (
    t.warned <- true;
    prerr_endline ("warning: the C compiler reports:\n" ^ beginning said))

(* Runs a program whose output ends with the word `right` if the program was compiled correctly.
   Ignores the exit status, because not every runner passes it on. The error is the program's
   output. *)
let ran t program =
  let last text =
    match List.rev (words (String.map (function '\n' | '\r' -> ' ' | c -> c) text)) with
    | last :: _ -> last
    | [] -> ""
  in
  match call (t.run @ [ program ]) with
  | (Ok said | Error (Failed { status = _; errors = said })) when last said = "right" -> Ok ()
  | Ok said -> Error said
  | Error (Failed { status; errors }) ->
      Error (if errors = "" then Printf.sprintf "it ended with status %d" status else errors)
  | Error (Not_found program) -> Error (Printf.sprintf "`%s` was not found" program)

let include_flags t =
  List.concat_map
    (fun folder -> [ "-I"; folder ])
    [ t.resources.headers; t.folder; t.resources.selftest ]

let write path text =
  Result.map_error (fun reason -> Untried reason) (Output.write [ (path, text) ])

(* {1 Tests with a minimal program} *)

(* A program for a board has no operating system through which it could print. *)
let not_linked t text =
  Printf.sprintf
    "`%s` compiles a one-line program but does not link it. If the compiler is for a board, add a \
     library that prints through an emulator, and name the emulator; with newlib, for example: \
     --cflags \"%s --specs=rdimon.specs\" --runner qemu-arm\n\
     %s"
    (command t)
    (String.concat " " Toolchain.flags)
    text

let works t =
  let source = t.folder / "hello.c" and program = t.folder / "hello" in
  let* () =
    write source "#include <stdio.h>\nint main(void)\n{\n    puts(\"right\");\n    return 0;\n}\n"
  in
  let* said =
    Result.map_error
      (function
        | Untried _ as failure -> failure
        | Unfit text -> (
            match compiled t [ "-c"; "-o"; program ^ ".o"; source ] with
            | Ok _ -> Untried (not_linked t text)
            | Error _ -> Untried ("the C compiler cannot compile a one-line program: " ^ text)))
      (compiled t [ "-o"; program; source ])
  in
  warn t said;
  Result.map_error
    (fun said ->
      Untried
        (Printf.sprintf "a program compiled by `%s` does not run here%s: %s" (command t)
           (if t.run = [] then "; use --runner to name a command that runs it"
            else Printf.sprintf " with `%s`" (String.concat " " t.run))
           (beginning said)))
    (ran t program)

let arithmetic t =
  let program = t.folder / "arithmetic" in
  let* said =
    compiled t (include_flags t @ [ "-o"; program; t.resources.selftest / "arithmetic.c"; "-lm" ])
  in
  warn t said;
  Result.map_error
    (fun said ->
      Unfit (Printf.sprintf "arithmetic compiled by `%s` %s" (command t) (beginning said)))
    (ran t program)

(* {1 Files that all programs need} *)

let common t =
  let core = List.map (fun file -> t.resources.runtime_sources / "core" / file) in
  let elementary =
    List.filter
      (fun file -> Filename.check_suffix file ".c")
      (List.sort compare (Array.to_list (Sys.readdir t.resources.elementary)))
  in
  (t.resources.selftest / "runner.c")
  :: core [ "text.c"; "cell_read.c"; "cell_write.c"; "frame.c"; "trace.c" ]
  @ List.map (fun file -> t.resources.elementary / file) elementary

let objects t =
  List.fold_left
    (fun made source ->
      let* made = made in
      let result = t.folder / (Filename.remove_extension (Filename.basename source) ^ ".o") in
      let* said = compiled t (include_flags t @ [ "-c"; "-o"; result; source ]) in
      warn t said;
      Ok (result :: made))
    (Ok []) (common t)

(* {1 Running a program} *)

(* The generated C of a program, its table for hosts, and the expected output. *)
let made t group =
  let file = t.resources.selftest / (group.name ^ ".frob") in
  let request =
    Request.make
      ~options:{ Common_options.default with real = t.real }
      ~library:t.resources.library file
  in
  let sink = Diagnostic.sink () in
  match
    ( Queries.compile sink (Source.create ()) { request with entry = group.entry },
      Queries.interpretable sink (Source.create ()) { request with entry = group.meant } )
  with
  | Some (files : Cgen.Emit.t), Some (core, entry, _) -> (
      let csv = Sample_input.(csv (rows t.real)) in
      let output = Buffer.create 10_000 and at = ref 0 in
      let read () =
        if !at = String.length csv then None
        else (
          incr at;
          Some csv.[!at - 1])
      in
      let name = "the input of the self-test" in
      let write = Buffer.add_string output in
      match (files.host_table, Interp.Trace.run core ~entry ~name ~read ~write) with
      | Some table, Ok () -> (files, table, Buffer.contents output)
      | _, Error errors -> Diagnostic.bug ~stage:"Tools.Selftest" "%s" (String.concat "; " errors)
      | None, _ -> Diagnostic.bug ~stage:"Tools.Selftest" "no host can run %s" file)
  | _, _ -> Diagnostic.bug ~stage:"Tools.Selftest" "%s is rejected" file

(* Writes the recording in the format of recording.h. Each row has a separate array, because C++ has
   no compound literals. *)
let recording real output =
  let lines = List.tl (List.filter (( <> ) "") (String.split_on_char '\n' output)) in
  let cells k (row : Sample_input.row) =
    Printf.sprintf "static const char *const cells_%d[] = { %s };\n" k
      (String.concat ", " (List.map Basis.C_string.literal row.cells))
  and row k ((row : Sample_input.row), line) =
    Printf.sprintf "    { INT64_C(%d), cells_%d,\n      %s },\n" row.time_ns k
      (Basis.C_string.literal (line ^ "\n"))
  in
  let inputs = Sample_input.rows real in
  Printf.sprintf
    "#include \"recording.h\"\n\n\
     %sconst struct recorded_row recorded_rows[] = {\n\
     %s};\n\
     const int recorded_row_count = %d;\n"
    (String.concat "" (List.mapi cells inputs))
    (String.concat "" (List.mapi row (List.combine inputs lines)))
    (List.length lines)

let tried t objects group =
  let files, table, output = made t group in
  let path suffix = t.folder / (group.name ^ suffix) in
  let adapted = if List.exists Tcc.is_named t.compile then Tcc.adapted else Fun.id in
  let* () = write (path ".h") (adapted files.header) in
  let* () = write (path ".c") (adapted files.source) in
  let* () = write (path "_host.c") (adapted table) in
  let* () = write (path "_recording.c") (recording t.real output) in
  let sources =
    List.map path [ ".c"; "_host.c"; "_recording.c" ]
    @ List.map (fun file -> t.resources.selftest / file) group.sources
  in
  let* said = compiled t (include_flags t @ [ "-o"; path "" ] @ sources @ objects @ [ "-lm" ]) in
  warn t said;
  Result.map_error
    (fun said ->
      Unfit
        (Printf.sprintf "%s.frob, compiled by `%s`:\n%s" group.name (command t) (beginning said)))
    (ran t (path ""))

(* {1 The verdict} *)

let line name value = Printf.printf "%s: %s\n%!" name value

(* Tests all groups, even after a failure. Returns whether any group failed. *)
let groups_failed t objects =
  List.fold_left
    (fun failed group ->
      match tried t objects group with
      | Ok () ->
          line group.name "correct";
          failed
      | Error (Untried text | Unfit text) ->
          line group.name "incorrect";
          prerr_endline ("error: " ^ text);
          true)
    false groups

let judged t =
  line "compiler" (command t);
  let* () = works t in
  let* () = arithmetic t in
  line "arithmetic" "correct";
  let* objects = objects t in
  Ok (groups_failed t objects)

let verdict t = function
  | Ok false ->
      line "verdict" (if t.warned then "fit, with warnings" else "fit");
      Exit_status.ok
  | Ok true ->
      line "verdict" "unfit";
      Exit_status.rejected
  | Error (Unfit text) ->
      prerr_endline ("error: " ^ text);
      line "verdict" "unfit";
      Exit_status.rejected
  | Error (Untried text) -> Reporting.wrong_use text

let run compiler =
  match Installation.find () with
  | Error text -> Reporting.wrong_use text
  | Ok resources ->
      let folder = Temporary.folder () in
      let cc = Option.value compiler.cc ~default:(Toolchain.this_machine ()).compiler in
      let flags = Option.fold compiler.cflags ~none:Toolchain.flags ~some:words in
      let run = Option.fold compiler.runner ~none:[] ~some:words in
      let compile = words cc @ flags in
      let t = { compile; run; resources; folder; real = compiler.real; warned = false } in
      verdict t (judged t)
