let bug format = Basis.Diagnostic.bug ~stage:"Interp.Cell" format

(* {1 Writing} *)

(* Negative numbers and applications of constructors need parentheses if they are arguments. *)
type place = Alone | Argument

let float (real : Basis.Real.t) x =
  if Float.is_nan x then "nan"
  else if x = Float.infinity then "inf"
  else if x = Float.neg_infinity then "-inf"
  else match real with Double -> Printf.sprintf "%.17g" x | Single -> Basis.Real.shortest real x

let separated separator f = function
  | [] -> ()
  | first :: others ->
      f first;
      List.iter
        (fun x ->
          separator ();
          f x)
        others

let write shape value =
  let out = Buffer.create 32 in
  let put = Buffer.add_string out in
  let parenthesized yes f =
    if yes then put "(";
    f ();
    if yes then put ")"
  in
  let number place text = parenthesized (place = Argument && text.[0] = '-') (fun () -> put text) in
  let rec value_ place (shape : Shape.t) (value : Value.t) =
    match (shape, value) with
    | Bool, Bool b -> put (string_of_bool b)
    | Int, Int n -> number place (Int32.to_string n)
    | Float real, Float x -> number place (float real x)
    | Tuple shapes, Tuple values ->
        put "(";
        separated
          (fun () -> put ", ")
          (fun (shape, value) -> value_ Alone shape (Thunk.demand value))
          (List.combine shapes (Array.to_list values));
        put ")"
    | Array (_, element), Array values ->
        put "[";
        separated
          (fun () -> put ", ")
          (fun value -> value_ Alone element (Thunk.demand value))
          (Array.to_list values);
        put "]"
    | Data { constructors; _ }, Data { constructor; arguments } ->
        constructed place (List.nth constructors constructor) (Array.to_list arguments)
    | Text, Text text -> put (Basis.Text_literal.written text)
    | Image, Image image ->
        let number, size, hash = Kernels.name image in
        parenthesized (place = Argument) (fun () ->
            put (Printf.sprintf "Image %d %Lu 0x%016Lx" number size hash))
    | Console controls, Data { arguments; _ } ->
        let fields = List.map (fun (label, shape, _) -> (label, shape)) controls in
        record { Shape.name = "Console"; fields } (List.combine fields (Array.to_list arguments))
    | (Bool | Int | Float _ | Text | Drawing | Image | Tuple _ | Array _ | Data _ | Console _), _ ->
        bug "a value that does not match its shape"
  and record (c : Shape.constructor) fields =
    put (c.name ^ " {");
    separated
      (fun () -> put ", ")
      (fun ((name, shape), value) ->
        put (name ^ " = ");
        value_ Alone shape (Thunk.demand value))
      fields;
    put "}"
  and constructed place (c : Shape.constructor) arguments =
    let is_seen ((_, shape), _) = shape <> Shape.Console [] && shape <> Shape.Drawing in
    let fields = List.filter is_seen (List.combine c.fields arguments) in
    if Shape.is_record c then record c fields
    else
      parenthesized
        (place = Argument && fields <> [])
        (fun () ->
          put c.name;
          List.iter
            (fun ((_, shape), value) ->
              put " ";
              value_ Argument shape (Thunk.demand value))
            fields)
  in
  (match ((shape : Shape.t), (value : Value.t)) with
  | ( Data { is_event = true; constructors = [ _; { fields = [ (_, occurrence) ]; _ } ] },
      Data { constructor; arguments } ) ->
      if constructor = 1 then value_ Alone occurrence (Thunk.demand arguments.(0))
  | _, _ -> value_ Alone shape value);
  Buffer.contents out

(* {1 Reading} Recursive descent, guided by the shape. *)

exception Expected of string

type reader = { text : string; frames : Kernels.frames option; mutable at : int }

let fail what = raise_notrace (Expected what)
let peek r = if r.at < String.length r.text then r.text.[r.at] else '\000'

let skip_while r holds =
  while r.at < String.length r.text && holds r.text.[r.at] do
    r.at <- r.at + 1
  done

let skip_blanks r = skip_while r (fun c -> c = ' ' || c = '\t')

let accept r c =
  skip_blanks r;
  let found = peek r = c in
  if found then r.at <- r.at + 1;
  found

let expect r c what = if not (accept r c) then fail what

(* Reads the whole word, or nothing. *)
let accept_word r word =
  skip_blanks r;
  let start = r.at in
  skip_while r Basis.Character.is_name;
  let found = String.equal word (String.sub r.text start (r.at - start)) in
  if not found then r.at <- start;
  found

