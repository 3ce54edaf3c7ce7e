(* [specialize_file LIBRARY FILE] prints the Flow of a file's [main] after checking it with the
   lint; or its diagnostics. *)

open Basis

let () =
  let library = Sys.argv.(1) and file = Sys.argv.(2) in
  let sink = Diagnostic.sink () and source = Source.create () in
  let flow = Pipeline.flow sink source ~files:Resolve.Files.on_disk ~library file in
  print_string (Render_text.diagnostics ~colour:false source (Diagnostic.all sink));
  Option.iter (Flow.Print.program Format.std_formatter) flow
