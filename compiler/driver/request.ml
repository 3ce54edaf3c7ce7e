open Basis

type t = {
  file : string;
  entry : string;
  library : string;
  files : Resolve.Files.t;
  robot : Cgen.Robot.t option;
  real : Real.t;
  probes : string list;
  asserts : bool;
  margins : bool;
  params : Resolve.Parameters.setting list;
  batch : bool;
  specialization_limit : int;
  lint : bool;
  dump : Stage.t option;
  stop_after : Stage.t option;
}

let make ~library file =
  {
    file;
    entry = "main";
    library;
    files = Program_file.files;
    robot = None;
    real = Double;
    probes = [];
    asserts = false;
    margins = false;
    params = [];
    batch = false;
    specialization_limit = 10_000;
    lint = false;
    dump = None;
    stop_after = None;
  }

let own_robot r =
  match r.robot with Some robot when Cgen.Robot.is_own robot -> Some robot | Some _ | None -> None

let stage r sink name ~lint ~print result =
  if r.lint && not (Diagnostic.has_errors sink) then lint result;
  if r.dump = Some name then Format.printf "%a@?" print result;
  if r.stop_after = Some name || Diagnostic.has_errors sink then None else Some result

let each_pass r print =
  let before = ref "" in
  fun (pass : _ Pass.t) program ->
    if r.dump = Some Passes then (
      let after = Format.asprintf "%a" print program in
      if after <> !before then Format.printf "%s: %s@.%s@." pass.name pass.reason after;
      before := after)
