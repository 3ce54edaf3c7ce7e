open Basis

let nanoseconds real seconds =
  let rounded = Real.round real and big = Real.all_whole_from real in
  let ns = if seconds < 0. then 0. else rounded (seconds *. 1e9) in
  if ns < big then rounded (rounded (ns +. big) -. big) else ns

let of_local_time real t = nanoseconds real (Real.round real (Real.of_int64 real t /. 1e9))

(* Binary search works because [of_local_time] is monotonic. *)
let reaches real number =
  let reached t = of_local_time real t >= number in
  (* invariant: not reached at [low] - 1, but reached at [high] *)
  let rec search low high =
    if Int64.equal low high then low
    else
      let middle = Int64.add low (Int64.div (Int64.sub high low) 2L) in
      if reached middle then search low middle else search (Int64.succ middle) high
  in
  if reached Int64.max_int then Some (search 0L Int64.max_int) else None
