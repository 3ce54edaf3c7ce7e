(* Writes an OCaml module that contains the library modules whose paths are the command-line
   arguments. Each entry has the file name for diagnostics, the text, and the marshalled syntax
   tree. *)

open Basis

let read path =
  let channel = open_in_bin path in
  let text = really_input_string channel (in_channel_length channel) in
  close_in channel;
  text

(* The file name that {!Resolve.Modules} uses for a library module. *)
let shown path = Filename.basename (Filename.dirname path) ^ "/" ^ Filename.basename path

let prepared path =
  let file = shown path and text = read path in
  match Syntax.Parse.program (Facts.ignored ()) ~file text with
  | Some tree -> (file, text, Marshal.to_string tree [])
  | None -> failwith (path ^ " has syntax errors: run frobc check on it")

let () =
  let paths = List.sort String.compare (List.tl (Array.to_list Sys.argv)) in
  print_string "let all =\n  [\n";
  List.iter
    (fun path ->
      let file, text, tree = prepared path in
      Printf.printf "    (%S,\n %S,\n %S);\n" file text tree)
    paths;
  print_string "  ]\n"
