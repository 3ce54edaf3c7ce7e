let emit (r : Request.t) sink ~resolved typed =
  Resolve.Unused.warn sink resolved;
  Resolve.Deprecated.warn sink resolved;
  Typing.Suspicious_constants.warn sink resolved typed;
  Typing.Step_division.warn sink resolved typed;
  Typing.Wrapped_angles.warn sink resolved typed;
  Typing.Requirements.warn sink resolved typed;
  Typing.Unreachable_thresholds.warn sink resolved typed ~robot:(Option.map Robots.input r.robot)
