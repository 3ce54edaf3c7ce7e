open Checking
open Session
open Basis.Let_syntax.Result

(* The number of the first line that differs, and that line in each text; [""] past the end of a
   text. *)
let difference was is =
  let rec from number = function
    | a :: was, b :: is when String.equal a b -> from (number + 1) (was, is)
    | was, is ->
        let head = function line :: _ -> line | [] -> "" in
        (number, head was, head is)
  in
  from 1 (String.split_on_char '\n' was, String.split_on_char '\n' is)

let most_shown = 60

let shown line =
  if line = "" then "nothing"
  else if String.length line <= most_shown then Printf.sprintf "`%s`" line
  else Printf.sprintf "`%s…`" (String.sub line 0 most_shown)

(* The time of the last instant. *)
let last_time text =
  let time line = float_of_string_opt (List.hd (String.split_on_char ',' line)) in
  List.fold_left
    (fun last line -> Option.value (time line) ~default:last)
    0. (String.split_on_char '\n' text)

let traced context file input =
  let general = { context.general with asserts = Off; probes = [] } in
  let program = Resolve.Test_file.program_or_self file in
  let* program = compiled context general ~entry:"main" program in
  match Workers.run ~jobs:1 [ (context.resources.trace_host, [ program; input ]) ] with
  | [ { status = 0; output; _ } ] -> Ok output
  | [ result ] -> Error (complaint result)
  | _ -> Error "cannot be run"

let there path =
  if Sys.file_exists path then Ok ()
  else
    Error
      (Printf.sprintf "there is no file %s; it must contain the input of the trace"
         (Basis.Printable.name path))

let written ~input ~golden is =
  let output = { Output.path = golden; content = Table; asked = "--update" } in
  let* () = Output.check ~reads:[ input ] [ output ] in
  let* packed = Packed.packed ~named:golden is in
  Result.map (fun () -> "wrote " ^ golden) (Output.write [ (golden, packed) ])

let compared context file ~input ~golden =
  let* () = there input in
  let* is = traced context file input in
  (* A file that is much longer than the output cannot be a trace of this program. *)
  let most = max (4 * String.length is) Interp.Csv.longest in
  let* was =
    if Sys.file_exists golden then Result.map Option.some (Packed.read ~most golden) else Ok None
  in
  let* note =
    match was with
    | Some was when String.equal was is -> Ok ""
    | _ when context.options.update -> written ~input ~golden is
    | None ->
        Error
          (Printf.sprintf
             "there is no file %s; it must contain the output of the trace: write it with \
              `--update`"
             golden)
    | Some was ->
        let line, was, is = difference was is in
        Error
          (Printf.sprintf
             "line %d of %s is %s, but the program returns %s; if the program is right, update the \
              file with `--update`"
             line golden (shown was) (shown is))
  in
  Ok (is, note)

let run context file (check : Checks.t) ~input ~output : Outcome.t =
  let outcome lasts result note =
    {
      Outcome.file;
      label = check.label;
      lasts;
      measures = [];
      chance = None;
      note;
      result;
      evidence = None;
    }
  in
  let golden = beside file output in
  match compared context file ~input:(beside file input) ~golden with
  | Error reason -> outcome 0. (Error reason) ""
  | Ok (text, note) ->
      let at = last_time text in
      let run =
        {
          Outcome.seed = None;
          fate = Held;
          at;
          by = "";
          truth = [];
          collisions = 0;
          first = None;
          measured = [];
        }
      in
      outcome at (Ok [ run ]) note
