open Basis

(* What events have for the operators of truths. *)
let of_events words ~subject (expected : Expected.t) =
  let e =
    Option.bind subject (fun (e : Resolve.Ir.expr) -> Show.quote words e.span)
    |> Option.fold ~none:"e" ~some:Source.grouped
  in
  let now = Printf.sprintf "`isEvent %s` tells whether it occurs now" e in
  match expected.because with
  | Operand { operator = "&&" | "||"; other; _ } ->
      let b = Option.fold (Show.quote words other.span) ~none:"b" ~some:Source.grouped in
      Some (Printf.sprintf "%s; `gate %s %s` is the event where that is True, too" now e b)
  | Parameter { callee = Some "||"; _ } -> Some "`mergeE a b` occurs where one of two events does"
  | Parameter { callee = Some "&&"; _ } ->
      Some "`pairEvents a b` occurs where two events do, and `gate e b` where `b` is True"
  | Parameter { callee = Some "not"; _ } -> Some now
  | _ -> None

(* A number where a truth is needed. *)
let compared words ~(subject : Resolve.Ir.expr option) found =
  match (Type.expand found, subject) with
  | Number _, Some { desc = Number { digits; _ }; _ } ->
      Some
        (Printf.sprintf "the truths are `True` and `False`: it is `%s`"
           (if float_of_string_opt digits = Some 0. then "False" else "True"))
  | Number (_, u), _ ->
      let e =
        Option.bind subject (fun (e : Resolve.Ir.expr) -> Show.quote words e.span)
        |> Option.value ~default:"x"
      in
      let u = Units.resolve u in
      let text =
        if Units.equal u Units.one || Units.is_open u then Printf.sprintf "%s /= 0" e
        else Printf.sprintf "%s < 1[%s]" e (Show.measure words u)
      in
      Some (Printf.sprintf "no number is True or False: a comparison is, as in `%s`" text)
  | _ -> None
