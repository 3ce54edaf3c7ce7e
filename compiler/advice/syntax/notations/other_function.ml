open Basis

(* {1 Modules} *)

let modules = [ "math"; "Math"; "np"; "numpy"; "std"; "cmath"; "jnp"; "numpy.linalg"; "np.linalg" ]

let without_module word =
  let after prefix sign =
    let prefix = prefix ^ sign in
    let n = String.length prefix in
    if String.starts_with ~prefix word && String.length word > n then
      Some (String.sub word n (String.length word - n))
    else None
  in
  List.find_map
    (fun module_ -> List.find_map (after module_) [ "."; "::" ])
    (List.sort (fun a b -> Int.compare (String.length b) (String.length a)) modules)

let constant = function
  | "pi" | "PI" | "Pi" | "numbers::pi" -> Some "pi"
  | "tau" -> Some "2 * pi"
  | "e" | "E" -> Some "exp 1"
  | "inf" | "INFINITY" | "Infinity" -> Some "1 / 0"
  | "nan" | "NaN" -> Some "0 / 0"
  | _ -> None

(* {1 Functions} *)

let alone = function
  | ( "abs" | "sqrt" | "exp" | "log" | "sin" | "cos" | "tan" | "asin" | "acos" | "atan" | "atan2"
    | "hypot" | "min" | "max" | "round" | "floor" ) as name ->
      Some name
  | "fabs" | "fabsf" | "absolute" -> Some "abs"
  | "fmin" | "fminf" | "minimum" -> Some "min"
  | "fmax" | "fmaxf" | "maximum" -> Some "max"
  | "arcsin" -> Some "asin"
  | "arccos" -> Some "acos"
  | "arctan" -> Some "atan"
  | "arctan2" | "atan2f" -> Some "atan2"
  | "sqrtf" -> Some "sqrt"
  | "sinf" -> Some "sin"
  | "cosf" -> Some "cos"
  | "tanf" -> Some "tan"
  | "ceil" -> Some "ceiling"
  | "trunc" | "fix" -> Some "truncate"
  | "rint" | "lround" | "nearbyint" -> Some "round"
  | "sign" -> Some "signum"
  | _ -> None

(* {1 Arrays} *)

let most_elements = 12
let whole text = if String.for_all Character.is_digit text then int_of_string_opt text else None
let array elements = Printf.sprintf "[%s]" (String.concat ", " elements)

let filled_by element n =
  if n > 0 && n <= most_elements then array (List.init n (fun _ -> element))
  else Printf.sprintf "generate (const %s)" element

(* Returns the numbers in `4`, `1, 4`, `(2, 3)` or `[2, 3]`. *)
let dimensions arguments =
  let bare = function '(' | ')' | '[' | ']' | ',' -> ' ' | c -> c in
  let words = String.split_on_char ' ' (String.map bare (String.concat " " arguments)) in
  let all = List.map whole (List.filter (( <> ) "") words) in
  if List.mem None all then None else Some (List.filter_map Fun.id all)

let filled element arguments =
  match dimensions arguments with
  | Some [ n ] | Some [ 1; n ] -> Some (filled_by element n)
  | Some [ rows; columns ] when rows > 0 && rows <= most_elements ->
      Some (filled_by (filled_by element columns) rows)
  | Some _ | None -> None

let identity n =
  let row i = array (List.init n (fun j -> if i = j then "1" else "0")) in
  if n > 0 && n <= 4 then Some (array (List.init n row)) else None

let numbers first last =
  if last >= first && last - first < most_elements then
    Some (array (List.init (last - first + 1) (fun i -> string_of_int (first + i))))
  else None

let range arguments =
  match List.map whole arguments with
  | [ Some n ] -> Some (0, n - 1)
  | [ Some first; Some stop ] -> Some (first, stop - 1)
  | _ -> None

(* Functions that return arrays of a given size. *)
let new_array name arguments =
  match (name, arguments) with
  | "zeros", _ -> filled "0" arguments
  | "ones", _ -> filled "1" arguments
  | "replicate", [ n; element ] -> Option.map (filled_by (Source.grouped element)) (whole n)
  | ("eye" | "identity"), [ n ] -> Option.bind (whole n) identity
  | ("range" | "arange"), _ ->
      Option.bind (range arguments) (fun (first, last) -> numbers first last)
  | _ -> None

let number_of_arguments = function "atan2" | "hypot" | "min" | "max" -> 2 | _ -> 1

let of_numbers name arguments =
  let text format = Printf.sprintf format in
  match (name, List.map Source.grouped arguments) with
  | ("max" | "amax"), [ xs ] -> Some (text "maximumBy id %s" xs)
  | ("min" | "amin"), [ xs ] -> Some (text "minimumBy id %s" xs)
  | ("clip" | "clamp"), [ x; low; high ] -> Some (text "clamp %s %s %s" low high x)
  | ("pow" | "power" | "float_power"), [ x; y ] ->
      Some (if String.for_all Character.is_digit y then text "%s ^ %s" x y else text "%s ** %s" x y)
  | "square", [ x ] -> Some (text "%s ^ 2" x)
  | "cbrt", [ x ] -> Some (text "%s ** (1 / 3)" x)
  | "exp2", [ x ] -> Some (text "2 ** %s" x)
  | "log10", [ x ] -> Some (text "log %s / log 10" x)
  | "log2", [ x ] -> Some (text "log %s / log 2" x)
  | "log", [ x; base ] -> Some (text "log %s / log %s" x base)
  | ("degrees" | "rad2deg"), [ x ] -> Some (text "%s / 1[deg]" x)
  | ("radians" | "deg2rad"), [ x ] ->
      Some (if float_of_string_opt x = None then text "%s * 1[deg]" x else x ^ "[deg]")
  | "isnan", [ x ] -> Some (text "%s /= %s" x x)
  | "isfinite", [ x ] -> Some (text "%s - %s == 0" x x)
  | ("sum" | "mean"), [ xs ] -> Some (text "%s %s" name xs)
  | "average", [ xs ] -> Some (text "mean %s" xs)
  | "prod", [ xs ] -> Some (text "foldl (*) 1 %s" xs)
  | "dot", [ xs; ys ] -> Some (text "sum (zipWith (*) %s %s)" xs ys)
  | "norm", [ xs ] -> Some (text "sqrt (sum (map (\\x -> x ^ 2) %s))" xs)
  | "array", [ xs ] when String.starts_with ~prefix:"[" xs -> Some xs
  | "ceil", [ x ] -> Some (text "ceiling %s" x)
  | _, given -> (
      match alone name with
      | Some own when List.length given = number_of_arguments own ->
          Some (String.concat " " (own :: given))
      | Some _ | None -> None)

let applied name arguments =
  match new_array name arguments with Some text -> Some text | None -> of_numbers name arguments

let import = function "clip" | "clamp" -> Some "Control" | _ -> None
