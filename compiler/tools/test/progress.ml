type t = {
  label : string;
  total : int;
  started : float;
  mutable completed : int;
  mutable shown : float; (* time of the last update *)
}

let between_looks = 0.1
let start label ~total = { label; total; started = Unix.gettimeofday (); completed = 0; shown = 0. }

let span seconds =
  if seconds < 60. then Printf.sprintf "%.0f s" seconds
  else if seconds < 3600. then Printf.sprintf "%.0f min" (seconds /. 60.)
  else Printf.sprintf "%.1f hours" (seconds /. 3600.)

let left t now =
  if t.completed = 0 then ""
  else
    let each = (now -. t.started) /. float_of_int t.completed in
    Printf.sprintf ", %s left" (span (each *. float_of_int (t.total - t.completed)))

let add t count =
  t.completed <- t.completed + count;
  let now = Unix.gettimeofday () in
  if now -. t.shown > between_looks then (
    t.shown <- now;
    Terminal.show ~head:t.label
      ~tail:(Printf.sprintf "%d of %d runs%s" t.completed t.total (left t now)))

let finish t = if t.shown > 0. then Terminal.clear ()
