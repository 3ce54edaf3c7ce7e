exception Used_up

let remaining = ref max_int
let left () = !remaining

let steps n =
  remaining := !remaining - n;
  if !remaining < 0 then raise_notrace Used_up

let step () = steps 1

let within limit f =
  let before = !remaining in
  let own = Int.min limit before in
  remaining := own;
  let give_back () =
    let enough = !remaining >= 0 in
    remaining := before - (own - !remaining);
    enough
  in
  match f () with
  | value -> if give_back () then Some value else None
  | exception Used_up ->
      ignore (give_back ());
      None
  | exception other ->
      ignore (give_back ());
      raise other
