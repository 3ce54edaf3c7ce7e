(* Natural numbers in base 10^4, least significant digit first, without leading zeros. The code is
   slow but short, which suffices for a few literals. *)
module Natural = struct
  let base = 10_000

  let normalize digits =
    let n = ref (Array.length digits) in
    while !n > 0 && digits.(!n - 1) = 0 do
      decr n
    done;
    if !n = Array.length digits then digits else Array.sub digits 0 !n

  let zero : int array = [||]
  let one = [| 1 |]
  let is_zero a = Array.length a = 0
  let is_one a = Array.length a = 1 && a.(0) = 1

  let of_int n =
    let rec go n = if n = 0 then [] else (n mod base) :: go (n / base) in
    if n = 1 then one else if n > 0 && n < base then [| n |] else Array.of_list (go n)

  let compare (a : int array) (b : int array) =
    let la = Array.length a and lb = Array.length b in
    if la <> lb then Int.compare la lb
    else
      let rec go i =
        if i < 0 then 0 else if a.(i) <> b.(i) then Int.compare a.(i) b.(i) else go (i - 1)
      in
      go (la - 1)

  let add a b =
    let n = 1 + max (Array.length a) (Array.length b) in
    let digit x i = if i < Array.length x then x.(i) else 0 in
    let carry = ref 0 in
    normalize
      (Array.init n (fun i ->
           let sum = digit a i + digit b i + !carry in
           carry := sum / base;
           sum mod base))

  (* requires a >= b *)
  let subtract a b =
    let borrow = ref 0 in
    normalize
      (Array.mapi
         (fun i d ->
           let d = d - !borrow - if i < Array.length b then b.(i) else 0 in
           if d < 0 then (
             borrow := 1;
             d + base)
           else (
             borrow := 0;
             d))
         a)

  let multiply a b =
    if is_zero a || is_zero b then zero
    else
      let product = Array.make (Array.length a + Array.length b) 0 in
      Array.iteri
        (fun i x ->
          let carry = ref 0 in
          Array.iteri
            (fun j y ->
              let sum = product.(i + j) + (x * y) + !carry in
              product.(i + j) <- sum mod base;
              carry := sum / base)
            b;
          let k = ref (i + Array.length b) in
          while !carry > 0 do
            let sum = product.(!k) + !carry in
            product.(!k) <- sum mod base;
            carry := sum / base;
            incr k
          done)
        a;
      normalize product

  let rec power a n =
    if n = 0 then of_int 1
    else
      let half = power a (n / 2) in
      let square = multiply half half in
      if n mod 2 = 1 then multiply square a else square

  (* The three digits from [length - 1] downwards, as an exact float. *)
  let leading a length =
    let digit i = if i >= 0 && i < Array.length a then float_of_int a.(i) else 0. in
    let base = float_of_int base in
    (((digit (length - 1) *. base) +. digit (length - 2)) *. base) +. digit (length - 3)

  (* Schoolbook division: each digit of the quotient is estimated from the leading digits and then
     corrected in at most two steps. *)
  let divide a b =
    if compare a b < 0 then (zero, a)
    else if Array.length b = 1 then (
      let rest = ref 0 and quotient = Array.make (Array.length a) 0 in
      for i = Array.length a - 1 downto 0 do
        let part = (!rest * base) + a.(i) in
        quotient.(i) <- part / b.(0);
        rest := part mod b.(0)
      done;
      (normalize quotient, of_int !rest))
    else
      let length = Array.length b in
      let positions = Array.length a - length + 1 in
      let quotient = Array.make positions 0 in
      let rest = ref (normalize (Array.sub a positions (length - 1))) in
      for i = positions - 1 downto 0 do
        rest := normalize (Array.append [| a.(i) |] !rest);
        if compare !rest b >= 0 then (
          (* read both numbers from the same position down, so that the ratio is meaningful *)
          let top = Array.length !rest in
          let estimate = leading !rest top /. leading b top in
          let digit = ref (max 1 (min (base - 1) (int_of_float estimate))) in
          let product = ref (multiply b (of_int !digit)) in
          while compare !product !rest > 0 do
            decr digit;
            product := subtract !product b
          done;
          let left = ref (subtract !rest !product) in
          while compare !left b >= 0 do
            incr digit;
            left := subtract !left b
          done;
          quotient.(i) <- !digit;
          rest := !left)
      done;
      (normalize quotient, !rest)

  let to_int_opt a =
    let n = Array.length a in
    if n > 5 || (n = 5 && a.(4) >= 400) then None
    else Some (Array.fold_right (fun d n -> (n * base) + d) a 0)

  let rec gcd_of_ints m n = if n = 0 then m else gcd_of_ints n (m mod n)

  let rec gcd a b =
    match (to_int_opt a, to_int_opt b) with
    | Some m, Some n -> of_int (gcd_of_ints m n)
    | _, _ -> if is_zero b then a else gcd b (snd (divide a b))

  let quotient a b =
    match (to_int_opt a, to_int_opt b) with
    | Some m, Some n -> of_int (m / n)
    | _, _ -> fst (divide a b)

  let of_digits text =
    let n = String.length text in
    let groups = (n + 3) / 4 in
    normalize
      (Array.init groups (fun i ->
           let stop = n - (4 * i) in
           let start = max 0 (stop - 4) in
           int_of_string ("0u" ^ String.sub text start (stop - start))))

  let to_string a =
    match Array.length a with
    | 0 -> "0"
    | n ->
        String.concat ""
          (string_of_int a.(n - 1)
          :: List.init (n - 1) (fun i -> Printf.sprintf "%04d" a.(n - 2 - i)))
