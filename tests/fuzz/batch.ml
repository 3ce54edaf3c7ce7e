let size = 20
let rows = 25

type failure = { number : int; outcome : Engines.outcome; text : string }

let describe ~seed { number; outcome; text } =
  Printf.sprintf "program %d of seed %d %s\n\n%s\n" number seed (Engines.describe outcome) text

let write path text =
  let channel = open_out_bin path in
  Fun.protect ~finally:(fun () -> close_out channel) (fun () -> output_string channel text)

let failure (tools : Engines.tools) ~seed ~first ~count =
  let text = Program.make ~seed ~first ~count in
  let file = Filename.concat tools.folder "program.frob" in
  write file text;
  let random = Random.State.make [| seed; first; 1 |] in
  match Engines.compare tools random ~rows ~entry:"main" file with
  | Agree -> None
  | (Rejected _ | Failed _ | Differ _) as outcome -> Some { number = first; outcome; text }

let failures tools ~seed ~first ~count =
  match failure tools ~seed ~first ~count with
  | None -> []
  | Some whole -> (
      let alone i = failure tools ~seed ~first:(first + i) ~count:1 in
      match List.filter_map alone (List.init count Fun.id) with
      | [] -> [ whole ]
      | failures -> failures)
