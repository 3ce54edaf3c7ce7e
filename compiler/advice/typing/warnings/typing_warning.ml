open Basis
open Typing
open Typing.Ir

let step_division (e : expr) =
  Diagnostic.(
    warning ~code:"W0314" ~at:e.span
      "this divides by the length of the step, which is 0 at the first instant"
    |> note "at that instant the quotient is infinite, or NaN if the dividend is also 0"
    |> hint
         "for the slope of a signal, use `derivative`; otherwise divide only in a branch where the \
          step is longer than 0")

let unreachable_threshold (comparison : expr) result ~robot ~sensor ~reach =
  Diagnostic.(
    warning ~code:"W0310" ~at:comparison.span "this is always %s: on a %s, `%s` is at most %g m"
      (if result then "True" else "False")
      robot sensor reach
    |> note "when nothing is in range, the reading is `sonarReach i`"
    |> hint "compare the reading with a smaller distance")

let diagnostic sources (fact : Warning_fact.t) =
  match fact with
  | Not_a_number constant -> Constant_warning.not_a_number constant
  | Wraps_around { constant; value } -> Constant_warning.wraps_around constant value
  | Step_division e -> step_division e
  | Unmet { of_; argument; unmet } -> Constant_warning.unmet ~of_ argument unmet
  | Swapped_limits { of_; low; high } -> Constant_warning.swapped_limits ~of_ ~low ~high
  | Limits_cross { limit; other } -> Constant_warning.limits_cross ~limit ~other
  | Limited_constant { low; high; limited } -> Constant_warning.limited_constant ~low ~high ~limited
  | Unreachable_threshold { comparison; result; robot; sensor; reach } ->
      unreachable_threshold comparison result ~robot ~sensor ~reach
  | Angle_difference { resolved; difference; left; right } ->
      Wrapped_angle_warning.difference sources resolved difference left right
  | Wrapped_angle
      { resolved; function_; head; angle; scaled; instead; module_; same_arguments; unwrap } ->
      Wrapped_angle_warning.wrapped resolved ~name:function_.name ~head ~angle ~scaled ~instead
        ~module_ ~same_arguments unwrap
