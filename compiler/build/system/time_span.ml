let units = [ ("ms", 0.001); ("min", 60.); ("s", 1.); ("hour", 3600.); ("h", 3600.) ]

let read ~least text =
  let wrong =
    Error (Printf.sprintf "`%s` is not a duration; write it like 60s, 500ms, 2min or 1h" text)
  in
  let suffix (unit_, _) =
    String.length text > String.length unit_ && Filename.check_suffix text unit_
  in
  match List.find_opt suffix units with
  | None -> wrong
  | Some (unit_, seconds) -> (
      let digits = String.sub text 0 (String.length text - String.length unit_) in
      let is_decimal = String.for_all (function '0' .. '9' | '.' -> true | _ -> false) digits in
      match float_of_string_opt digits with
      | Some value when is_decimal && least value && value *. seconds < 1e9 -> Ok (value *. seconds)
      | _ -> wrong)

let parse = read ~least:(fun value -> value > 0.)
let parse_instant = read ~least:(fun value -> value >= 0.)

let print seconds =
  let digits = Printf.sprintf "%.9f" seconds in
  let rec significant n = if digits.[n - 1] = '0' then significant (n - 1) else n in
  let n = significant (String.length digits) in
  String.sub digits 0 (if digits.[n - 1] = '.' then n - 1 else n) ^ "s"
