open Common_options
open Reporting

type run = {
  world : string option;
  record : string option;
  picture : string option;
  look : Viewing.look option;
  host : string list;
}

let run general ~entry ~sources run file =
  let general = Probed.with_claims general in
  let* resources = Installation.find () in
  let* () = Program_file.check file in
  let* world = Where.world_of run.world resources file in
  let* general = Where.for_world general resources world in
  if Probed.asks_for_list general then Probed.print_list general ~entry file
  else
    let outputs =
      List.map (Output.asked Table "--record") (Option.to_list run.record)
      @ List.map (Output.asked Picture "--picture") (Option.to_list run.picture)
    in
    let* () = Output.check ~reads:(file :: world :: sources) outputs in
    let option name value = match value with Some value -> [ name; value ] | None -> [] in
    Compiled.with_params general resources ~entry file @@ fun params ->
    Viewing.shown general ~params ~entry ~sources run.look ~record:run.record ~world:(Some world)
      file
    @@ fun viewer ->
    Built.hosted general ~entry ~sources file
      ~host:(fun resources -> resources.Resources.simulator)
      ~arguments:(fun _ program ->
        (program :: "--world" :: world :: run.host)
        @ option "--record" run.record @ option "--picture" run.picture @ Params.host_options params
        @ assert_options general
        @ if viewer = [] then [] else "--viewer" :: viewer)
