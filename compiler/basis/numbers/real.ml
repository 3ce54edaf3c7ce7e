type t = Double | Single

let to_single x = Int32.float_of_bits (Int32.bits_of_float x)
let round = function Double -> Fun.id | Single -> to_single

(* A double does not represent every integer beyond 2^53. There, the lowest 11 bits of [n] can only
   decide whether a single is rounded up, so one sticky bit can represent them. *)
let single_of_int64 n =
  if Int64.compare (Int64.abs n) 0x20_0000_0000_0000L <= 0 && n <> Int64.min_int then
    to_single (Int64.to_float n)
  else
    let low = Int64.logand n 0x7ffL in
    let sticky = if Int64.equal low 0L then 0L else 1L in
    to_single (ldexp (Int64.to_float (Int64.logor (Int64.shift_right n 11) sticky)) 11)

let of_int64 = function Double -> Int64.to_float | Single -> single_of_int64
let of_exact = function Double -> Exact.to_float | Single -> Exact.to_single
let bytes = function Double -> 8 | Single -> 4
let all_whole_from = function Double -> 0x1p52 | Single -> 0x1p23

(* For a single, also checks the neighbouring doubles, because the reader may round the text to a
   double first. *)
let reads_back t x text =
  let read = float_of_string text in
  match t with
  | Double -> Float.equal read x
  | Single ->
      List.for_all (fun y -> Float.equal (to_single y) x) [ read; Float.pred read; Float.succ read ]

let shortest t x =
  let most = match t with Double -> 17 | Single -> 9 in
  let rec with_digits digits =
    let text = Printf.sprintf "%.*g" digits x in
    if digits >= most || reads_back t x text then text else with_digits (digits + 1)
  in
  with_digits 1
