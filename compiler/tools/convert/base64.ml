let digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/"

let encode buffer text =
  let length = String.length text in
  let byte i = if i < length then Char.code (String.unsafe_get text i) else 0 in
  let rec from i =
    if i < length then (
      let word = (byte i lsl 16) lor (byte (i + 1) lsl 8) lor byte (i + 2) in
      let digit k = String.unsafe_get digits ((word lsr (18 - (6 * k))) land 63) in
      Buffer.add_char buffer (digit 0);
      Buffer.add_char buffer (digit 1);
      Buffer.add_char buffer (if i + 1 < length then digit 2 else '=');
      Buffer.add_char buffer (if i + 2 < length then digit 3 else '=');
      from (i + 3))
  in
  from 0

let value = function
  | 'A' .. 'Z' as c -> Char.code c - 65
  | 'a' .. 'z' as c -> Char.code c - 71
  | '0' .. '9' as c -> Char.code c + 4
  | '+' -> 62
  | '/' -> 63
  | _ -> -1

let decode text =
  let length = String.length text in
  let padding =
    if length > 1 && text.[length - 2] = '=' then 2
    else if length > 0 && text.[length - 1] = '=' then 1
    else 0
  in
  let is_digit i = i >= length - padding || value text.[i] >= 0 in
  let rec all_digits i = i = length || (is_digit i && all_digits (i + 1)) in
  if length mod 4 <> 0 || not (all_digits 0) then None
  else
    let byte i =
      let at k = max 0 (value text.[(i / 3 * 4) + k]) in
      let word = (at 0 lsl 18) lor (at 1 lsl 12) lor (at 2 lsl 6) lor at 3 in
      Char.chr ((word lsr (16 - (8 * (i mod 3)))) land 0xff)
    in
    Some (String.init ((length / 4 * 3) - padding) byte)
