(* The smallest program that nests too deeply is too long to print. *)
let longest = 2000
let library = "../../../../stdlib"

let print_file (name, text) =
  if String.length text > longest then Printf.printf "%s: %d bytes\n" name (String.length text)
  else Printf.printf "%s:\n%s" name text;
  print_newline ()

let without_folder text = Str.global_replace (Str.regexp_string "program-1/") "" text

let () =
  let example = Example.find Sys.argv.(1) in
  List.iter print_file example.files;
  let sources, diagnostics = Example.faulty ~library example in
  print_string (without_folder (Basis.Render_text.diagnostics ~colour:false sources diagnostics))
