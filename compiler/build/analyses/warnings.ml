open Basis

(* Do diagnostics so far mention this place in a label? *)
let mentioned sink =
  let labels = List.concat_map (fun (d : Diagnostic.t) -> d.labels) (Diagnostic.all sink) in
  fun at -> List.exists (fun (l : Diagnostic.label) -> l.at = at) labels

let emit (r : Request.t) sink ~resolved typed =
  let names = Advice.Of_resolve.into sink in
  Resolve.Unused.warn names ~is_mentioned:(mentioned sink) resolved;
  Resolve.Deprecated.warn names resolved;
  Typing.Suspicious_constants.warn sink resolved typed;
  Typing.Step_division.warn sink resolved typed;
  Typing.Wrapped_angles.warn sink resolved typed;
  Typing.Requirements.warn sink resolved typed;
  Typing.Unreachable_thresholds.warn sink resolved typed ~robot:(Option.map Robots.input r.robot)
