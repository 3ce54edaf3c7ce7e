open Basis

exception Malformed

type reader = { text : string; mutable at : int }

let deepest = 500
let peek r = if r.at < String.length r.text then r.text.[r.at] else '\000'

let rec skip_blanks r =
  match peek r with
  | ' ' | '\t' | '\n' | '\r' ->
      r.at <- r.at + 1;
      skip_blanks r
  | _ -> ()

let expect r c = if peek r = c then r.at <- r.at + 1 else raise Malformed

let word r text value =
  let n = String.length text in
  if r.at + n <= String.length r.text && String.equal (String.sub r.text r.at n) text then (
    r.at <- r.at + n;
    value)
  else raise Malformed

(* {1 Strings} *)

let replacement = Uchar.of_int 0xfffd

let hexadecimal r =
  if r.at + 4 > String.length r.text then raise Malformed;
  let digits = String.sub r.text r.at 4 in
  let is_digit = function '0' .. '9' | 'a' .. 'f' | 'A' .. 'F' -> true | _ -> false in
  if not (String.for_all is_digit digits) then raise Malformed;
  r.at <- r.at + 4;
  int_of_string ("0x" ^ digits)

(* Reads the digits after [\u]. A surrogate pair becomes one character. *)
let unicode r =
  let first = hexadecimal r in
  let is_low code = 0xdc00 <= code && code <= 0xdfff in
  if first < 0xd800 || first > 0xdfff then Uchar.of_int first
  else if is_low first || peek r <> '\\' then replacement
  else
    let back = r.at in
    r.at <- r.at + 1;
    let low =
      if peek r = 'u' then (
        r.at <- r.at + 1;
        hexadecimal r)
      else 0
    in
    if is_low low then Uchar.of_int (0x10000 + ((first - 0xd800) lsl 10) + (low - 0xdc00))
    else (
      r.at <- back;
      replacement)

let string_body r =
  expect r '"';
  let text = Buffer.create 64 in
  let escaped c =
    r.at <- r.at + 1;
    Buffer.add_char text c
  in
  let rec go () =
    if r.at >= String.length r.text then raise Malformed;
    match r.text.[r.at] with
    | '"' -> r.at <- r.at + 1
    | '\\' ->
        r.at <- r.at + 1;
        (match peek r with
        | ('"' | '\\' | '/') as c -> escaped c
        | 'b' -> escaped '\b'
        | 'f' -> escaped '\012'
        | 'n' -> escaped '\n'
        | 'r' -> escaped '\r'
        | 't' -> escaped '\t'
        | 'u' ->
            r.at <- r.at + 1;
            Buffer.add_utf_8_uchar text (unicode r)
        | _ -> raise Malformed);
        go ()
    | c when c < '\128' ->
        r.at <- r.at + 1;
        Buffer.add_char text c;
        go ()
    | _ ->
        (match Utf8.decode r.text r.at with
        | 0, _ ->
            r.at <- r.at + 1;
            Buffer.add_utf_8_uchar text replacement
        | length, _ ->
            Buffer.add_string text (String.sub r.text r.at length);
            r.at <- r.at + length);
        go ()
  in
  go ();
  Buffer.contents text

(* {1 Values} *)

let number r : Json.t =
  let start = r.at in
  let is_part = function '0' .. '9' | '-' | '+' | '.' | 'e' | 'E' -> true | _ -> false in
  while is_part (peek r) do
    r.at <- r.at + 1
  done;
  let text = String.sub r.text start (r.at - start) in
  match (int_of_string_opt text, float_of_string_opt text) with
  | Some n, _ -> Int n
  | None, Some x when Float.is_finite x -> Float x
  | None, _ -> raise Malformed

let rec value depth r : Json.t =
  if depth > deepest then raise Malformed;
  skip_blanks r;
  match peek r with
  | '{' ->
      r.at <- r.at + 1;
      Object
        (sequence r '}' (fun () ->
             skip_blanks r;
             let name = string_body r in
             skip_blanks r;
             expect r ':';
             (name, value (depth + 1) r)))
  | '[' ->
      r.at <- r.at + 1;
      List (sequence r ']' (fun () -> value (depth + 1) r))
  | '"' -> String (string_body r)
  | 't' -> word r "true" (Json.Bool true)
  | 'f' -> word r "false" (Json.Bool false)
  | 'n' -> word r "null" Json.Null
  | _ -> number r

(* Reads elements after the opening bracket, up to the closing one. *)
and sequence : 'a. reader -> char -> (unit -> 'a) -> 'a list =
 fun r close element ->
  skip_blanks r;
  if peek r = close then (
    r.at <- r.at + 1;
    [])
  else
    let rec go elements =
      let elements = element () :: elements in
      skip_blanks r;
      if peek r = ',' then (
        r.at <- r.at + 1;
        go elements)
      else (
        expect r close;
        List.rev elements)
    in
    go []

let of_string text =
  let r = { text; at = 0 } in
  match
    let result = value 0 r in
    skip_blanks r;
    (result, r.at = String.length text)
  with
  | result, true -> Some result
  | _, false | (exception Malformed) -> None

(* {1 Access} *)

let member name : Json.t -> Json.t = function
  | Object members -> Option.value (List.assoc_opt name members) ~default:Json.Null
  | _ -> Null

let at names json = List.fold_left (fun json name -> member name json) json names
let string : Json.t -> string option = function String s -> Some s | _ -> None
let int : Json.t -> int option = function Int n -> Some n | _ -> None
let list : Json.t -> Json.t list = function List l -> l | _ -> []