end

(* sign * numerator / denominator in lowest terms; denominator > 0 *)
type t = { negative : bool; numerator : int array; denominator : int array }

let reduce negative numerator denominator =
  if Natural.is_zero numerator then { negative = false; numerator; denominator = Natural.one }
  else
    let g = Natural.gcd numerator denominator in
    {
      negative;
      numerator = Natural.quotient numerator g;
      denominator = Natural.quotient denominator g;
    }

let of_int n = { negative = n < 0; numerator = Natural.of_int (abs n); denominator = Natural.one }
let zero = of_int 0
let one = of_int 1
let ten_to n = Natural.power (Natural.of_int 10) n
let limit_of_exponent = 400
let is_digits text = String.for_all (function '0' .. '9' -> true | _ -> false) text

(* Fast path: almost all literals have only a few digits, with or without a decimal point, and fit
   in an [int]. *)
let longest_short = 15

let short_decimal text =
  let rec read i ~digits ~scale ~point =
    if i = String.length text then
      let g = Natural.gcd_of_ints digits scale in
      let numerator = Natural.of_int (digits / g) in
      Some { negative = false; numerator; denominator = Natural.of_int (scale / g) }
    else
      match text.[i] with
      | '0' .. '9' as c ->
          let digits = (10 * digits) + Char.code c - Char.code '0' in
          read (i + 1) ~digits ~scale:(if point then 10 * scale else scale) ~point
      | '.' when i > 0 && not point -> read (i + 1) ~digits ~scale ~point:true
      | _ -> None
  in
  if text = "" || String.length text > longest_short then None
  else read 0 ~digits:0 ~scale:1 ~point:false

let any_decimal text =
  let mantissa, exponent =
    match String.index_opt (String.lowercase_ascii text) 'e' with
    | None -> (text, Some 0)
    | Some i ->
        let rest = String.sub text (i + 1) (String.length text - i - 1) in
        let unsigned =
          if rest <> "" && (rest.[0] = '+' || rest.[0] = '-') then
            String.sub rest 1 (String.length rest - 1)
          else rest
        in
        let sign = if rest <> "" && rest.[0] = '-' then -1 else 1 in
        ( String.sub text 0 i,
          if unsigned <> "" && is_digits unsigned && String.length unsigned < 6 then
            Some (sign * int_of_string ("0u" ^ unsigned))
          else None )
  in
  let whole, fraction =
    match String.index_opt mantissa '.' with
    | None -> (mantissa, "")
    | Some i ->
        (String.sub mantissa 0 i, String.sub mantissa (i + 1) (String.length mantissa - i - 1))
  in
  match exponent with
  | Some exponent
    when whole <> "" && is_digits whole && is_digits fraction && abs exponent <= limit_of_exponent
    ->
      let digits = Natural.of_digits (whole ^ fraction) in
      let scale = exponent - String.length fraction in
      Some
        (if scale >= 0 then reduce false (Natural.multiply digits (ten_to scale)) Natural.one
         else reduce false digits (ten_to (-scale)))
  | _ -> None

