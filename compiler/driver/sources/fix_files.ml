open Basis

type choice = Safe | All

(* {1 Making fixes} *)

let overlap (a, a') (b, b') = if a = a' && b = b' then a = b else a < b' && b < a'

let applied sources ~file fixes =
  let text = Option.value (Source.text sources file) ~default:"" in
  let offsets (e : Diagnostic.edit) =
    (Source.offset sources file e.span.start, Source.offset sources file e.span.stop)
  in
  let take (edits, taken) (fix : Diagnostic.fix) =
    let own = List.map (fun e -> (offsets e, e.Diagnostic.text)) fix.edits in
    let is_here (e : Diagnostic.edit) = String.equal e.span.file file in
    let is_free (at, _) = not (List.exists (fun (other, _) -> overlap at other) edits) in
    if List.for_all is_here fix.edits && List.for_all is_free own then (own @ edits, fix :: taken)
    else (edits, taken)
  in
  let edits, taken = List.fold_left take ([], []) fixes in
  let buffer = Buffer.create (String.length text) in
  let add from ((start, stop), replacement) =
    Buffer.add_string buffer (String.sub text from (start - from));
    Buffer.add_string buffer replacement;
    stop
  in
  let from = List.fold_left add 0 (List.sort compare edits) in
  Buffer.add_string buffer (String.sub text from (String.length text - from));
  (Buffer.contents buffer, List.rev taken)

(* {1 Until there are none} *)

let check general ~library ~robot file text =
  let sink = Diagnostic.sink () and sources = Source.create () in
  let read path = if String.equal path file then Ok text else Program_file.files.read path in
  let request = General.request general ?robot ~library file in
  Pipeline.check sink sources { request with files = { Program_file.files with read } };
  (sink, sources)

(* Of several ways to mend one thing the first. *)
let offered choice (d : Diagnostic.t) =
  match (choice, d.fixes) with
  | All, first :: _ -> Some (d, first)
  | Safe, [ only ] when only.safe -> Some (d, only)
  | Safe, _ | All, [] -> None

(* What each step makes leads to what a later stage has to say. *)
let most_rounds = 100

let rec mended check choice file ~done_ rounds text =
  let sink, sources = check file text in
  let place (d : Diagnostic.t) = (d.code, d.message, Span.line d.at.start) in
  (* A fix that does not take its diagnostic away would be made for ever. *)
  let is_new (d, _) = not (List.mem (place d) done_) in
  let offers = List.filter is_new (List.filter_map (offered choice) (Diagnostic.all sink)) in
  let after, made = applied sources ~file (List.map snd offers) in
  let named = List.filter (fun (_, fix) -> List.memq fix made) offers in
  let line ((d : Diagnostic.t), (fix : Diagnostic.fix)) =
    Format.asprintf "%a: %s (%s)" Span.pp d.at fix.title d.code
  in
  if made = [] || rounds = 0 then (text, [], sink, sources)
  else
    let done_ = List.map (fun (d, _) -> place d) named @ done_ in
    let text, lines, sink, sources = mended check choice file ~done_ (rounds - 1) after in
    (text, List.map line named @ lines, sink, sources)

(* {1 The command} *)

let ( let* ) = General.( let* )

let write file ~before after =
  match Output.check ~reads:[] [ { path = file; content = Source; asked = "fix" } ] with
  | Error _ as error -> error
  | Ok () when Resolve.Files.on_disk.read file <> Ok before ->
      Error (Printf.sprintf "%s has changed in the meantime, and stays as it is now" file)
  | Ok () -> Output.rewrite file after

let one general ~diff choice ~library ~robot file =
  let* () = Program_file.check file in
  match Resolve.Files.on_disk.read file with
  | Error (Missing | Unreadable _) -> General.wrong_use ("cannot read " ^ file)
  | Ok before ->
      let check = check general ~library ~robot in
      let after, lines, sink, sources = mended check choice file ~done_:[] most_rounds before in
      let* () =
        if diff then Ok (print_string (Difference.unified ~name:(Printable.name file) before after))
        else if lines = [] then Ok ()
        else (
          List.iter (fun line -> print_endline (Printable.name line)) lines;
          write file ~before after)
      in
      let offers = List.filter (fun (d : Diagnostic.t) -> d.fixes <> []) (Diagnostic.all sink) in
      if choice = Safe && offers <> [] && not diff then
        Printf.printf "%d more may not be what you meant: frobc fix --all makes %s\n"
          (List.length offers)
          (if List.compare_length_with offers 1 = 0 then "it" else "them");
      flush stdout;
      General.print_diagnostics general.format sources sink;
      General.status sink

let run general ~diff choice files =
  let* resources = Resources.find () in
  let* robot = Robots.known general.General.robot in
  let statuses = List.map (one general ~diff choice ~library:resources.library ~robot) files in
  if List.mem Exit_status.rejected statuses then Exit_status.rejected
  else List.fold_left max Exit_status.ok statuses
