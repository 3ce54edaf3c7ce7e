(* Tests the pages that explain diagnostics: the faulty example of each page must have exactly
   the code of the page, and the corrected one must have none. Each code that the compiler can
   emit must have a page. *)

let read path =
  let channel = open_in_bin path in
  Fun.protect
    ~finally:(fun () -> close_in channel)
    (fun () -> really_input_string channel (in_channel_length channel))

let write path text =
  let channel = open_out_bin path in
  Fun.protect ~finally:(fun () -> close_out channel) (fun () -> output_string channel text)

(* The fenced blocks of a page: the fence's info string, and the text. *)
let blocks page =
  let starts_block line = String.length line > 3 && String.sub line 0 3 = "```" in
  let rec outside found = function
    | [] -> List.rev found
    | line :: rest when starts_block line ->
        inside found (String.sub line 3 (String.length line - 3)) [] rest
    | _ :: rest -> outside found rest
  and inside found info text = function
    | [] -> failwith "a block is not closed"
    | "```" :: rest -> outside ((info, String.concat "\n" (List.rev ("" :: text))) :: found) rest
    | line :: rest -> inside found info (line :: text) rest
  in
  outside [] (String.split_on_char '\n' page)

(* A new folder for each program, so that programs do not import each other's modules. *)
let folder =
  let count = ref 0 in
  fun () ->
    incr count;
    let path = Printf.sprintf "program-%d" !count in
    if not (Sys.file_exists path) then Sys.mkdir path 0o755;
    path

let library = "../../../stdlib"

(* The command that produces the diagnostic. *)
type stage = Check | Compile | Interpret | Test | Probe of string | Set of string

let codes_of stage files =
  let folder = folder () in
  List.iter (fun (name, text) -> write (Filename.concat folder name) text) files;
  let sink = Basis.Diagnostic.sink () and sources = Basis.Source.create () in
  let main = Filename.concat folder (fst (List.hd files)) in
  let options = { Build.Common_options.default with lint = true } in
  let request = Build.Request.make ~options ~library main in
  (match stage with
  | Probe name ->
      let options = { options with probes = [ name ] } in
      ignore (Build.Queries.compile sink sources { request with options })
  | Set name ->
      let settings = [ { Resolve.Parameters.name; text = "0.3[m/s]" } ] in
      ignore (Build.Queries.params sink sources { request with settings })
  | Compile -> ignore (Build.Queries.compile sink sources request)
  | Test -> ignore (Build.Queries.checks sink sources request)
  | Interpret -> ignore (Build.Queries.interpretable sink sources request)
  | Check -> Build.Queries.check sink sources request);
  List.sort_uniq String.compare
    (List.map (fun (d : Basis.Diagnostic.t) -> d.code) (Basis.Diagnostic.all sink))

let beside (info, text) =
  match String.split_on_char ' ' info with
  | [ "frob-module"; name ] -> Some (name ^ ".frob", text)
  | _ -> None

(* Codes of the last stages need an entry, so the program is compiled. *)
let stage_of code =
  if String.equal code Build.Interpreted.no_interpreter then Interpret
  else if String.equal code "E0392" then Test
  else if String.equal code Build.Probes.unknown then Probe "speed"
  else if String.equal code "E0507" then Set "speed"
  else if List.mem (String.sub code 0 3) [ "E04"; "E05" ] then Compile
  else Check

let main = "main.frob"

(* A fence may specify the name of the faulty file: ```frob-error main.test.frob. *)
let faulty (info, text) =
  match String.split_on_char ' ' info with
  | [ "frob-error" ] -> Some (main, text)
  | [ "frob-error"; name ] -> Some (name, text)
  | _ -> None

(* The smallest program that nests too deeply is too long for a page, so it is generated. *)
let faulty_example code blocks =
  match code with
  | "E0106" ->
      let depth = 10_001 in
      (main, "x = " ^ String.make depth '(' ^ "1" ^ String.make depth ')')
  | _ -> Option.get (List.find_map faulty blocks)

let check_page code () =
  let blocks = blocks (Option.get (Basis.Explain.find code)) in
  let result (name, text) =
    let others = List.filter (fun (other, _) -> other <> name) (List.filter_map beside blocks) in
    codes_of (stage_of code) ((name, text) :: others)
  in
  Alcotest.(check (list string)) "the example" [ code ] (result (faulty_example code blocks));
  Alcotest.(check (list string)) "the cured example" [] (result (main, List.assoc "frob" blocks))

(* Finds the codes in the compiler's sources. *)
let emitted () =
  let pattern text i =
    i + 6 < String.length text
    && text.[i] = '"'
    && (text.[i + 1] = 'E' || text.[i + 1] = 'W')
    && String.for_all (function '0' .. '9' -> true | _ -> false) (String.sub text (i + 2) 4)
    && text.[i + 6] = '"'
  in
  let codes_in path =
    let text = read path in
    List.filter_map
      (fun i -> if pattern text i then Some (String.sub text (i + 1) 5) else None)
      (List.init (String.length text) Fun.id)
  in
  let rec sources path =
    if Sys.is_directory path then
      List.concat_map
        (fun name -> sources (Filename.concat path name))
        (Array.to_list (Sys.readdir path))
    else if Filename.check_suffix path ".ml" && Filename.basename path <> "explain_pages.ml" then
      [ path ]
    else []
  in
  List.sort_uniq String.compare (List.concat_map codes_in (sources "../../../compiler"))

let check_complete () =
  Alcotest.(check (list string)) "codes with a page" (emitted ()) Basis.Explain.codes

let () =
  let pages = List.map (fun c -> Alcotest.test_case c `Quick (check_page c)) Basis.Explain.codes in
  Alcotest.run "explain"
    [
      ("pages", pages);
      ("completeness", [ Alcotest.test_case "every code has a page" `Quick check_complete ]);
    ]
