(* [check_file LIBRARY FILE]: what the type checker says of a program; if that
   is nothing, the types of the definitions in the file. *)

open Basis

let () =
  let library = Sys.argv.(1) and file = Sys.argv.(2) in
  let sink = Diagnostic.sink () and source = Source.create () in
  let remember ~file text = Source.add source ~file text in
  let typed =
    Option.map
      (fun (program : Resolve.Ir.program) -> (program, Typing.Infer.program sink program))
      (Resolve.Program.load sink ~files:Resolve.Files.on_disk ~remember ~library file)
  in
  print_string (Render_text.diagnostics ~colour:false source (Diagnostic.all sink));
  match typed with
  | Some (resolved, typed) when not (Diagnostic.has_errors sink) ->
      Typing.Lint.program typed;
      List.iter
        (fun (d : Typing.Ir.definition) ->
          if String.equal d.name.module_ resolved.main_module then
            Printf.printf "%s :: %s\n" d.name.name (Typing.Show.scheme d.scheme))
        typed.definitions
  | Some _ | None -> ()
