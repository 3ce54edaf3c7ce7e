open Basis

let is_angle t =
  match Type.repr t with
  | Alias { alias = { module_ = "Prelude"; name = "Angle" }; _ } -> true
  | _ -> false

let turn = 2. *. Float.pi

let beyond_a_turn (n : Resolve.Ir.number) =
  n.unit_ = None
  && match float_of_string_opt n.digits with Some value -> value > turn | None -> false

(* Not by [Context.report]: what it counts are errors. *)
let report (ctx : Context.t) ~at ~negative (n : Resolve.Ir.number) =
  let degrees = Printf.sprintf "%s[deg]" n.digits in
  Diagnostic.(
    warning ~code:"W0303" ~at "this angle is more than a whole turn: it is in radians"
    |> hint
         (Printf.sprintf "for degrees write `%s`"
            (if negative then Printf.sprintf "(-%s)" degrees else degrees))
    |> emit ctx.reader.sink)

let warn ctx (e : Resolve.Ir.expr) (expected : Expected.t) =
  match e.desc with
  | Number n when is_angle expected.ty && beyond_a_turn n -> report ctx ~at:e.span ~negative:false n
  | Negate { desc = Number n; _ } when is_angle expected.ty && beyond_a_turn n ->
      report ctx ~at:e.span ~negative:true n
  | _ -> ()
