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

(* The command that produces the diagnostic. *)
type stage = Check | Compile | Interpret | Test | Probe of string | Set of string

let diagnose ~library stage files =
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
  (sources, Basis.Diagnostic.all sink)

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

type t = { code : string; files : (string * string) list; fixed : string }

let find code =
  let blocks = blocks (Option.get (Basis.Explain.find code)) in
  let name, text = faulty_example code blocks in
  let others = List.filter (fun (other, _) -> other <> name) (List.filter_map beside blocks) in
  { code; files = (name, text) :: others; fixed = List.assoc "frob" blocks }

let faulty ~library t = diagnose ~library (stage_of t.code) t.files

let fixed ~library t =
  let others = List.filter (fun (name, _) -> name <> main) (List.tl t.files) in
  diagnose ~library (stage_of t.code) ((main, t.fixed) :: others)
