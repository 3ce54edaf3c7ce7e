let is_continuation c = Char.code c land 0xc0 = 0x80

let decode text i =
  let byte k = if i + k < String.length text then Char.code text.[i + k] else 0 in
  let continues k = byte k land 0xc0 = 0x80 in
  let low k = byte k land 0x3f in
  let c = byte 0 in
  if c < 0x80 then (1, c)
  else if c >= 0xc2 && c < 0xe0 && continues 1 then (2, ((c land 0x1f) lsl 6) lor low 1)
  else if c >= 0xe0 && c < 0xf0 && continues 1 && continues 2 then
    let code = ((c land 0x0f) lsl 12) lor (low 1 lsl 6) lor low 2 in
    if code >= 0x800 && not (code >= 0xd800 && code < 0xe000) then (3, code) else (0, 0)
  else if c >= 0xf0 && c < 0xf5 && continues 1 && continues 2 && continues 3 then
    let code = ((c land 0x07) lsl 18) lor (low 1 lsl 12) lor (low 2 lsl 6) lor low 3 in
    if code >= 0x10000 && code < 0x110000 then (4, code) else (0, 0)
  else (0, 0)

let eight_high_bits = 0x8080_8080_8080_8080L

let first_error text =
  let n = String.length text in
  (* Programs are almost entirely ASCII, so this checks eight bytes at a time. *)
  let rec go i =
    if i + 8 <= n && Int64.equal (Int64.logand (String.get_int64_ne text i) eight_high_bits) 0L then
      go (i + 8)
    else if i >= n then None
    else if Char.code (String.unsafe_get text i) < 0x80 then go (i + 1)
    else match decode text i with 0, _ -> Some i | length, _ -> go (i + length)
  in
  go 0
