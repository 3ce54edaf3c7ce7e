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

let number_of_arguments = function "atan2" | "hypot" | "min" | "max" -> 2 | _ -> 1

let applied name arguments =
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

let import = function "clip" | "clamp" -> Some "Control" | _ -> None
