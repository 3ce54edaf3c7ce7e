type t =
  | Null
  | Bool of bool
  | Int of int
  | Float of float
  | String of string
  | List of t list
  | Object of (string * t) list

(* {1 Strings} *)

let replacement = "\u{fffd}"

let valid text =
  if Option.is_none (Utf8.first_error text) then text
  else
    let result = Buffer.create (String.length text) in
    let rec go i =
      if i < String.length text then
        match Utf8.decode text i with
        | 0, _ ->
            Buffer.add_string result replacement;
            go (i + 1)
        | length, _ ->
            Buffer.add_string result (String.sub text i length);
            go (i + length)
    in
    go 0;
    Buffer.contents result

(* {1 Writing} *)

(* Whole numbers are written without a fraction. JSON cannot represent NaN or infinity. *)
let of_float x : Yojson.Safe.t =
  if not (Float.is_finite x) then `Null
  else if Float.is_integer x && abs_float x < 1e15 && not (Int64.bits_of_float x = Int64.min_int)
  then `Int (int_of_float x)
  else `Float x

let rec to_yojson : t -> Yojson.Safe.t = function
  | Null -> `Null
  | Bool b -> `Bool b
  | Int n -> `Int n
  | Float x -> of_float x
  | String s -> `String (valid s)
  | List list -> `List (Long_list.map to_yojson list)
  | Object members -> `Assoc (List.map (fun (name, x) -> (valid name, to_yojson x)) members)

let to_string t = Yojson.Safe.to_string ~std:true (to_yojson t)

(* {1 Reading} *)

exception Malformed

let deepest = 500

(* Are brackets nested too deeply for Yojson, which processes them recursively? *)
let is_too_deep text =
  let rec go i depth =
    if i >= String.length text then false
    else
      match text.[i] with
      | '[' | '{' -> depth >= deepest || go (i + 1) (depth + 1)
      | ']' | '}' -> go (i + 1) (depth - 1)
      | '"' -> in_string (i + 1) depth
      | _ -> go (i + 1) depth
  and in_string i depth =
    if i >= String.length text then false
    else
      match text.[i] with
      | '"' -> go (i + 1) depth
      | '\\' -> in_string (i + 2) depth
      | _ -> in_string (i + 1) depth
  in
  go 0 0

let finite x = if Float.is_finite x then Float x else raise Malformed

(* Yojson also accepts some values that are not JSON. *)
let rec of_yojson : Yojson.Safe.t -> t = function
  | `Null -> Null
  | `Bool b -> Bool b
  | `Int n -> Int n
  | `Intlit digits -> finite (float_of_string digits)
  | `Float x -> finite x
  | `String s -> String (valid s)
  | `List list -> List (Long_list.map of_yojson list)
  | `Assoc members -> Object (List.map (fun (name, x) -> (valid name, of_yojson x)) members)
  | `Tuple _ | `Variant _ -> raise Malformed

let of_string text =
  if is_too_deep text then None
  else
    match of_yojson (Yojson.Safe.from_string text) with
    | json -> Some json
    | exception (Yojson.Json_error _ | Malformed) -> None

(* {1 Access} *)

let member name = function
  | Object members -> Option.value (List.assoc_opt name members) ~default:Null
  | _ -> Null

let at names json = List.fold_left (fun json name -> member name json) json names
let string = function String s -> Some s | _ -> None
let int = function Int n -> Some n | _ -> None
let list = function List l -> l | _ -> []
