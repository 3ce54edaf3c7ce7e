open Basis

type format = Text | Json
type asserts = Off | Count | Stop | Margin

type t = {
  format : format;
  dump : Stage.t option;
  stop_after : Stage.t option;
  lint : bool;
  specialization_limit : int;
  real : Real.t;
  robot : string option;
  probes : string list;
  asserts : asserts;
  params : string list;
}

(* {1 Speaking} *)

let colour () =
  Unix.isatty Unix.stderr
  && (match Sys.getenv_opt "NO_COLOR" with None | Some "" -> true | Some _ -> false)
  && Sys.getenv_opt "TERM" <> Some "dumb"

let print_diagnostics format sources sink =
  match (Diagnostic.all sink, format) with
  | [], _ -> ()
  | diagnostics, Text ->
      prerr_string (Render_text.diagnostics ~colour:(colour ()) sources diagnostics)
  | diagnostics, Json -> prerr_string (Render_json.diagnostics sources diagnostics)

(* What is wrong with the call and not with the program. *)
let wrong_use text =
  Printf.eprintf "error: %s\n" (Printable.text text);
  Exit_status.wrong_use

let report_bug stage message =
  Printf.eprintf "internal error in %s: %s\nThis is a fault of frobc's own, not of your program.\n"
    stage message;
  Exit_status.bug

(* Where it was not foreseen, the system's reason is the best that can be said. *)
let report_exception = function
  | Diagnostic.Bug { stage; message } -> report_bug stage message
  | Stack_overflow -> report_bug "frobc" "the stack overflowed"
  | Sys_error reason -> wrong_use reason
  | Unix.Unix_error (reason, _, what) ->
      let what = if what = "" then "frobc" else what in
      wrong_use (Printf.sprintf "%s: %s" what (Unix.error_message reason))
  | exn -> report_bug "frobc" (Printexc.to_string exn)

(* {1 Asking the compiler} *)

let request general ?robot ?(entry = "main") ?(batch = false) ~library file : Request.t =
  let {
    dump;
    stop_after;
    lint;
    specialization_limit;
    real;
    probes;
    asserts;
    format = _;
    robot = _;
    params = _;
  } =
    general
  in
  let margins = asserts = Margin and asserts = asserts <> Off in
  let probes = if margins then Probes.claims :: Probes.margins :: probes else probes in
  {
    file;
    entry;
    library;
    files = Program_file.files;
    robot;
    real;
    probes;
    asserts;
    margins;
    params = [];
    batch;
    specialization_limit;
    lint;
    dump;
    stop_after;
  }

let ( let* ) result continue =
  match result with Ok value -> continue value | Error text -> wrong_use text

(* An entry that is not there, or an engine that cannot run it, is a wrong call,
   not a wrong program. *)
let status sink =
  let wrong_call (d : Diagnostic.t) =
    List.mem d.code [ Typing.Entry.no_entry; Interpreted.no_interpreter; Probes.unknown ]
  in
  if List.exists wrong_call (Diagnostic.all sink) then Exit_status.wrong_use
  else if Diagnostic.has_errors sink then Exit_status.rejected
  else Exit_status.ok

let rec settings = function
  | [] -> Ok []
  | text :: others -> (
      match Resolve.Parameters.split text with
      | Some setting -> Result.map (fun others -> setting :: others) (settings others)
      | None ->
          Error (Printf.sprintf "--param takes NAME=VALUE, as in `kTurn=4[1/m]`, not `%s`" text))

(* What is wrong with them is told; a wrong value is a wrong call. *)
let with_params general (resources : Resources.t) ~entry file continue =
  if general.params = [] then continue []
  else
    let* given = settings general.params in
    let* () = Program_file.check file in
    let sink = Diagnostic.sink () and sources = Source.create () in
    (* The robot does not matter: parameters are the same for all. *)
    let plain =
      {
        (request general ~entry ~library:resources.library file) with
        dump = None;
        stop_after = None;
      }
    in
    match Pipeline.params sink sources { plain with params = given } with
    | Some set -> continue set
    | None ->
        print_diagnostics general.format sources sink;
        Exit_status.wrong_use

let assert_options general = if general.asserts = Stop then [ "--stop-when-violated" ] else []
let param_options set = List.concat_map (fun (p : Params.set) -> [ "--param"; p.setting ]) set
