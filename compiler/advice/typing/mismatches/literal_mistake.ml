open Basis

let long_array ~at ~length ~longest =
  Diagnostic.error ~code:"E0333" ~at "an array literal can have at most %d elements, not %d" longest
    length
  |> Diagnostic.hint "compute the elements with `generate (\\k -> …)`"

let empty_array at = Diagnostic.error ~code:"E0333" ~at "an array must have at least one element"

let int_out_of_range ~at (n : Resolve.Ir.number) ~same_bits =
  Diagnostic.(
    error ~code:"E0313" ~at "`%s` is out of range for an `Int`" n.digits
    |> note "an `Int` must be between -2147483648 and 2147483647"
    |> match same_bits with Some m -> hint "for these 32 bits, write `(%ld)`" m | None -> Fun.id)

let out_of_range ~at (n : Resolve.Ir.number) (real : Real.t) =
  let d = Diagnostic.error ~code:"E0315" ~at "the number `%s` is out of range" n.digits in
  match real with
  | Double -> d
  | Single -> Diagnostic.note "with `--real float`, the largest number is 3.4028234663852886e38" d
