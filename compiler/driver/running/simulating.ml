open General

type run = {
  world : string option;
  duration : float option;
  rate : float;
  seed : int;
  realtime : bool;
  record : string option;
  picture : string option;
  strict : bool;
  exit_when_done : bool;
  console : bool;
  look : Viewing.look option;
}

let run general ~entry ~sources run file =
  let general = Probed.with_claims general in
  let* resources = Resources.find () in
  let* () = Program_file.check file in
  let world = Where.world_of run.world resources file in
  let* general = Where.for_world general resources world in
  if Probed.asks_for_list general then Probed.print_list general ~entry file
  else
    let outputs =
      List.map (Output.asked Table "--record") (Option.to_list run.record)
      @ List.map (Output.asked Picture "--picture") (Option.to_list run.picture)
    in
    let* () = Output.check ~reads:(file :: world :: sources) outputs in
    let option name value = match value with Some value -> [ name; value ] | None -> [] in
    let flag name value = if value then [ name ] else [] in
    with_params general resources ~entry file @@ fun params ->
    Viewing.shown general ~params ~entry ~sources run.look ~record:run.record ~world:(Some world)
      file
    @@ fun viewer ->
    Built.hosted general ~entry ~sources file
      ~host:(fun resources -> resources.Resources.simulator)
      ~arguments:(fun _ program ->
        [ program; "--world"; world ]
        @ option "--for" (Option.map (Printf.sprintf "%.9f") run.duration)
        @ [ "--rate"; Printf.sprintf "%.9g" run.rate ]
        @ [ "--seed"; string_of_int run.seed ]
        @ flag "--realtime" run.realtime @ option "--record" run.record
        @ option "--picture" run.picture @ param_options params
        @ flag "--exit-when-done" run.exit_when_done
        @ flag "--console" run.console @ flag "--strict" run.strict @ assert_options general
        @ if viewer = [] then [] else "--viewer" :: viewer)
