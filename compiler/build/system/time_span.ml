let units = [ ("ms", 0.001); ("min", 60.); ("s", 1.); ("hour", 3600.); ("h", 3600.) ]

let read ~least text =
  let is_decimal = String.for_all (function '0' .. '9' | '.' -> true | _ -> false) in
  let wrong =
    Error
      (if text <> "" && is_decimal text then
         Printf.sprintf "`%s` is not a duration: add a unit, for example `%ss`" text text
       else
         Printf.sprintf "`%s` is not a duration: write a number and a unit, for example `10s`" text)
  in
  let suffix (unit_, _) =
    String.length text > String.length unit_ && Filename.check_suffix text unit_
  in
  match List.find_opt suffix units with
  | None -> wrong
  | Some (unit_, seconds) -> (
      let digits = String.sub text 0 (String.length text - String.length unit_) in
      match float_of_string_opt digits with
      | Some value when is_decimal digits && least value && value *. seconds < 1e9 ->
          Ok (value *. seconds)
      | _ -> wrong)

let parse = read ~least:(fun value -> value > 0.)
let parse_instant = read ~least:(fun value -> value >= 0.)

let print seconds =
  let digits = Printf.sprintf "%.9f" seconds in
  let rec significant n = if digits.[n - 1] = '0' then significant (n - 1) else n in
  let n = significant (String.length digits) in
  String.sub digits 0 (if digits.[n - 1] = '.' then n - 1 else n) ^ "s"
