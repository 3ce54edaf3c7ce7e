open Basis

let exact_below = 0x4000000000000L

let nanoseconds real seconds =
  let rounded = Real.round real and big = Real.all_whole_from real in
  let ns = rounded (seconds *. 1e9) in
  let ns = if Float.is_nan ns then ns else if ns > 0. then ns else 0. in
  if ns < big then rounded (rounded (ns +. big) -. big) else ns

let of_local_time real t = nanoseconds real (Real.round real (Real.of_int64 real t /. 1e9))

(* [of_local_time] never falls. *)
let reaches real number =
  let reached t = of_local_time real t >= number in
  (* not reached at [low] - 1, reached at [high] *)
  let rec search low high =
    if Int64.equal low high then low
    else
      let middle = Int64.add low (Int64.div (Int64.sub high low) 2L) in
      if reached middle then search low middle else search (Int64.succ middle) high
  in
  if reached Int64.max_int then Some (search 0L Int64.max_int) else None

let is_big real : Ir.atom -> bool = function
  | Float x -> Float.equal x (Real.all_whole_from real)
  | _ -> false

let same_signal (a : Ir.atom) (b : Ir.atom) =
  match (a, b) with Signal a, Signal b -> a.id = b.id | _, _ -> false

let time definition seconds =
  match definition seconds with
  | Some (Ir.Time { unit = Seconds; restart }) -> Some restart
  | Some _ | None -> None

(* Of what time it is the product: when that starts again. *)
let product definition ns =
  match definition ns with
  | Some (Ir.Op (Multiply, ([ seconds; Float 1e9 ] | [ Float 1e9; seconds ]))) ->
      time definition seconds
  | Some _ | None -> None

let not_negative definition ns =
  match definition ns with
  | Some (Ir.Op (Maximum, [ Float zero; ns' ])) when Float.equal zero 0. -> product definition ns'
  | Some _ | None -> None

let is_whole real definition rounded ns =
  match definition rounded with
  | Some (Ir.Op (Subtract, [ sum; b ])) -> (
      is_big real b
      &&
      match definition sum with
      | Some (Ir.Op (Add, [ ns'; b ])) -> is_big real b && same_signal ns' ns
      | Some _ | None -> false)
  | Some _ | None -> false

let recognize real definition (rhs : Ir.rhs) : Ir.rhs =
  match rhs with
  | If { condition; then_; else_ = ns } -> (
      match definition condition with
      | Some (Ir.Op (Less, [ ns'; b ]))
        when is_big real b && same_signal ns' ns && is_whole real definition then_ ns ->
          Option.fold (not_negative definition ns) ~none:rhs ~some:(fun restart ->
              Ir.Time { unit = Nanoseconds; restart })
      | Some _ | None -> rhs)
  | _ -> rhs
