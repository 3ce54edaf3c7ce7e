open Basis

type choice = Safe | All

(* {1 Applying fixes} *)

let overlap (a, a') (b, b') = if a = a' && b = b' then a = b else a < b' && b < a'

let applied sources ~file fixes =
  let text = Option.value (Source.text sources file) ~default:"" in
  let offsets (e : Diagnostic.edit) =
    (Source.offset sources file e.span.start, Source.offset sources file e.span.stop)
  in
  let ends = Line_ends.of_text text in
  let take (edits, taken) (fix : Diagnostic.fix) =
    let is_here (e : Diagnostic.edit) = String.equal e.span.file file in
    (* Two fixes may add the same import. *)
    let adds_import text = String.starts_with ~prefix:"import " (String.trim text) in
    let is_free ((at, text) as edit) =
      (adds_import text && List.mem edit edits)
      || not (List.exists (fun (other, _) -> overlap at other) edits)
    in
    match Kept_comments.fix sources fix with
    | Some { edits = made; _ } ->
        let written (e : Diagnostic.edit) = (offsets e, Line_ends.write ends e.text) in
        let own = List.map written made in
        if List.for_all is_here made && List.for_all is_free own then (own @ edits, fix :: taken)
        else (edits, taken)
    | None -> (edits, taken)
  in
  let edits, taken = List.fold_left take ([], []) fixes in
  let buffer = Buffer.create (String.length text) in
  let add from ((start, stop), replacement) =
    Buffer.add_string buffer (String.sub text from (start - from));
    Buffer.add_string buffer replacement;
    stop
  in
  let from = List.fold_left add 0 (List.sort_uniq compare edits) in
  Buffer.add_string buffer (String.sub text from (String.length text - from));
  (Buffer.contents buffer, List.rev taken)

(* {1 Repeating until no fix is left} *)

let check general ~library ~robot file text =
  let sink = Diagnostic.sink () and sources = Source.create () in
  let read path = if String.equal path file then Ok text else Program_file.files.read path in
  let request = Request.make ~options:general ?robot ~library file in
  Queries.check sink sources { request with files = { Program_file.files with read } };
  (sink, sources)

(* The fix to apply for a diagnostic. [All] chooses the first fix that can be applied; [Safe]
   chooses a fix only if it is safe and no other fix can be applied. *)
let offered choice sources (d : Diagnostic.t) =
  let can_be_made fix = Kept_comments.fix sources fix <> None in
  match (choice, List.filter can_be_made d.fixes) with
  | All, first :: _ -> Some (d, first)
  | Safe, [ only ] when only.safe -> Some (d, only)
  | Safe, _ | All, [] -> None

(* Maximum number of rounds. More than one may be necessary: after a fix, a later stage of the
   compiler can report more diagnostics. *)
let most_rounds = 100

let rec mended check choice file ~done_ rounds text =
  let sink, sources = check file text in
  let place (d : Diagnostic.t) = (Diagnostic.wording ~without_hints:true d, Span.line d.at.start) in
  (* Without this check, a fix that does not remove its diagnostic would be applied forever. *)
  let is_new (d, _) = not (List.mem (place d) done_) in
  let offers = List.filter_map (offered choice sources) (Diagnostic.all sink) in
  let offers = List.filter is_new offers in
  let after, made = applied sources ~file (List.map snd offers) in
  let named = List.filter (fun (_, fix) -> List.memq fix made) offers in
  let line ((d : Diagnostic.t), (fix : Diagnostic.fix)) =
    Format.asprintf "%a: %s (%s)" Span.pp d.at (Diagnostic.for_display fix.title) d.code
  in
  if made = [] || rounds = 0 then (text, [], sink, sources)
  else
    let done_ = List.map (fun (d, _) -> place d) named @ done_ in
    let text, lines, sink, sources = mended check choice file ~done_ (rounds - 1) after in
    (text, List.map line named @ lines, sink, sources)

(* {1 The command} *)

let ( let* ) = Reporting.( let* )

let write file ~before after =
  match Output.check ~reads:[] [ { path = file; content = Source; asked = "fix" } ] with
  | Error _ as error -> error
  | Ok () when Resolve.Files.on_disk.read file <> Ok before ->
      Error (Printf.sprintf "%s changed in the meantime; it was left untouched" file)
  | Ok () -> Output.rewrite file after

let one general ~diff choice ~library ~robot file =
  let* () = Program_file.check file in
  match Resolve.Files.on_disk.read file with
  | Error (Missing | Unreadable _) -> Reporting.wrong_use ("cannot read " ^ Printable.name file)
  | Ok before ->
      let check = check general ~library ~robot in
      let after, lines, sink, sources = mended check choice file ~done_:[] most_rounds before in
      let* () =
        if diff then Ok (print_string (Difference.unified ~name:(Printable.name file) before after))
        else if lines = [] then Ok ()
        else
          let written = write file ~before after in
          let tell line = print_endline (Printable.name line) in
          if written = Ok () then List.iter tell lines;
          written
      in
      let offers = List.filter_map (offered All sources) (Diagnostic.all sink) in
      if choice = Safe && offers <> [] && not diff then
        Printf.printf "%s may not be what you meant; to apply %s, run frobc fix --all\n"
          (match offers with
          | [ _ ] -> "1 more fix"
          | _ -> Printf.sprintf "%d more fixes" (List.length offers))
          (match offers with [ _ ] -> "it" | _ -> "them");
      flush stdout;
      Reporting.print_diagnostics general.format sources sink;
      Reporting.status sink

let run general ~diff choice files =
  let* resources = Installation.find () in
  let* robot = Robots.known general.Common_options.robot in
  let statuses = List.map (one general ~diff choice ~library:resources.library ~robot) files in
  if List.mem Exit_status.rejected statuses then Exit_status.rejected
  else List.fold_left max Exit_status.ok statuses
