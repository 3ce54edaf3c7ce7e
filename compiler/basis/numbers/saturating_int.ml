(* The limit up to which JSON readers represent every integer exactly. *)
let most = 1 lsl 53
let add a b = min most (a + b)
let times a b = if a = 0 || b = 0 then 0 else if a > most / b then most else a * b
let round_up bytes ~alignment = add bytes (alignment - 1) / alignment * alignment
