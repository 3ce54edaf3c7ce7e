open Basis
open Ir

type walk = { sink : Diagnostic.sink; constants : Constant.t }

let number w e =
  match Constant.value w.constants e with
  | Some (Float x) -> Some x
  | Some (Int n) -> Some (float_of_int n)
  | None -> None

(* The positions, from 0, of a lower and an upper limit. *)
let ranges (g : Global.t) =
  match (g.module_, g.name) with "Control", ("clamp" | "hysteresis") -> Some (0, 1) | _ -> None

(* The positions of arguments that must not be negative. *)
let sizes (g : Global.t) =
  match (g.module_, g.name) with
  | "Control", ("limit" | "deadband" | "rateLimit")
  | "Filters", ("lowPass2" | "hampel" | "rejectJumps")
  | "Angles", "rateLimitAngle" ->
      [ 0 ]
  | "Filters", ("slew" | "slewAfter" | "trapezoid" | "notch" | "stateVariable") -> [ 0; 1 ]
  | "Filters", "slewFrom" -> [ 1; 2 ]
  | "Filters", "rateLimitUpDown" -> [ 0; 1; 2 ]
  | _ -> []

let range w ~of_ (low : expr) (high : expr) =
  match (number w low, number w high) with
  | Some l, Some h when l > h ->
      Diagnostic.(
        warning ~code:"W0316" ~at:low.span "the lower limit of `%s` is above the upper one" of_
        |> label ~at:high.span "the upper limit"
        |> hint "swap them" |> emit w.sink)
  | _ -> ()

let size w ~of_ (e : expr) =
  match number w e with
  | Some x when x < 0. ->
      Diagnostic.(
        warning ~code:"W0316" ~at:e.span "this is below zero: `%s` needs a number of at least 0" of_
        |> hint "leave the sign out" |> emit w.sink)
  | _ -> ()

let fields w (c : constructor) given =
  let field name =
    List.find_map
      (fun (index, value) ->
        match List.nth_opt c.fields index with
        | Some (found, _) when String.equal found name -> Some value
        | _ -> None)
      given
  in
  match (c.constructor.module_, c.constructor.name) with
  | "Control", "Pid" -> Option.iter (size w ~of_:"largest") (field "largest")
  | "Pid", "PidSettings" -> (
      Option.iter (size w ~of_:"tf") (field "tf");
      match (field "lowest", field "highest") with
      | Some low, Some high -> range w ~of_:"PidSettings" low high
      | _ -> ())
  | _ -> ()

let rec expr w (e : expr) =
  (match e.desc with
  | Record (c, given) | Update (_, c, given) -> fields w c given
  | _ -> (
      match Constant.spine e with
      | { desc = Global (g, _); _ }, (_ :: _ as arguments) -> (
          let argument = List.nth_opt arguments in
          List.iter (fun index -> Option.iter (size w ~of_:g.name) (argument index)) (sizes g);
          match ranges g with
          | Some (low, high) -> (
              match (argument low, argument high) with
              | Some low, Some high -> range w ~of_:g.name low high
              | _ -> ())
          | None -> ())
      | _ -> ()));
  Walk.parts (expr w) e

let warn sink resolved program =
  Walk.own resolved (expr { sink; constants = Constant.of_program program }) program
