let ( let* ) = Reporting.( let* )
let option name value = match value with Some value -> [ name; value ] | None -> []
let flag name value = if value then [ name ] else []

type serve = {
  world : string option;
  log : string option;
  link : string option;
  host : string list;
}

let missing host = Printf.sprintf "the host %s is missing: reinstall frobc" host

let become host arguments =
  match Process.become host arguments with
  | Not_found _ | Failed _ -> Reporting.wrong_use (missing host)

(* The name of the robot for the host; for a user-defined robot, also the shared object
   compiled from its C files. *)
let served (resources : Resources.t) ~robot ~sources =
  let open Basis.Let_syntax.Result in
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
          ~foreign:
            (Some
               {
                 Toolchain.sources =
                   List.filter (fun file -> not (Own_headers.is_header file)) sources;
                 folders = List.map Filename.dirname sources;
                 allowed = sources;
               })
          ~name:own.name [ header ]
      in
      Ok (Some own.name, Some object_)
  | (Some _ | None) when sources <> [] ->
      Error "--with is for your own robot: use it with --robot FILE.frob"
  | Some _ | None -> Ok (robot, None)

let serve ~robot ~sources serve =
  let* resources = Resources.find () in
  let* robot, own = served resources ~robot ~sources in
  let* world = Where.find resources [ Here ] (Option.value serve.world ~default:"room.toml") in
  let outputs =
    List.map (Output.asked Link "--link") (Option.to_list serve.link)
    @ List.map (Output.asked Log "--log") (Option.to_list serve.log)
  in
  let* () = Output.check ~reads:((world :: Option.to_list robot) @ sources) outputs in
  become resources.server
    (("--world" :: world :: serve.host)
    @ option "--robot" robot @ option "--own" own @ option "--log" serve.log
    @ option "--link" serve.link)

type run = {
  device : string;
  record : string option;
  look : Viewing.look option;
  host : string list;
}

let executable (general : Common_options.t) target ~entry ~sources file continue =
  let own = Robots.own_of general.robot in
  Built.built general Executable ~entry ~sources
    ~linked:(Target.linked ?own target ~real:general.real) file (fun _ program -> continue program)

let this_machine = Option.get (Target.of_name "host")

let run general ~entry ~sources run file =
  let general = Probed.with_claims general in
  let outputs = List.map (Output.asked Table "--record") (Option.to_list run.record) in
  let* () = Output.check ~reads:(file :: sources) outputs in
  let* resources = Resources.find () in
  Compiled.with_params general resources ~entry file @@ fun params ->
  let control = match run.look with Some { control; _ } -> control | None -> false in
  Viewing.shown general ~params ~entry ~sources run.look ~record:run.record ~world:None file
  @@ fun viewer ->
  executable general this_machine ~entry ~sources file (fun program ->
      become program
        (("--device" :: run.device :: run.host)
        @ option "--record" run.record @ Params.host_options params
        @ Common_options.assert_options general
        @ flag "--control" control
        @ if viewer = [] then [] else "--viewer" :: viewer))

(* [-fno-semantic-interposition] lets calls within the object be direct, because no other object
   replaces its functions. *)
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
      Reporting.wrong_use
        (Printf.sprintf
           "there is no target `%s`; the targets are %s; for Arduino, use `frobc export \
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
