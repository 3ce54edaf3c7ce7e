let ( let* ) = General.( let* )
let option name value = match value with Some value -> [ name; value ] | None -> []
let flag name value = if value then [ name ] else []
let seconds = Printf.sprintf "%.9f"

type serve = {
  world : string option;
  seed : int;
  tcp : int option;
  camera : int option;
  duration : float option;
  model : string option;
  log : string option;
  link : string option;
}

let missing host = Printf.sprintf "the host %s is missing: install frobc again" host

let become host arguments =
  match Process.become host arguments with
  | Not_found _ | Failed _ -> General.wrong_use (missing host)

(* The name of a robot, and the shared object of the user's C files if it is their own. *)
let served (resources : Resources.t) ~robot ~sources =
  let ( let* ) = Result.bind in
  let* known = Robots.known robot in
  match known with
  | Some own when Cgen.Robot.is_own own ->
      let* () = Program_file.all_exist sources in
      let* header = Compiled.robot_header resources own in
      let* object_ =
        Toolchain.build
          ~machine:
            { (Toolchain.this_machine ()) with options = [ "-I"; resources.runtime_sources ] }
          Shared_object ~headers:resources.headers ~inputs:[]
          ~foreign:(Some { Toolchain.sources; folders = [] })
          ~name:own.name [ header ]
      in
      Ok (Some own.name, Some object_)
  | (Some _ | None) when sources <> [] ->
      Error "--with is for a robot of your own: --robot FILE.frob"
  | Some _ | None -> Ok (robot, None)

let serve ~robot ~sources serve =
  let* resources = Resources.find () in
  let* robot, own = served resources ~robot ~sources in
  let world = Option.value serve.world ~default:(Filename.concat resources.worlds "room.toml") in
  let outputs =
    List.map (Output.asked Link "--link") (Option.to_list serve.link)
    @ List.map (Output.asked Log "--log") (Option.to_list serve.log)
  in
  let* () = Output.check ~reads:((world :: Option.to_list robot) @ sources) outputs in
  become resources.server
    ([ "--world"; world; "--seed"; string_of_int serve.seed ]
    @ option "--robot" robot @ option "--own" own
    @ option "--tcp" (Option.map string_of_int serve.tcp)
    @ option "--camera" (Option.map string_of_int serve.camera)
    @ option "--for" (Option.map seconds serve.duration)
    @ option "--model" serve.model @ option "--log" serve.log @ option "--link" serve.link)

type run = {
  device : string;
  duration : float option;
  rate : float;
  record : string option;
  patience : float option;
  reconnect : float option;
  settings : string list;
  cameras : string list;
  priority : int option;
  lock_memory : bool;
  exit_when_done : bool;
  console : bool;
  look : Viewing.look option;
}

let executable (general : General.t) target ~entry ~sources file continue =
  let own = Robots.own_of general.robot in
  Built.built general Executable ~entry ~sources
    ~linked:(Target.linked ?own target ~real:general.real) file (fun _ program -> continue program)

let this_machine = Option.get (Target.of_name "host")

let run general ~entry ~sources ~simulated run file =
  let general = Probed.with_claims general in
  let* () =
    match simulated with
    | [] -> Ok ()
    | option :: _ -> Error (Printf.sprintf "%s is for the simulator, and not for a robot" option)
  in
  let outputs = List.map (Output.asked Table "--record") (Option.to_list run.record) in
  let* () = Output.check ~reads:(file :: sources) outputs in
  let* resources = Resources.find () in
  General.with_params general resources ~entry file @@ fun params ->
  let control = match run.look with Some { control; _ } -> control | None -> false in
  Viewing.shown general ~params ~entry ~sources run.look ~record:run.record ~world:None file
  @@ fun viewer ->
  executable general this_machine ~entry ~sources file (fun program ->
      become program
        ([ "--device"; run.device; "--rate"; Printf.sprintf "%.9g" run.rate ]
        @ option "--for" (Option.map seconds run.duration)
        @ option "--record" run.record
        @ option "--patience" (Option.map seconds run.patience)
        @ option "--reconnect" (Option.map seconds run.reconnect)
        @ General.param_options params @ General.assert_options general
        @ List.concat_map (fun setting -> [ "--set"; setting ]) run.settings
        @ List.concat_map (fun source -> [ "--camera"; source ]) run.cameras
        @ option "--priority" (Option.map string_of_int run.priority)
        @ flag "--lock-memory" run.lock_memory
        @ flag "--exit-when-done" run.exit_when_done
        @ flag "--console" run.console @ flag "--control" control
        @ if viewer = [] then [] else "--viewer" :: viewer))

(* Calls within the object are direct: nobody puts another step in the place of its own. *)
let library general ~entry ~sources ~output file =
  let path = Option.value output ~default:(C_file.name file ^ ".so") in
  let asked = if output = None then "the library" else "-o" in
  let* () = Output.check ~reads:(file :: sources) [ Output.asked Program asked path ] in
  Built.shared ~batch:true ~options:[ "-fno-semantic-interposition" ] general ~entry ~sources file
    (fun _ library ->
      let* () = Output.copy library path in
      Exit_status.ok)

let build general ~entry ~sources ~target ~output file =
  match Target.of_name target with
  | None ->
      General.wrong_use
        (Printf.sprintf
           "there is no target `%s`; the targets: %s; for Arduino there is `frobc export \
            --platformio`"
           target (String.concat ", " Target.names))
  | Some target ->
      let path = Option.value output ~default:(C_file.name file) in
      let asked = if output = None then "the program" else "-o" in
      let* () = Output.check ~reads:(file :: sources) [ Output.asked Program asked path ] in
      executable general target ~entry ~sources file (fun program ->
          let* () = Output.copy program path in
          match Target.size_tool target with
          | Some tool -> (
              match Process.hand_over tool [ path ] with Ok status -> status | Error _ -> 0)
          | None -> Exit_status.ok)