(* The value of a digit in any base up to 16. *)
let value_of_digit c = int_of_string_opt (Printf.sprintf "0x%c" c)

let in_base base digits =
  let digit sum c =
    match (sum, value_of_digit c) with
    | Some sum, Some value when value < base ->
        Some (Natural.add (Natural.multiply sum (Natural.of_int base)) (Natural.of_int value))
    | _, _ -> None
  in
  if digits = "" then None
  else
    String.fold_left digit (Some Natural.zero) digits
    |> Option.map (fun n -> reduce false n Natural.one)

let base_of_prefix = function
  | '0', ('x' | 'X') -> Some 16
  | '0', ('o' | 'O') -> Some 8
  | '0', ('b' | 'B') -> Some 2
  | _ -> None

let of_literal text =
  let text = String.concat "" (String.split_on_char '_' text) in
  let length = String.length text in
  match if length < 3 then None else base_of_prefix (text.[0], text.[1]) with
  | Some base -> in_base base (String.sub text 2 (length - 2))
  | None -> ( match short_decimal text with Some _ as value -> value | None -> any_decimal text)

(* OEIS A000796, the first hundred decimals. The fraction is in lowest terms because the last digit
   is neither even nor 5. *)
let pi =
  {
    negative = false;
    numerator =
      Natural.of_digits
        "31415926535897932384626433832795028841971693993751058209749445923078164062862089986280348253421170679";
    denominator = Natural.power (Natural.of_int 10) 100;
  }

let negate t = if Natural.is_zero t.numerator then t else { t with negative = not t.negative }

(* Cancels common factors before multiplying. They occur only between the numerator of one number
   and the denominator of the other, and one of these is usually small. The result is in lowest
   terms. *)
let multiply a b =
  if Natural.is_zero a.numerator || Natural.is_zero b.numerator then zero
  else
    let cancel n d =
      let g = Natural.gcd n d in
      if Natural.is_one g then (n, d) else (fst (Natural.divide n g), fst (Natural.divide d g))
    in
    let n, d' = cancel a.numerator b.denominator in
    let n', d = cancel b.numerator a.denominator in
    {
      negative = a.negative <> b.negative;
      numerator = Natural.multiply n n';
      denominator = Natural.multiply d d';
    }

let divide a b =
  if Natural.is_zero b.numerator then invalid_arg "Exact.divide";
  multiply a { negative = b.negative; numerator = b.denominator; denominator = b.numerator }

let add a b =
  let left = Natural.multiply a.numerator b.denominator in
  let right = Natural.multiply b.numerator a.denominator in
  let denominator = Natural.multiply a.denominator b.denominator in
  if a.negative = b.negative then reduce a.negative (Natural.add left right) denominator
  else if Natural.compare left right >= 0 then
    reduce a.negative (Natural.subtract left right) denominator
  else reduce b.negative (Natural.subtract right left) denominator

let rec power t n =
  if n < 0 then divide one (power t (-n))
  else
    {
      negative = t.negative && n mod 2 = 1;
      numerator = Natural.power t.numerator n;
      denominator = Natural.power t.denominator n;
    }

let compare a b =
  match (a.negative, b.negative) with
  | true, false -> -1
  | false, true -> 1
  | negative, _ ->
      let left = Natural.multiply a.numerator b.denominator in
      let right = Natural.multiply b.numerator a.denominator in
      if negative then Natural.compare right left else Natural.compare left right

(* lowest terms are unique *)
let equal a b =
  a.negative = b.negative
  && Natural.compare a.numerator b.numerator = 0
  && Natural.compare a.denominator b.denominator = 0

