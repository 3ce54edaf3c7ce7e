open Basis

type t = {
  options : Common_options.t;
  file : string;
  entry : string;
  library : string;
  files : Resolve.Files.t;
  robot : Cgen.Robot.t option;
  settings : Resolve.Parameters.setting list;
  batch : bool;
  banner : bool;
}

let make ?(options = Common_options.default) ?robot ?(entry = "main") ?(batch = false)
    ?(banner = false) ~library file =
  { options; file; entry; library; files = Program_file.files; robot; settings = []; batch; banner }

let own_robot r =
  match r.robot with Some robot when Cgen.Robot.is_own robot -> Some robot | Some _ | None -> None

let judges r = r.options.asserts <> Off
let measures_margins r = r.options.asserts = Margin

let probes r =
  if measures_margins r then Probe.Selection.(claims :: margins :: r.options.probes)
  else r.options.probes

let stage r sink name ~lint ~print result =
  if r.options.lint && not (Diagnostic.has_errors sink) then lint result;
  if r.options.dump = Some name then Format.printf "%a@?" print result;
  if r.options.stop_after = Some name || Diagnostic.has_errors sink then None else Some result

let each_pass r print =
  let before = ref "" in
  fun (pass : _ Pass.t) program ->
    if r.options.dump = Some Passes then (
      let after = Format.asprintf "%a" print program in
      if after <> !before then Format.printf "%s: %s@.%s@." pass.name pass.reason after;
      before := after)
