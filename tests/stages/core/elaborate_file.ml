(* [elaborate_file STAGE LIBRARY FILE] prints a file's definitions as Typed or as Core (STAGE is
   [typed] or [core]) after checking them with the lints; or its diagnostics. *)

open Basis

let print stage typed =
  Typing.Lint.program typed;
  let core = Core.Of_typed.program typed in
  Core.Lint.program core;
  match stage with
  | "typed" -> Typing.Print.program Format.std_formatter typed
  | "core" -> Core.Print.program Format.std_formatter core
  | _ -> ()

let () =
  let stage = Sys.argv.(1) and library = Sys.argv.(2) and file = Sys.argv.(3) in
  let sink = Diagnostic.sink () and source = Source.create () in
  let remember ~file text = Source.add source ~file text in
  let typed =
    Option.bind
      (Resolve.Program.load (Advice.Of_resolve.into sink) ~files:Resolve.Files.on_disk ~remember
         ~library file)
      (Typing.Of_resolved.program (Advice.Of_typing.into sink) ~real:Double)
  in
  print_string (Render_text.diagnostics ~colour:false source (Diagnostic.all sink));
  Option.iter (print stage) typed
