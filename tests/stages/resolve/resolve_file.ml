(* [resolve_file LIBRARY FILE] prints a program's diagnostics, or, if there are none, its dump
   after the lint. *)

open Basis

let print_diagnostic (d : Diagnostic.t) =
  let shown = Diagnostic.for_display in
  let severity = match d.severity with Error -> "error" | Warning -> "warning" in
  Format.printf "%s[%s] %a: %s@." severity d.code Span.pp d.at (shown d.message);
  List.iter
    (fun (l : Diagnostic.label) -> Format.printf "  %a: %s@." Span.pp l.at (shown l.text))
    d.labels;
  List.iter (fun note -> Format.printf "  note: %s@." (shown note)) d.notes;
  List.iter (fun (hint : Diagnostic.hint) -> Format.printf "  hint: %s@." (shown hint.text)) d.hints

let () =
  let library = Sys.argv.(1) and file = Sys.argv.(2) in
  let sink = Diagnostic.sink () in
  let remember ~file:_ _ = () in
  let program =
    Resolve.Program.load (Advice.Of_resolve.into sink) ~files:Resolve.Files.on_disk ~remember
      ~library file
  in
  List.iter print_diagnostic (Diagnostic.all sink);
  match program with
  | None -> ()
  | Some program ->
      Resolve.Lint.program program;
      Format.printf "%a@?" Resolve.Print.program program
