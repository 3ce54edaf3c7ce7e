open Basis
open Ir

type walk = { facts : Fact.t Facts.t; constants : Constant.t }

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
        Facts.report w.facts (Warning (Not_a_number e))
  | (Apply _ | Negate _ | Global _), Some (Int n)
    when Int32.to_int (Int32.of_int n) <> n
         && match e.desc with Global _ -> Constant.is_of_any_numbers w.constants e | _ -> true ->
      Facts.report w.facts (Warning (Wraps_around { constant = e; value = n }))
  | _ -> ()

let rec expr w (e : expr) =
  number w e;
  Walk.parts (expr w) e

let warn facts resolved program =
  Walk.own resolved (expr { facts; constants = Constant.of_program program }) program
