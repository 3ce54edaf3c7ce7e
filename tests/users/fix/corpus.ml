open Basis

let read path =
  let channel = open_in_bin path in
  Fun.protect
    ~finally:(fun () -> close_in channel)
    (fun () -> really_input_string channel (in_channel_length channel))

let starts prefix line = String.starts_with ~prefix line
let without n line = String.sub line n (String.length line - n)

(* The text between a line that begins a program and one that ends it. *)
let between ~begins ~ends ~line text =
  let rec outside found = function
    | [] -> found
    | l :: rest -> if begins l then inside found [] rest else outside found rest
  and inside found lines = function
    | [] -> found
    | l :: rest when ends l -> outside (String.concat "\n" (List.rev ("" :: lines)) :: found) rest
    | l :: rest -> inside found (line l :: lines) rest
  in
  List.rev (outside [] (String.split_on_char '\n' text))

let programs path =
  let text = read path in
  match Filename.extension path with
  | ".frob" -> [ text ]
  | ".md" -> between text ~begins:(starts "```frob") ~ends:(String.equal "```") ~line:Fun.id
  | _ ->
      (* The last line is the delimiter of the here-document. *)
      let without_last program =
        match List.rev (String.split_on_char '\n' program) with
        | _ :: _ :: rest -> String.concat "\n" (List.rev ("" :: rest))
        | short -> String.concat "\n" short
      in
      between text
        ~begins:(fun l -> starts "  $ cat >" l && String.contains l '<')
        ~ends:(fun l -> not (starts "  >" l))
        ~line:(fun l -> if String.length l > 4 then without 4 l else "")
      |> List.map without_last

let check ~library text =
  let file = "program.frob" in
  let sink = Diagnostic.sink () and sources = Source.create () in
  let disk : Resolve.Files.t = Build.Program_file.files in
  let read path = if String.equal path file then Ok text else disk.read path in
  let request = Build.Request.make ~library file in
  Build.Queries.check sink sources { request with files = { disk with read } };
  (Diagnostic.all sink, sources)

let each f =
  let library = Sys.argv.(1) in
  let program path text =
    let diagnostics, sources = check ~library text in
    List.iter (f ~path ~text diagnostics sources) diagnostics
  in
  let rec go () =
    match input_line stdin with
    | exception End_of_file -> ()
    | path ->
        List.iter (program path) (programs path);
        go ()
  in
  go ()
