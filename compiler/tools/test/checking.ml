open Session

let alone general ~sources resources =
  let jobs = None and pattern = None and seeds = None and junit = None in
  let options =
    { pattern; seeds; jobs; rate = 50.; json = false; junit; update = false; keep = "failed" }
  in
  let rejected = Hashtbl.create 1 and names = Hashtbl.create 1 in
  { general; sources; options; resources; jobs = 1; rejected; names }

let read path =
  let channel = open_in_bin path in
  Fun.protect
    ~finally:(fun () -> close_in channel)
    (fun () -> really_input_string channel (in_channel_length channel))

let beside file name = if Filename.is_relative name then Where.beside file name else name

let compiled_anew context general ~entry file =
  let path = ref None in
  let status =
    Built.shared ~quiet:true general ~entry ~sources:context.sources file (fun _ program ->
        path := Some program;
        Exit_status.ok)
  in
  match !path with
  | Some program -> Ok program
  | None when status = Exit_status.wrong_use -> Error "cannot be run"
  | None -> Error "does not compile"

(* Does not recompile a program that the compiler has rejected, so its errors are reported only
   once, no matter how many tests need the program. *)
let compiled context general ~entry file =
  match Hashtbl.find_opt context.rejected (file, entry) with
  | Some reason -> Error reason
  | None ->
      let result = compiled_anew context general ~entry file in
      Result.iter_error (Hashtbl.add context.rejected (file, entry)) result;
      result

let measures context ~entry file =
  let found = ref [] in
  let status =
    Compiled.accepted ~quiet:true Queries.measures context.general context.resources ~entry file
      (fun _ measures ->
        found := measures;
        Exit_status.ok)
  in
  if status = Exit_status.ok then Ok !found else Error "does not compile"

(* The first line of a host's error message. *)
let complaint (result : Workers.result) =
  match String.split_on_char '\n' (String.trim result.errors) with
  | line :: _ when line <> "" ->
      let prefix = "error: " in
      let n = if String.starts_with ~prefix line then String.length prefix else 0 in
      String.sub line n (String.length line - n)
  | _ -> (
      match Signals.name result.status with
      | Some signal -> Printf.sprintf "%s ended the host" signal
      | None -> Printf.sprintf "the host ended with status %d" result.status)

let slug text =
  let letter c =
    match c with 'a' .. 'z' | '0' .. '9' -> c | 'A' .. 'Z' -> Char.lowercase_ascii c | _ -> '-'
  in
  String.map letter text

let quoted = Basis.Printable.word

let program_words context =
  let options = Common_options.to_repeat context.general ~sources:context.sources in
  String.concat "" (List.map (fun word -> " " ^ quoted word) options)

let test_again context file (check : Checks.t) =
  Printf.sprintf "frobc test %s%s -k %s" (Basis.Printable.path file) (program_words context)
    (quoted check.label)

let kept context file (check : Checks.t) ending =
  let owner = (file, check.label) and plain = slug check.label in
  let program = slug (Filename.remove_extension (Filename.basename file)) in
  let candidate = function
    | 0 -> plain ^ ending
    | 1 -> Printf.sprintf "%s-%s%s" plain program ending
    | n -> Printf.sprintf "%s-%s-%d%s" plain program n ending
  in
  let rec free n =
    let name = candidate n in
    match Hashtbl.find_opt context.names name with
    | Some other when other <> owner -> free (n + 1)
    | Some _ | None ->
        Hashtbl.replace context.names name owner;
        name
  in
  Filename.concat context.options.keep (free 0)
