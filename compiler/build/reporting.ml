open Basis

let colour () =
  Unix.isatty Unix.stderr
  && (match Sys.getenv_opt "NO_COLOR" with None | Some "" -> true | Some _ -> false)
  && Sys.getenv_opt "TERM" <> Some "dumb"

(* Flushes immediately, so that messages precede the results if both streams go to one file. *)
let print_diagnostics (format : Common_options.format) sources sink =
  (match (Diagnostic.all sink, format) with
  | [], _ -> ()
  | diagnostics, Text ->
      prerr_string (Render_text.diagnostics ~colour:(colour ()) sources diagnostics)
  | diagnostics, Json -> prerr_string (Render_json.diagnostics sources diagnostics));
  (* Ignores the error: even if the messages cannot be printed, the exit status still shows that the
     program was rejected. *)
  try flush stderr with Sys_error _ -> ()

let wrong_use text =
  Printf.eprintf "error: %s\n" (Printable.text text);
  Exit_status.wrong_use

let ( let* ) result continue =
  match result with Ok value -> continue value | Error text -> wrong_use text

let report_bug stage message =
  Printf.eprintf "internal error in %s: %s\nThis is a bug in frobc, not in your program.\n" stage
    message;
  Exit_status.bug

let report_exception = function
  | Diagnostic.Bug { stage; message } -> report_bug stage message
  | Stack_overflow ->
      wrong_use
        "the input is too large, or nested too deeply, for the stack of frobc; run `ulimit -s \
         unlimited` to allow a larger stack"
  | Sys_error reason -> wrong_use reason
  | Unix.Unix_error (reason, _, what) ->
      let what = if what = "" then "frobc" else what in
      wrong_use (Printf.sprintf "%s: %s" what (Unix.error_message reason))
  | exn -> report_bug "frobc" (Printexc.to_string exn)

(* If the entry is missing, or if the engine cannot run the program, the command line is wrong, not
   the program. *)
let status sink =
  let is_wrong_use (d : Diagnostic.t) =
    List.mem d.code
      [ Advice.Entry_point_mistake.no_entry; Interpreted.no_interpreter; Probes.unknown ]
  in
  if List.exists is_wrong_use (Diagnostic.all sink) then Exit_status.wrong_use
  else if Diagnostic.has_errors sink then Exit_status.rejected
  else Exit_status.ok
