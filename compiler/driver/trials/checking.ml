type options = {
  pattern : string option;
  seeds : int option;
  jobs : int option;
  rate : float;
  json : bool;
  junit : string option;
  update : bool;
  keep : string;
}

type t = {
  general : General.t;
  sources : string list;
  options : options;
  resources : Resources.t;
  jobs : int;
  rejected : (string * string, string) Hashtbl.t;
}

let alone general ~sources resources =
  let jobs = None and pattern = None and seeds = None and junit = None in
  let options =
    { pattern; seeds; jobs; rate = 50.; json = false; junit; update = false; keep = "failed" }
  in
  { general; sources; options; resources; jobs = 1; rejected = Hashtbl.create 1 }

let read path =
  let channel = open_in_bin path in
  Fun.protect
    ~finally:(fun () -> close_in channel)
    (fun () -> really_input_string channel (in_channel_length channel))

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

(* What is wrong with it is told once, however many tests need it. *)
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
    Compiled.accepted ~quiet:true Pipeline.measures context.general context.resources ~entry file
      (fun _ measures ->
        found := measures;
        Exit_status.ok)
  in
  if status = Exit_status.ok then Ok !found else Error "does not compile"

(* The first line of what a host complains of. *)
let complaint (result : Workers.result) =
  match String.split_on_char '\n' (String.trim result.errors) with
  | line :: _ when line <> "" ->
      let prefix = "error: " in
      let n = if String.starts_with ~prefix line then String.length prefix else 0 in
      String.sub line n (String.length line - n)
  | _ -> Printf.sprintf "the host ended with status %d" result.status

let slug text =
  let letter c =
    match c with 'a' .. 'z' | '0' .. '9' -> c | 'A' .. 'Z' -> Char.lowercase_ascii c | _ -> '-'
  in
  String.map letter text

(* For a shell, where it must be. *)
let quoted text =
  let is_plain = function
    | 'a' .. 'z' | 'A' .. 'Z' | '0' .. '9' | '_' | '-' | '.' | '/' | '+' -> true
    | _ -> false
  in
  if String.for_all is_plain text then text else Filename.quote text

let robot_option (general : General.t) =
  match general.robot with Some robot -> " --robot " ^ quoted robot | None -> ""

(* Where what can be looked at of a failed run is put. *)
let kept context (check : Checks.t) ending =
  Filename.concat context.options.keep (slug check.label ^ ending)
