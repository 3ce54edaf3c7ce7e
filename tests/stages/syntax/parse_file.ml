(* [parse_file FILE] prints the parsed file, or its diagnostics. *)

open Basis

let () =
  let file = Sys.argv.(1) in
  let channel = open_in_bin file in
  let text = really_input_string channel (in_channel_length channel) in
  close_in channel;
  let sink = Diagnostic.sink () and source = Source.create () in
  Source.add source ~file text;
  let program = Syntax.Parse.program (Advice.Of_syntax.into sink) ~file text in
  print_string (Render_text.diagnostics ~colour:false source (Diagnostic.all sink));
  let print program =
    Syntax.Lint.program program;
    Syntax.Print.program Format.std_formatter program
  in
  Option.iter print program