let sign r = if peek r = '-' || peek r = '+' then r.at <- r.at + 1

(* Reads the text that [scan] skips. Fails if a name follows directly. *)
let token r what scan =
  skip_blanks r;
  let start = r.at in
  sign r;
  scan ();
  if Basis.Character.is_name (peek r) then fail what;
  String.sub r.text start (r.at - start)

let without_plus text =
  if text <> "" && text.[0] = '+' then String.sub text 1 (String.length text - 1) else text

let read_int r : Value.t =
  let what = "an integer from -2147483648 to 2147483647" in
  let text =
    token r what (fun () ->
        if not (Basis.Character.is_digit (peek r)) then fail what;
        skip_while r Basis.Character.is_digit;
        if peek r = '.' then fail what)
  in
  (* Accepts any number of digits, as long as the value is in range. *)
  match Int32.of_string_opt (without_plus text) with
  | Some n -> Int n
  | None -> fail what

let digits r =
  let start = r.at in
  skip_while r Basis.Character.is_digit;
  r.at > start

let exponent r =
  let start = r.at in
  if peek r = 'e' || peek r = 'E' then (
    r.at <- r.at + 1;
    sign r;
    if not (digits r) then r.at <- start)

let largest : Basis.Real.t -> string = function
  | Double -> "a number up to 1.79e308, or `inf`"
  | Single -> "a number up to 3.4e38, or `inf`"

let overflows text =
  String.exists Basis.Character.is_digit text
  && Option.fold (float_of_string_opt text) ~none:false ~some:(fun x -> Float.abs x = infinity)

let read_float real r : Value.t =
  let what = "a number" in
  skip_blanks r;
  let start = r.at in
  let negative = peek r = '-' in
  sign r;
  (* [accept_word] would also skip whitespace after the sign. *)
  let is_name = match peek r with 'n' | 'N' | 'i' | 'I' -> true | _ -> false in
  if is_name then (
    let start = r.at in
    skip_while r Basis.Character.is_name;
    match String.lowercase_ascii (String.sub r.text start (r.at - start)) with
    | "nan" -> Float Number.Float.nan
    | "inf" | "infinity" -> Float (if negative then Float.neg_infinity else Float.infinity)
    | _ -> fail what)
  else (
    r.at <- start;
    let text =
      token r what (fun () ->
          let whole = digits r in
          let fraction =
            peek r = '.'
            &&
            (r.at <- r.at + 1;
             digits r)
          in
          if not (whole || fraction) then fail what;
          exponent r)
    in
    let x = Basis.Real.round real (float_of_string (without_plus text)) in
    if Float.is_finite x then Float x else fail (largest real))

(* Reads an unsigned 64-bit integer, in decimal, or in hexadecimal after 0x. *)
let read_natural r =
  skip_blanks r;
  let start = r.at in
  skip_while r Basis.Character.is_name;
  let word = String.sub r.text start (r.at - start) in
  let is_decimal = word <> "" && String.for_all Basis.Character.is_digit word in
  if is_decimal || (String.length word > 2 && String.sub word 0 2 = "0x") then
    Int64.of_string_opt (if is_decimal then "0u" ^ word else word)
  else None

let read_image r : Value.t =
  let is_image = accept_word r "Image" in
  let number = if is_image then read_natural r else None in
  let size = Option.bind number (fun _ -> read_natural r) in
  let hash = Option.bind size (fun _ -> read_natural r) in
  match (number, size, hash, r.frames) with
  | Some number, Some size, Some hash, Some frames
    when Int64.unsigned_compare number 0xffff_ffffL <= 0 -> (
      match Kernels.frame frames ~number:(Int64.to_int number) ~size ~hash with
      | Ok image -> Image image
      | Error expected -> fail expected)
  | Some _, Some _, Some _, None -> fail "an image that is in a file"
  | _, _, _, _ -> fail "an image, as `Image NUMBER SIZE HASH`"

let parenthesis = "`)`"

(* Formats a list of names: `A`, `B` or `C`. *)
let one_of constructors =
  let last = List.length constructors - 1 in
  let name i (c : Shape.constructor) =
    (if i = 0 then "" else if i < last then ", " else " or ") ^ "`" ^ c.name ^ "`"
  in
  String.concat "" (List.mapi name constructors)

