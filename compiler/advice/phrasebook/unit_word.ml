let singular word =
  let n = String.length word in
  if n > 3 && word.[n - 1] = 's' then String.sub word 0 (n - 1) else word

let symbol word =
  match singular (String.lowercase_ascii word) with
  | "meter" | "metre" | "mtr" -> Some "m"
  | "centimeter" | "centimetre" -> Some "cm"
  | "millimeter" | "millimetre" -> Some "mm"
  | "kilometer" | "kilometre" -> Some "km"
  | "sec" | "second" -> Some "s"
  | "msec" | "millisecond" -> Some "ms"
  | "minute" -> Some "min"
  | "h" | "hr" -> Some "hour"
  | "kilogram" -> Some "kg"
  | "gram" -> Some "g"
  | "radian" -> Some "rad"
  | "degree" -> Some "deg"
  | "hertz" -> Some "Hz"
  | "volt" -> Some "V"
  | "ampere" | "amp" -> Some "A"
  | "newton" -> Some "N"
  | "watt" -> Some "W"
  | "kelvin" -> Some "K"
  | "mps" -> Some "m/s"
  | "kmh" | "kph" | "kmph" -> Some "km/hour"
  | "dps" -> Some "deg/s"
  | "pixel" -> Some "px"
  | "bpm" -> Some "1/min"
  | "rps" -> Some "rad/s"
  | _ -> None
