open Basis
open Typing
open Typing.Ir

let not_a_number (e : expr) =
  Diagnostic.(
    warning ~code:"W0307" ~at:e.span "this is always NaN (not a number)"
    |> note "every comparison with NaN is False, and every result computed from NaN is NaN")

let wraps_around (e : expr) n =
  Diagnostic.(
    warning ~code:"W0308" ~at:e.span
      "this is %d, which is out of range for an `Int`: it wraps around to %ld" n (Int32.of_int n)
    |> note "an `Int` must be between -2147483648 and 2147483647"
    |> hint "use Floats, or a larger unit")

let unmet ~of_ (e : expr) (unmet : Warning_fact.unmet) =
  let refused format = Diagnostic.warning ~code:"W0316" ~at:e.span format in
  let out_of_range what range x =
    refused "this is too %s: `%s` needs a number %s %g" what of_ range x
  in
  match unmet with
  | Negative_time ->
      Diagnostic.(
        warning ~code:"W0309" ~at:e.span "`%s` has a negative time, which counts as zero" of_
        |> hint "write a time of at least `0[s]`")
  | Negative ->
      refused "this is below zero: `%s` needs a number of at least 0" of_
      |> Diagnostic.hint "remove the sign"
  | Below x -> out_of_range "small" "of at least" x
  | Not_above x -> out_of_range "small" "above" x
  | Above x -> out_of_range "large" "of at most" x
  | Zero_sum -> refused "these numbers add up to 0: `%s` needs a nonzero sum" of_

let swapped_limits ~of_ ~(low : expr) ~(high : expr) =
  Diagnostic.(
    warning ~code:"W0316" ~at:low.span "the lower limit of `%s` is above the upper one" of_
    |> label ~at:high.span "the upper limit"
    |> hint "swap them")

let limits_cross ~(limit : expr) ~(other : expr) =
  Diagnostic.(
    warning ~code:"W0316" ~at:limit.span
      "the lower limit is above the upper one, so the result is always this limit"
    |> label ~at:other.span "the other limit"
    |> hint "swap the two limits")

let limited_constant ~(low : expr) ~(high : expr) ~(limited : expr) =
  Diagnostic.(
    warning ~code:"W0316" ~at:low.span
      "this is the lower limit of `clamp`, and the value being limited is a constant"
    |> label ~at:limited.span "the limited value"
    |> label ~at:high.span "the upper limit"
    |> hint "write the limits first: `clamp low high x`")
