open Core.Ir

type settings = (Global.t * Value.t) list

let prefix = "# param "
let is_line text = String.starts_with ~prefix:"#" text

let described (p : param) =
  match p.ty with
  | Bool -> "true or false"
  | Int -> "a whole number in " ^ p.unit_
  | _ -> "a number in " ^ p.unit_

(* Splits a text such as [4[1/m]] into the number and the unit, which may be missing. *)
let apart text =
  match String.index_opt text '[' with
  | None -> Some (text, None)
  | Some i when text.[String.length text - 1] = ']' ->
      Some (String.sub text 0 i, Some (String.sub text (i + 1) (String.length text - i - 2)))
  | Some _ -> None

let value core (p : param) text =
  let wrong () =
    Error (Printf.sprintf "the parameter `%s` is %s, not `%s`" p.label (described p) text)
  in
  match apart text with
  | None -> wrong ()
  | Some (_, Some unit_) when not (String.equal unit_ p.unit_) ->
      Error
        (Printf.sprintf "the parameter `%s` is %s, but `%s` has a different unit" p.label
           (described p) text)
  | Some (number, _) -> (
      match Cell.read (Shape.of_type core p.ty) number with
      | Ok (Float x) when Float.is_nan x -> wrong ()
      | Ok value -> Ok [ (p.param, value) ]
      | Error _ -> wrong ())

(* Formats the number with the fewest digits that read back as the same value. *)
let float real x =
  let first, last = match (real : Basis.Real.t) with Double -> (15, 17) | Single -> (6, 9) in
  let rec go digits =
    let text = Printf.sprintf "%.*g" digits x in
    if digits = last || Basis.Real.round real (float_of_string text) = x then text
    else go (digits + 1)
  in
  go first

let written core (p : param) (value : Value.t) =
  let number =
    match value with
    | Float x -> float core.real x
    | value -> Cell.write (Shape.of_type core p.ty) value
  in
  if List.mem p.unit_ [ ""; "1" ] then number else Printf.sprintf "%s[%s]" number p.unit_

let unknown core name =
  let all = List.map (fun (p : param) -> Printf.sprintf "`%s`" p.label) core.params in
  Printf.sprintf "the program has no parameter `%s`; the program has %s" name
    (if all = [] then "none" else String.concat ", " all)

let setting core ~set text =
  match String.index_opt text '=' with
  | None -> (Error (Printf.sprintf "write a parameter as NAME=VALUE, not `%s`" text), None)
  | Some i -> (
      let name = String.sub text 0 i in
      let text = String.sub text (i + 1) (String.length text - i - 1) in
      match List.find_opt (fun (p : param) -> String.equal p.label name) core.params with
      | None -> (Ok [], Some (unknown core name))
      | Some p -> (
          match List.assoc_opt p.param set with
          | None -> (value core p text, None)
          | Some value when String.equal (written core p value) text -> (Ok [], None)
          | Some value ->
              ( Ok [],
                Some
                  (Printf.sprintf
                     "the parameter `%s` is %s, as set by the option, but it was %s in the \
                      recording"
                     name (written core p value) text) )))

let line core (p : param) value = Printf.sprintf "%s%s=%s" prefix p.label (written core p value)

let read core ~set line =
  if String.starts_with ~prefix line then
    let n = String.length prefix in
    setting core ~set (String.sub line n (String.length line - n))
  else (Ok [], None)
