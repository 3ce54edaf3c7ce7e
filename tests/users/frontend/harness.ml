(* harness.exe LIBRARY FILE...: compiles each file, from its bytes to C, as far as possible. For
   any input, the compiler must terminate without an exception.

   Under afl-fuzz (built with OCAMLPARAM='_,afl-instrument=1') one process handles many inputs,
   each stored under the same file name; the protocol is afl's persistent mode. An exception
   aborts the process, which afl-fuzz counts as a crash. *)

open Basis

let read file =
  let channel = open_in_bin file in
  Fun.protect
    ~finally:(fun () -> close_in channel)
    (fun () -> really_input_string channel (in_channel_length channel))

(* Most inputs do not parse. They take little time, because the library is not read for them. *)
let parses file =
  let sink = Diagnostic.sink () in
  match Syntax.Parse.program (Advice.Of_syntax.into sink) ~file (read file) with
  | Some parsed when not (Diagnostic.has_errors sink) ->
      Syntax.Lint.program parsed;
      ignore (Format.asprintf "%a" Syntax.Print.program parsed);
      true
  | Some _ | None -> false

let show sink sources = ignore (Render_text.diagnostics ~colour:false sources (Diagnostic.all sink))

let run ~library file =
  if parses file then (
    let sink = Diagnostic.sink () and sources = Source.create () in
    let request =
      Build.Request.make ~options:{ Build.Common_options.default with lint = true } ~library file
    in
    Build.Queries.check sink sources request;
    show sink sources;
    if not (Diagnostic.has_errors sink) then (
      let sink = Diagnostic.sink () and sources = Source.create () in
      ignore (Build.Queries.compile sink sources request);
      show sink sources))
  else
    (* Also render the syntax errors with their places. *)
    let sink = Diagnostic.sink () and sources = Source.create () in
    let text = read file in
    Source.add sources ~file text;
    ignore (Syntax.Parse.program (Advice.Of_syntax.into sink) ~file text);
    show sink sources

(* {1 afl's persistent mode} *)

external reset_instrumentation : bool -> unit = "caml_reset_afl_instrumentation"

(* afl-fuzz searches the program for this text. *)
let marker = "##SIG_AFL_PERSISTENT##"
let inputs_of_a_process = 1000

let persistently f =
  ignore (Sys.opaque_identity marker);
  reset_instrumentation true;
  for _ = 1 to inputs_of_a_process do
    f ();
    Unix.kill (Unix.getpid ()) Sys.sigstop;
    reset_instrumentation false
  done;
  f ()

let () =
  match Array.to_list Sys.argv with
  | _ :: library :: files ->
      let all () = List.iter (run ~library) files in
      if Option.is_some (Sys.getenv_opt "__AFL_PERSISTENT") then persistently all else all ()
  | _ -> failwith "harness.exe LIBRARY FILE..."