let rec read_value r (shape : Shape.t) : Value.t =
  match shape with
  | Tuple shapes -> read_tuple r shapes
  | Bool | Int | Float _ | Text | Drawing | Image | Array _ | Data _ | Console _ ->
      let rec opened count = if accept r '(' then opened (count + 1) else count in
      let rec close count =
        if count > 0 then (
          expect r ')' parenthesis;
          close (count - 1))
      in
      let count = opened 0 in
      let value = read_bare r shape in
      close count;
      value

and read_bare r (shape : Shape.t) : Value.t =
  match shape with
  | Bool ->
      if accept_word r "true" || accept_word r "True" then Bool true
      else if accept_word r "false" || accept_word r "False" then Bool false
      else fail "`true` or `false`"
  | Int -> read_int r
  | Float real -> read_float real r
  | Tuple shapes -> read_tuple r shapes
  | Console controls ->
      if not (accept_word r "Console") then fail "`Console`";
      let fields = List.map (fun (label, shape, _) -> (label, shape)) controls in
      Data { constructor = 0; arguments = read_record r fields }
  | Array (n, element) -> read_array r n element
  | Text -> fail "a label, which cannot be an input"
  | Image -> read_image r
  | Drawing -> Drawing []
  | Data { constructors; is_event = _ } ->
      let rec choose index = function
        | [] -> fail (one_of constructors)
        | (c : Shape.constructor) :: others ->
            if accept_word r c.name then
              Value.Data { constructor = index; arguments = read_arguments r c }
            else choose (index + 1) others
      in
      choose 0 constructors

and read_tuple r shapes : Value.t =
  expect r '(' (if shapes = [] then "`()`" else "`(`, the start of a tuple");
  let component i shape =
    if i > 0 then expect r ',' "`,` and the tuple's next component";
    Thunk.known (read_value r shape)
  in
  let values = Array.of_list (List.mapi component shapes) in
  expect r ')' parenthesis;
  Tuple values

and read_array r n element : Value.t =
  expect r '[' "`[`, the start of an array";
  let next i =
    if i > 0 then expect r ',' "`,` and the array's next element";
    Thunk.known (read_value r element)
  in
  let values = Array.init n next in
  expect r ']' "`]`";
  Array values

and read_arguments r (c : Shape.constructor) =
  if Shape.is_record c then read_record r c.fields
  else Array.of_list (List.map (fun (_, shape) -> Thunk.known (read_value r shape)) c.fields)

(* Reads the fields of a record, which may be in any order; each must occur exactly once. *)
and read_record r fields =
  expect r '{' "`{` and the record's fields";
  let rec read found = function
    | [] -> found
    | missing ->
        if found <> [] then expect r ',' "`,` and the record's next field";
        let name, shape =
          match List.find_opt (fun (name, _) -> accept_word r name) missing with
          | Some field -> field
          | None -> fail "a field of the record that has no value yet"
        in
        expect r '=' "`=` after the field's name";
        let value = Thunk.known (read_value r shape) in
        let is_other (other, _) = not (String.equal name other) in
        read ((name, value) :: found) (List.filter is_other missing)
  in
  let is_bare (_, shape) = shape = Shape.Console [] in
  let bare, seen = List.partition is_bare fields in
  let nothing (name, _) = (name, Thunk.known (Value.Data { constructor = 0; arguments = [||] })) in
  let found = List.map nothing bare @ read [] seen in
  expect r '}' "`}`";
  Array.of_list (List.map (fun (name, _) -> List.assoc name found) fields)

let read_cell r (shape : Shape.t) : Value.t =
  skip_blanks r;
  match shape with
  | Data { is_event = true; constructors = [ _; { fields = [ (_, occurrence) ]; _ } ] } ->
      if r.at = String.length r.text then Data { constructor = 0; arguments = [||] }
      else Data { constructor = 1; arguments = [| Thunk.known (read_value r occurrence) |] }
  | Bool | Int | Float _ | Text | Drawing | Image | Tuple _ | Array _ | Data _ | Console _ ->
      read_value r shape

let read ?frames shape text =
  let r = { text; frames; at = 0 } in
  match
    let value = read_cell r shape in
    skip_blanks r;
    if r.at < String.length text then
      fail
        (match (shape : Shape.t) with
        | Int | Float _ -> "nothing after the number"
        | Bool | Text | Drawing | Image | Tuple _ | Array _ | Data _ | Console _ ->
            "the end of the cell");
    value
  with
  | value -> Ok value
  | exception Expected what -> Error what
