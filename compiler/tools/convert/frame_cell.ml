type t = { file : string; age : int }

let folder_of path =
  let stem = Packed.stem path in
  let stem = if Filename.check_suffix stem ".csv" then Filename.chop_suffix stem ".csv" else stem in
  stem ^ ".frames"

let hash_digits = 10

(* Together, the number and the hash in a file name have 64 bits. *)
let file number hash =
  let padded = String.make (max 0 (16 - String.length hash)) '0' ^ hash in
  Printf.sprintf "%06d-%s" (number land 0xffffff) (String.sub padded 0 hash_digits)

let of_words words =
  let open Basis.Let_syntax.Option in
  match words with
  | number :: size :: hash :: _ ->
      let* number = int_of_string_opt number in
      let* _ = int_of_string_opt size in
      let is_hex c = match c with '0' .. '9' | 'a' .. 'f' -> true | _ -> false in
      let n = String.length hash in
      if n > 2 && n <= 18 && String.starts_with ~prefix:"0x" hash then
        let digits = String.sub hash 2 (n - 2) in
        if String.for_all is_hex digits then Some (file number digits) else None
      else None
  | _ -> None

let age_of words =
  let rec find = function
    | "age" :: "=" :: value :: _ -> float_of_string_opt value
    | _ :: others -> find others
    | [] -> None
  in
  match find words with
  | Some age when age >= 0. && age < 1e9 -> int_of_float (Float.round (age *. 1e9))
  | Some _ | None -> 0

let all cell =
  let is_mark = function '{' | '}' | '(' | ')' | '[' | ']' | ',' | ' ' -> true | _ -> false in
  let words =
    String.map (fun c -> if is_mark c then ' ' else c) cell
    |> String.split_on_char ' '
    |> List.filter (fun word -> word <> "")
  in
  let rec find found = function
    | "Image" :: rest -> (
        match of_words rest with
        | Some file -> find ({ file; age = age_of rest } :: found) rest
        | None -> find found rest)
    | _ :: rest -> find found rest
    | [] -> List.rev found
  in
  find [] words

let is_name name =
  let n = String.length name in
  let is_hex c = String.contains "0123456789abcdef" c in
  match String.index_opt name '-' with
  | Some i when i >= 6 && n = i + 1 + hash_digits + 4 ->
      String.for_all Basis.Character.is_digit (String.sub name 0 i)
      && String.for_all is_hex (String.sub name (i + 1) hash_digits)
      && List.mem (Filename.extension name) [ ".ppm"; ".pgm" ]
  | Some _ | None -> false
