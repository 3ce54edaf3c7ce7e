open Basis

let parse text =
  let sink = Diagnostic.sink () in
  let program = Syntax.Parse.program (Advice.Of_syntax.into sink) ~file:"main.frob" text in
  Option.iter Syntax.Lint.program program;
  (Diagnostic.all sink, program)

let codes text = List.map (fun (d : Diagnostic.t) -> d.code) (fst (parse text))
let printed program = Format.asprintf "%a" Syntax.Print.program program

let read path =
  let channel = open_in_bin path in
  let text = really_input_string channel (in_channel_length channel) in
  close_in channel;
  text

let files_of directory suffix =
  Array.to_list (Sys.readdir directory)
  |> List.filter (fun file -> Filename.check_suffix file suffix)
  |> List.sort String.compare
  |> List.map (Filename.concat directory)

let written () =
  List.concat_map
    (fun directory -> List.map (fun path -> (path, read path)) (files_of directory ".frob"))
    [ "../../../stdlib"; "../../../examples/wall_follow"; "programs"; "broken" ]
