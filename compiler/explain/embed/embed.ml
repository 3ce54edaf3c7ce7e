(* Writes an OCaml module with the pages whose paths are the arguments. *)

let read path =
  let channel = open_in_bin path in
  let text = really_input_string channel (in_channel_length channel) in
  close_in channel;
  text

let () =
  let paths = List.tl (Array.to_list Sys.argv) in
  let page path = (Filename.remove_extension (Filename.basename path), read path) in
  let pages = List.sort compare (List.map page paths) in
  print_string "let all =\n  [\n";
  List.iter (fun (code, text) -> Printf.printf "    (%S, %S);\n" code text) pages;
  print_string "  ]\n"
