open Basis

type t = { scale : float; unit_ : string; plain : bool }

let quantity scale unit_ = Some { scale; unit_; plain = false }
let plain scale = Some { scale; unit_ = ""; plain = true }

let length_or_time = function
  | "ft" | "foot" | "feet" -> quantity 0.3048 "m"
  | "inch" | "inches" -> quantity 0.0254 "m"
  | "yd" | "yard" | "yards" -> quantity 0.9144 "m"
  | "mi" | "mile" | "miles" -> quantity 1609.344 "m"
  | "mph" -> quantity 0.44704 "m/s"
  | "kn" | "knot" | "knots" -> quantity 0.514444 "m/s"
  | "G" -> quantity 9.80665 "m/s^2"
  | "fps" -> quantity 0.3048 "m/s"
  | "day" | "days" -> quantity 86400. "s"
  | "rev" | "revs" | "revolution" | "revolutions" | "turn" | "turns" -> quantity 360. "deg"
  | _ -> None

let of_mechanics = function
  | "lb" | "lbs" | "pound" | "pounds" -> quantity 0.45359237 "kg"
  | "oz" -> quantity 0.028349523 "kg"
  | "ton" | "tonne" | "tons" | "tonnes" -> quantity 1000. "kg"
  | "kgf" -> quantity 9.80665 "N"
  | "lbf" -> quantity 4.448222 "N"
  | "Nm" -> quantity 1. "N m"
  | "Ncm" -> quantity 0.01 "N m"
  | "bar" -> quantity 100000. "Pa"
  | "mbar" -> quantity 100. "Pa"
  | "psi" -> quantity 6894.757 "Pa"
  | "atm" -> quantity 101325. "Pa"
  | "Wh" -> quantity 3600. "J"
  | "kWh" -> quantity 3600000. "J"
  | "L" | "l" | "liter" | "litre" | "liters" | "litres" -> quantity 0.001 "m^3"
  | "ml" | "mL" -> quantity 0.000001 "m^3"
  | _ -> None

let of_electricity = function
  | "mAh" -> quantity 3.6 "A s"
  | "Ah" -> quantity 3600. "A s"
  | "T" | "tesla" -> quantity 1. "kg/(A s^2)"
  | "mT" -> quantity 0.001 "kg/(A s^2)"
  | "uT" -> quantity 0.000001 "kg/(A s^2)"
  | "gauss" -> quantity 0.0001 "kg/(A s^2)"
  | "H" | "henry" -> quantity 1. "V s/A"
  | _ -> None

let of_counts = function
  | "percent" | "pct" -> plain 0.01
  | "dB" | "db" | "dBm" | "decibel" | "decibels" -> plain 1.
  | "tick" | "ticks" | "count" | "counts" | "step" | "steps" | "pulse" | "pulses" | "cycles"
  | "samples" | "times" ->
      plain 1.
  | _ -> None

let prefixes =
  [
    ('G', 1e9); ('M', 1e6); ('k', 1e3); ('h', 100.); ('d', 0.1); ('c', 0.01); ('m', 1e-3);
    ('u', 1e-6); ('n', 1e-9);
  ]
[@@ocamlformat "disable"]

let with_prefixes = [ "m"; "s"; "g"; "A"; "Hz"; "N"; "J"; "W"; "V"; "Ohm"; "Pa"; "rad"; "K" ]

let of_a_prefix ~is_unit name =
  if String.length name < 2 then None
  else
    let rest = String.sub name 1 (String.length name - 1) in
    match List.assoc_opt name.[0] prefixes with
    | Some scale when List.mem rest with_prefixes && is_unit rest -> quantity scale rest
    | Some _ | None -> None

let find ~is_unit name =
  List.find_map
    (fun known -> known name)
    [ length_or_time; of_mechanics; of_electricity; of_counts; of_a_prefix ~is_unit ]

