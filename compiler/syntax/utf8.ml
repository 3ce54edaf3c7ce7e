let is_continuation c = Char.code c land 0xc0 = 0x80

let length_at text i =
  match Char.code text.[i] with
  | c when c < 0x80 -> 1
  | c when c < 0xe0 -> 2
  | c when c < 0xf0 -> 3
  | _ -> 4

(* The Unicode Standard, table 3-7: the second byte's range says what the
   first allows; the others are 80..BF. *)
let first_error text =
  let n = String.length text in
  let byte i = if i < n then Char.code text.[i] else -1 in
  let within low high i = byte i >= low && byte i <= high in
  let rec go i =
    if i >= n then None
    else
      match byte i with
      | c when c < 0x80 -> go (i + 1)
      | c when c >= 0xc2 && c <= 0xdf && within 0x80 0xbf (i + 1) -> go (i + 2)
      | c when c >= 0xe0 && c <= 0xef ->
          let low = if c = 0xe0 then 0xa0 else 0x80 in
          let high = if c = 0xed then 0x9f else 0xbf in
          if within low high (i + 1) && within 0x80 0xbf (i + 2) then go (i + 3) else Some i
      | c when c >= 0xf0 && c <= 0xf4 ->
          let low = if c = 0xf0 then 0x90 else 0x80 in
          let high = if c = 0xf4 then 0x8f else 0xbf in
          if within low high (i + 1) && within 0x80 0xbf (i + 2) && within 0x80 0xbf (i + 3)
          then go (i + 4)
          else Some i
      | _ -> Some i
  in
  go 0
