open Basis
open Typing
open Diagnostic

(* The units of the settings that a library function takes before its signal. *)
type settings = Of_signal of int | Per_second | Second

let settings = function
  | "limit" | "deadband" -> Some (Of_signal 1)
  | "clamp" | "hysteresis" -> Some (Of_signal 2)
  | "rateLimit" -> Some Per_second
  | "lowPass" | "highPass" | "delayBy" -> Some Second
  | _ -> None

let number t =
  match Type.expand t with
  | Type.Number (_, u) when not (Units.is_open u) -> Some (Units.resolve u)
  | _ -> None

let is_number (e : Resolve.Ir.expr) =
  match e.desc with
  | Number { unit_ = None; _ } | Negate { desc = Number { unit_ = None; _ }; _ } -> true
  | _ -> false

(* The unit of the signal, which the call wrongly passes first. *)
let unit_of words (signal : Resolve.Ir.expr) ~position ~(decided_by : Expected.decider list) found =
  let is_it (d : Expected.decider) = Span.compare d.place signal.span = 0 in
  match List.find_opt is_it decided_by with
  | _ when position = 1 -> number found
  | Some { decides; _ } -> number decides
  | None -> Formula.unit_of words signal

let unit_text words kind u =
  match kind with
  | Of_signal _ -> Wording.measure words u
  | Per_second -> Wording.measure words (Units.divide u (Units.base (Environment.built_in "s")))
  | Second -> "s"

let with_unit unit_ (e : Resolve.Ir.expr) text =
  match e.desc with
  | Number { digits; _ } when float_of_string_opt digits = Some 0. -> text
  | _ when String.equal unit_ "1" -> text
  | Number _ -> Printf.sprintf "%s[%s]" text unit_
  | _ -> Printf.sprintf "(%s[%s])" text unit_

let wrong words ~(expected : Expected.t) ~found =
  match expected.because with
  | Parameter
      { callee = Some name; head = Some head; given = signal :: numbers; position; decided_by; _ }
    -> (
      let count = match settings name with Some (Of_signal n) -> n | Some _ -> 1 | None -> 0 in
      let is_library =
        match head.desc with Global { module_ = "Control" | "Filters"; _ } -> true | _ -> false
      in
      let quote (e : Resolve.Ir.expr) = Wording.quote words e.span in
      match (settings name, unit_of words signal ~position ~decided_by found, quote signal) with
      | Some kind, Some u, Some text
        when is_library
             && List.length numbers = count
             && List.for_all is_number numbers
             && not (is_number signal || Bare_number.literal words signal <> None) ->
          let unit_ = unit_text words kind u in
          let written e = with_unit unit_ e (Option.value (quote e) ~default:"…") in
          let fixed =
            String.concat " " ((name :: List.map written numbers) @ [ Source.grouped text ])
          in
          let last : Resolve.Ir.expr = List.nth numbers (count - 1) in
          let at = Span.merge head.span last.span in
          let d =
            error ~code:"E0320" ~at "the arguments of `%s` are in the wrong order" name
            |> hint "write `%s`" fixed
          in
          Some (if String.contains fixed '\n' then d else write at fixed d)
      | _ -> None)
  | _ -> None