(* The number written without an exponent, because declarations of units do not allow exponents. *)
let decimal x =
  let text = Printf.sprintf "%.9f" x in
  let rec last i = if text.[i] = '0' then last (i - 1) else if text.[i] = '.' then i - 1 else i in
  String.sub text 0 (last (String.length text - 1) + 1)

let is_celsius name =
  List.mem (String.lowercase_ascii name)
    [ "c"; "degc"; "deg_c"; "celsius"; "centigrade"; "degreec"; "degreesc" ]

let is_fahrenheit name =
  List.mem (String.lowercase_ascii name) [ "degf"; "deg_f"; "fahrenheit"; "degreef"; "degreesf" ]

(* The temperature in kelvin. *)
let kelvin name x =
  if is_celsius name then decimal (x +. 273.15)
  else Printf.sprintf "%.2f" (((x -. 32.) /. 1.8) +. 273.15)

let temperature name literal d =
  match literal with
  | Some (digits, x, whole) ->
      let text = Printf.sprintf "%s[K]" (kelvin name x) in
      let difference =
        if is_celsius name then Printf.sprintf "%s[K]" digits
        else Printf.sprintf "%s[K]" (decimal (Float.round (x /. 1.8 *. 100.) /. 100.))
      in
      Diagnostic.hint
        "use kelvin: write `%s` for this temperature, or `%s` for a temperature difference" text
        difference d
      |> Diagnostic.fix "convert the temperature to kelvin" [ (whole, text) ]
  | None ->
      Diagnostic.hint "%s"
        (if is_celsius name then
           "use kelvin, `K`, for a temperature: 0 degrees Celsius is `273.15[K]`"
         else "use kelvin, `K`, for a temperature: 32 degrees Fahrenheit is `273.15[K]`")
        d

let explain_known name (u : t) literal d =
  let scale = decimal u.scale in
  match literal with
  | _ when u.unit_ <> "" && u.scale = 1. -> Diagnostic.hint "write `%s`" u.unit_ d
  | Some (_, x, whole) ->
      let number = decimal (x *. u.scale) in
      let text = if u.plain then number else Printf.sprintf "%s[%s]" number u.unit_ in
      Diagnostic.hint "%s"
        (if u.plain then Printf.sprintf "write a plain number: `%s`" text
         else
           Printf.sprintf "write `%s`, or declare the unit on a line of its own: `unit %s = %s %s`"
             text name scale u.unit_)
        d
      |> Diagnostic.fix
           (if u.plain then "write a plain number"
            else Printf.sprintf "convert the number to `%s`" u.unit_)
           [ (whole, text) ]
  | None when u.plain -> Diagnostic.hint "use a plain number without a unit" d
  | None ->
      Diagnostic.hint
        "1 `%s` is `%s[%s]`: use `%s`, or declare the unit on a line of its own: `unit %s = %s %s`"
        name scale u.unit_ u.unit_ name scale u.unit_ d

(* Whether the name is a unit of a quantity for which Frob has no unit. *)
let is_of_another_quantity name =
  List.mem name [ "lux"; "lx"; "lumen"; "lumens"; "lm"; "candela"; "cd"; "mol"; "ppm"; "pH"; "dBA" ]

let explain ~is_unit ~text (span : Span.t) name =
  let literal =
    match Name_in_text.number_with_unit ~text span with
    | Some (digits, whole) -> Option.map (fun x -> (digits, x, whole)) (float_of_string_opt digits)
    | None -> None
  in
  if name = "per" then Some (Diagnostic.hint "write `/` for \"per\", as in `0.3[m/s]`")
  else if is_celsius name || is_fahrenheit name then
    Some
      (fun d ->
        let d = temperature name literal d in
        if name = "C" then Diagnostic.hint "for a coulomb, write `A s`" d else d)
  else if is_of_another_quantity name then
    Some (Diagnostic.hint "declare it on a line of its own, above the definitions: `unit %s`" name)
  else Option.map (fun u -> explain_known name u literal) (find ~is_unit name)
