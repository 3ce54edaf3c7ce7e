(* Takes a folder as its argument, and writes an OCaml module with the pages in its subfolders. *)

let read path =
  let channel = open_in_bin path in
  let text = really_input_string channel (in_channel_length channel) in
  close_in channel;
  text

let pages folder =
  let files =
    List.filter (fun f -> Filename.check_suffix f ".md") (Array.to_list (Sys.readdir folder))
  in
  List.map (fun f -> (Filename.remove_extension f, read (Filename.concat folder f))) files

let () =
  let folder = Sys.argv.(1) in
  let folders = List.map (Filename.concat folder) (Array.to_list (Sys.readdir folder)) in
  print_string "let all =\n  [\n";
  List.iter
    (fun (code, text) -> Printf.printf "    (%S, %S);\n" code text)
    (List.sort compare (List.concat_map pages (List.filter Sys.is_directory folders)));
  print_string "  ]\n"
