open Basis

(* Whether a diagnostic reported so far has a label at this place. *)
let mentioned sink =
  let labels = List.concat_map (fun (d : Diagnostic.t) -> d.labels) (Diagnostic.all sink) in
  fun at -> List.exists (fun (l : Diagnostic.label) -> l.at = at) labels

let emit (r : Request.t) sink ~sources ~resolved typed =
  let names = Advice.Of_resolve.into sink in
  Resolve.Unused.warn names ~is_mentioned:(mentioned sink) resolved;
  Resolve.Deprecated.warn names resolved;
  let facts = Advice.Of_typing.into ~sources sink in
  Typing.Suspicious_constants.warn facts resolved typed;
  Typing.Step_division.warn facts resolved typed;
  Typing.Wrapped_angles.warn facts resolved typed;
  Typing.Requirements.warn facts resolved typed;
  Typing.Unreachable_thresholds.warn facts resolved typed ~robot:(Option.map Robots.input r.robot)
