let size = 20
let rows = 25

type failure = { number : int; outcome : Engines.outcome; text : string }

let summary ~seed { number; outcome; _ } =
  Printf.sprintf "program %d of seed %d %s" number seed (Engines.describe outcome)

let describe ~seed failure = Printf.sprintf "%s\n\n%s\n" (summary ~seed failure) failure.text

let write path text =
  let channel = open_out_bin path in
  Fun.protect ~finally:(fun () -> close_out channel) (fun () -> output_string channel text)

(* Input for a batch: what a program does alone, it does on that of its batch. *)
let on_input_of batch (tools : Engines.tools) engines ~seed ~first ~count =
  let text = Program.make ~seed ~first ~count in
  let file = Filename.concat tools.folder "program.frob" in
  write file text;
  let random = Random.State.make [| seed; batch; 1 |] in
  let outcome =
    match Engines.load tools ~entry:"main" file with
    | Error outcome -> outcome
    | Ok subject ->
        Engines.judge tools engines subject (Engines.recordings random ~rows subject)
  in
  match outcome with
  | Agree -> None
  | Rejected _ | Failed _ | Differ _ -> Some { number = first; outcome; text }

let failure tools engines ~seed ~first ~count = on_input_of first tools engines ~seed ~first ~count

let failures tools engines ~seed ~first ~count =
  match failure tools engines ~seed ~first ~count with
  | None -> []
  | Some whole -> (
      let alone i = on_input_of first tools engines ~seed ~first:(first + i) ~count:1 in
      match List.filter_map alone (List.init count Fun.id) with
      | [] -> [ whole ]
      | failures -> failures)
