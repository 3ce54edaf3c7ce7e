let ( / ) = Filename.concat

open Basis.Let_syntax.Result

let folder = "frob-demo"
let program = folder / "wall_follow.frob"
let test = Resolve.Test_file.path program
let world = folder / "world.toml"
let log = folder / "run.csv"
let picture = folder / "run.png"

let copied (resources : Resources.t) path =
  match Resolve.Files.on_disk.read (resources.demo / Filename.basename path) with
  | Ok text -> Ok (path, text)
  | Error (Missing | Unreadable _) ->
      Error
        (Printf.sprintf "%s is missing: reinstall frobc" (resources.demo / Filename.basename path))

let create () =
  let* resources = Installation.find () in
  let* program = copied resources program in
  let* test = copied resources test in
  let* world = copied resources world in
  let* () = Output.folder folder in
  Output.write [ program; test; world ]

(* Describes the run before it starts, because the simulator replaces this process. *)
let tell (run : Simulating.run) =
  let live = run.look <> None in
  Printf.printf "%s is a program that follows walls. The demo runs it with this command:\n" program;
  Printf.printf "  frobc run %s %s\n" program
    (if live then "--view" else Printf.sprintf "--for 60s --record %s --picture %s" log picture);
  if not live then (
    Printf.printf "The run as a picture: %s\n" picture;
    Printf.printf "The value of every signal at any instant, on a page:\n  frobc view %s %s\n" log
      program);
  Printf.printf "Change the program and run `frobc demo` again, or test it:\n  frobc test %s\n\n%!"
    folder

let run (run : Simulating.run) =
  Reporting.(
    let* () = if Sys.file_exists program then Ok () else create () in
    tell run;
    let outputs, host =
      match run.look with
      | Some _ -> ((None, None), run.host)
      | None -> ((Some log, Some picture), "--for" :: "60" :: run.host)
    in
    Simulating.run
      { Common_options.default with asserts = Count }
      ~entry:"main" ~sources:[]
      { run with world = Some world; record = fst outputs; picture = snd outputs; host }
      program)
