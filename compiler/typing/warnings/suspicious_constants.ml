open Basis
open Ir

type walk = { sink : Diagnostic.sink; constants : Constant.t }

let arguments (e : expr) =
  match e.desc with
  | Negate a | Power (a, _) -> [ a ]
  | _ -> ( match Constant.operation e with Some (_, arguments) -> arguments | None -> [])

let is_zero w e = Constant.float w.constants e = Some 0.

let is_on_purpose w e =
  match Constant.operation e with Some ("/", [ a; b ]) -> is_zero w a && is_zero w b | _ -> false

let number w (e : expr) =
  match (e.desc, Constant.value w.constants e) with
  | (Apply _ | Power _), Some (Float x) when Float.is_nan x ->
      let of_nan a =
        match Constant.float w.constants a with Some x -> Float.is_nan x | None -> false
      in
      if not (List.exists of_nan (arguments e) || is_on_purpose w e) then
        Diagnostic.(
          warning ~code:"W0307" ~at:e.span "this is never a number: it is NaN"
          |> note "every comparison with NaN is False, and every result computed from NaN is NaN"
          |> emit w.sink)
  | (Apply _ | Negate _ | Global _), Some (Int n)
    when Int32.to_int (Int32.of_int n) <> n
         && match e.desc with Global _ -> Constant.is_of_any_numbers w.constants e | _ -> true ->
      Diagnostic.(
        warning ~code:"W0308" ~at:e.span
          "this is %d, which is out of the range of Int: it wraps around to %ld" n (Int32.of_int n)
        |> note "an Int must be from -2147483648 to 2147483647"
        |> hint "use Floats, or a larger unit"
        |> emit w.sink)
  | _ -> ()

let rec expr w (e : expr) =
  number w e;
  Walk.parts (expr w) e

let warn sink resolved program =
  Walk.own resolved (expr { sink; constants = Constant.of_program program }) program
