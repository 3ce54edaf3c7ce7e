open Basis

let stdin_name = "-"

let all_of_stdin () =
  set_binary_mode_in stdin true;
  let text = Buffer.create 65536 in
  let rec go () =
    match Buffer.add_channel text stdin 65536 with
    | () -> go ()
    | exception End_of_file -> Buffer.contents text
  in
  go ()

let read file =
  if file = stdin_name then
    match all_of_stdin () with
    | text -> Ok text
    | exception Sys_error reason -> Error ("cannot read standard input: " ^ reason)
  else
    match Program_file.check file with
    | Error _ as error -> error
    | Ok () -> (
        match Resolve.Files.on_disk.read file with
        | Ok text -> Ok text
        | Error (Missing | Unreadable _) -> Error ("cannot read " ^ Printable.name file))

(* The number of the first line in which two texts differ, and that line in each text. *)
let first_difference before after =
  let rec go n = function
    | a :: before, b :: after when String.equal a b -> go (n + 1) (before, after)
    | before, after -> (n, List.nth_opt before 0, List.nth_opt after 0)
  in
  go 1 (String.split_on_char '\n' before, String.split_on_char '\n' after)

let show_difference name before after =
  let line, was, would_be = first_difference before after in
  let show sign text =
    match text with
    | None | Some "" -> Printf.printf "  %s\n" sign
    | Some text -> Printf.printf "  %s %s\n" sign (Printable.name text)
  in
  Printf.printf "%s:%d\n" (Printable.name name) line;
  show "-" was;
  show "+" would_be

let write file text =
  if file = stdin_name then (
    set_binary_mode_out stdout true;
    print_string text;
    Ok ())
  else
    match Output.check ~reads:[] [ { path = file; content = Source; asked = "format" } ] with
    | Error _ as error -> error
    | Ok () -> Output.rewrite file text

let ( let* ) = Reporting.( let* )

let one ~check file =
  let* before = read file in
  let name = if file = stdin_name then "standard input" else file in
  let sink = Diagnostic.sink () and sources = Source.create () in
  Source.add sources ~file:name before;
  match Formatting.Formatter.text (Advice.Of_syntax.into sink) ~file:name before with
  | Broken ->
      Reporting.print_diagnostics Text sources sink;
      Exit_status.rejected
  | Refused law ->
      Reporting.report_bug "format"
        (Printf.sprintf "%s was left unchanged, because after formatting %s" name
           (Formatting.Laws.name law))
  | Formatted after when check ->
      if String.equal before after then Exit_status.ok
      else (
        show_difference name before after;
        Exit_status.rejected)
  | Formatted after ->
      if file <> stdin_name && String.equal before after then Exit_status.ok
      else
        let* () = write file after in
        Exit_status.ok

let run ~check files =
  let statuses = List.map (one ~check) files in
  if List.mem Exit_status.bug statuses then Exit_status.bug
  else if List.mem Exit_status.rejected statuses then Exit_status.rejected
  else List.fold_left max Exit_status.ok statuses
