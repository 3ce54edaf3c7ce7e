(* Writes random programs and the examples, each with random input, as files: NAME.csv, and for a
   random program NAME.frob. *)

open Fuzz

let ( / ) = Filename.concat
let root = "../../.."

let tools =
  {
    Engines.library = root / "stdlib";
    runtime = root / "runtime";
    folder = Filename.current_dir_name;
    real = Basis.Real.Double;
    probed = false;
  }

let write path text =
  let channel = open_out_bin path in
  Fun.protect ~finally:(fun () -> close_out channel) (fun () -> output_string channel text)

let with_input ?robot ~rows ~name seed file =
  match Engines.load ?robot tools ~entry:"main" file with
  | Error outcome -> failwith (file ^ " " ^ Engines.describe outcome)
  | Ok subject -> (
      match Engines.recordings (Random.State.make [| seed |]) ~rows subject with
      | recording :: _ -> write (name ^ ".csv") (Recording.csv recording)
      | [] -> failwith "no input")

let random seed =
  let name = Printf.sprintf "random_%d" seed in
  write (name ^ ".frob")
    (Constant.in_range Basis.Real.Double (Program.make ~seed ~first:0 ~count:6 ()));
  with_input ~rows:50 ~name seed (name ^ ".frob")

let example argument =
  let file, robot =
    match String.split_on_char ':' argument with
    | [ file; robot ] -> (
        match Build.Robots.known (Some robot) with
        | Ok robot -> (file, robot)
        | Error reason -> failwith reason)
    | _ -> (argument, None)
  in
  with_input ?robot ~rows:200 ~name:(Filename.remove_extension (Filename.basename file)) 7 file

let () =
  match Array.to_list Sys.argv with
  | _ :: count :: files ->
      List.iter random (List.init (int_of_string count) (fun k -> k + 1));
      List.iter example files
  | [] | [ _ ] -> failwith "written COUNT FILE.frob[:ROBOT]..."