let is_integer t = Natural.is_one t.denominator

let to_int32 t =
  if not (is_integer t) then None
  else
    match Natural.to_int_opt t.numerator with
    | Some n ->
        let n = if t.negative then -n else n in
        if n >= -0x8000_0000 && n <= 0x7fff_ffff then Some (Int32.of_int n) else None
    | None -> None

(* A binary floating-point format: the number of significand bits, and the exponents of the smallest
   positive number and of the largest power of two. *)
type format = { bits : int; smallest : int; largest : int }

let binary64 = { bits = 53; smallest = -1074; largest = 1023 }
let binary32 = { bits = 24; smallest = -149; largest = 127 }

(* Scales by a power of two until the quotient has one bit more than the format, and records whether
   there is a remainder (the sticky bit). Then rounds this integer quotient once, to fewer bits if
   the result is below the normal range. *)
let rounded_by_bits format t =
  if Natural.is_zero t.numerator then 0.
  else
    let two_to n = Natural.power (Natural.of_int 2) n in
    let quotient shift =
      if shift >= 0 then Natural.divide (Natural.multiply t.numerator (two_to shift)) t.denominator
      else Natural.divide t.numerator (Natural.multiply t.denominator (two_to (-shift)))
    in
    (* computes floor(log2 (n/d)) by trial, starting from the lengths in base 10^4 *)
    let at_least e =
      (* is n/d >= 2^e? *)
      if e >= 0 then Natural.compare t.numerator (Natural.multiply t.denominator (two_to e)) >= 0
      else Natural.compare (Natural.multiply t.numerator (two_to (-e))) t.denominator >= 0
    in
    let guess =
      int_of_float (13.28771 *. float_of_int (Array.length t.numerator - Array.length t.denominator))
    in
    let e = ref (guess - 15) in
    while at_least (!e + 1) do
      incr e
    done;
    let exponent = !e in
    let lowest = max (exponent - format.bits + 1) format.smallest in
    let q, rest = quotient (1 - lowest) in
    (* q = floor (n/d * 2^(1-lowest)): one extra bit; the remainder is sticky *)
    let q = match Natural.to_int_opt q with Some q -> q | None -> assert false in
    let kept = q / 2 and half = q mod 2 = 1 and sticky = not (Natural.is_zero rest) in
    let rounded = if half && (sticky || kept mod 2 = 1) then kept + 1 else kept in
    let magnitude =
      if exponent > format.largest then infinity
      else
        let magnitude = ldexp (float_of_int rounded) lowest in
        if magnitude >= ldexp 2. format.largest then infinity else magnitude
    in
    if t.negative then -.magnitude else magnitude

let to_float t =
  let exact n = n <= 1 lsl 53 in
  match (Natural.to_int_opt t.numerator, Natural.to_int_opt t.denominator) with
  | Some n, Some d when exact n && exact d ->
      (* both are exact doubles, so the division rounds only once *)
      let magnitude = float_of_int n /. float_of_int d in
      if t.negative then -.magnitude else magnitude
  | _, _ -> rounded_by_bits binary64 t

let to_single t = rounded_by_bits binary32 t

let to_string t =
  let sign = if t.negative then "-" else "" in
  if is_integer t then sign ^ Natural.to_string t.numerator
  else
    (* if there is a finite decimal form, scale by the smallest sufficient power of ten *)
    let rec places n =
      if n > 40 then None
      else if Natural.is_zero (snd (Natural.divide (ten_to n) t.denominator)) then Some n
      else places (n + 1)
    in
    match places 1 with
    | None -> sign ^ Natural.to_string t.numerator ^ "/" ^ Natural.to_string t.denominator
    | Some n ->
        let digits =
          Natural.to_string
            (Natural.multiply t.numerator (fst (Natural.divide (ten_to n) t.denominator)))
        in
        let digits =
          if String.length digits <= n then String.make (n + 1 - String.length digits) '0' ^ digits
          else digits
        in
        let whole = String.length digits - n in
        sign ^ String.sub digits 0 whole ^ "." ^ String.sub digits whole n
