type t =
  | Float
  | Measure of measure
  | Int
  | Bool
  | Tuple of t list
  | Array of int * t
  | Data of data

and measure = { metres : int; seconds : int }
and data = { head : string; constructors : constructor list }
and constructor = { name : string; fields : (string * t) list }

let rec scalars = function
  | Float | Measure _ | Int | Bool -> 1
  | Tuple parts -> sum parts
  | Array (n, t) -> n * scalars t
  | Data { constructors; _ } ->
      List.fold_left (fun n c -> n + sum (List.map snd c.fields)) 1 constructors

and sum types = List.fold_left (fun n t -> n + scalars t) 0 types

let unit_text { metres; seconds } =
  let power name = function 0 -> [] | 1 -> [ name ] | k -> [ Printf.sprintf "%s^%d" name k ] in
  String.concat " " (power "m" metres @ power "s" seconds)

let rec text = function
  | Float -> "Float"
  | Measure u -> Printf.sprintf "Float[%s]" (unit_text u)
  | Array (n, t) -> Printf.sprintf "(Array %d %s)" n (text t)
  | Int -> "Int"
  | Bool -> "Bool"
  | Tuple parts -> "(" ^ String.concat ", " (List.map text parts) ^ ")"
  | Data { head; _ } -> if String.contains head ' ' then "(" ^ head ^ ")" else head

let applied name arguments = String.concat " " (name :: List.map text arguments)
let positional name types = { name; fields = List.map (fun t -> ("", t)) types }

let maybe t =
  Data
    {
      head = applied "Maybe" [ t ];
      constructors = [ positional "Nothing" []; positional "Just" [ t ] ];
    }

let event t =
  Data
    {
      head = applied "Event" [ t ];
      constructors = [ positional "NoEvent" []; positional "Event" [ t ] ];
    }

let unit = Tuple []

let event_payload = function
  | Data { constructors = [ { name = "NoEvent"; _ }; { fields = [ (_, t) ]; _ } ]; _ } -> Some t
  | Float | Measure _ | Int | Bool | Tuple _ | Array _ | Data _ -> None

let measure ~metres ~seconds =
  if metres = 0 && seconds = 0 then Float else Measure { metres; seconds }

let either a b =
  Data
    {
      head = applied "Either" [ a; b ];
      constructors = [ positional "Left" [ a ]; positional "Right" [ b ] ];
    }

let series u n t =
  Data
    {
      head = Printf.sprintf "Series[%s] %d %s" (unit_text u) n (text t);
      constructors =
        [
          {
            name = "Series";
            fields = [ ("step", Measure u); ("entries", Array (n, t)); ("newest", maybe t) ];
          };
        ];
    }

let rec has_instances ~measured = function
  | Float | Measure _ | Int | Bool -> true
  | Array (_, t) -> has_instances ~measured t
  | Tuple [ a; b ] -> has_instances ~measured a && has_instances ~measured b
  | Tuple _ -> false
  | Data { constructors = [ { name = "Left"; fields }; { fields = others; _ } ]; _ } ->
      measured && List.for_all (fun (_, t) -> has_instances ~measured t) (fields @ others)
  | Data { constructors = [ { name = "NoEvent" | "Nothing"; _ }; { fields; _ } ]; _ } ->
      List.for_all (fun (_, t) -> has_instances ~measured t) fields
  | Data { constructors = [ { name = "Series"; fields = [ _; (_, entries); _ ] } ]; _ } ->
      has_instances ~measured entries
  | Data _ -> true

let is_record data =
  match data.constructors with
  | [ { fields = (name, _) :: _; _ } ] -> not (String.equal name "")
  | _ -> false

let scalar random = match Random.State.int random 5 with 0 | 1 -> Float | 2 | 3 -> Int | _ -> Bool

let measures =
  [
    { metres = 1; seconds = 0 };
    { metres = 0; seconds = 1 };
    { metres = 1; seconds = -1 };
    { metres = 2; seconds = 0 };
    { metres = 1; seconds = -2 };
    { metres = 0; seconds = -1 };
  ]

let any_measure random = List.nth measures (Random.State.int random (List.length measures))

let rec of_depth random ~declared depth =
  if depth = 0 then
    if Random.State.int random 8 = 0 then Measure (any_measure random) else scalar random
  else
    let inner () = of_depth random ~declared (depth - 1) in
    match Random.State.int random 15 with
    | 12 | 13 ->
        let size =
          if Random.State.int random 12 = 0 then 5 + Random.State.int random 30
          else 1 + Random.State.int random 4
        in
        (* Large arrays have small elements. *)
        Array (size, if size > 4 then scalar random else inner ())
    | 14 ->
        if Random.State.bool random then Measure (any_measure random)
        else series (any_measure random) (1 + Random.State.int random 3) (inner ())
    | 0 | 1 -> Tuple [ inner (); inner () ]
    | 2 -> Tuple [ inner (); inner (); inner () ]
    | 3 -> maybe (inner ())
    | 4 -> event (inner ())
    | 5 -> either (inner ()) (inner ())
    | (6 | 7) when declared <> [] ->
        List.nth declared (Random.State.int random (List.length declared))
    | _ -> scalar random

let any random ~declared = of_depth random ~declared 2

let declare random ~declared name =
  let field i = (Printf.sprintf "%s%d" (String.uncapitalize_ascii name) i, any random ~declared) in
  let constructor i =
    let fields = List.init (Random.State.int random 3) (fun _ -> any random ~declared) in
    positional (Printf.sprintf "%sC%d" name i) fields
  in
  let constructors =
    match Random.State.int random 4 with
    | 0 ->
        List.init
          (2 + Random.State.int random 3)
          (fun i -> positional (Printf.sprintf "%sE%d" name i) [])
    | 1 -> [ { name; fields = List.init (1 + Random.State.int random 3) field } ]
    | _ -> List.init (1 + Random.State.int random 3) constructor
  in
  Data { head = name; constructors }

let declaration = function
  | Data ({ head; constructors } as data) ->
      let constructor { name; fields } =
        if is_record data then
          let field (name, t) = name ^ " :: " ^ text t in
          name ^ " { " ^ String.concat ", " (List.map field fields) ^ " }"
        else applied name (List.map snd fields)
      in
      Printf.sprintf "data %s = %s\n" head (String.concat " | " (List.map constructor constructors))
  | Float | Measure _ | Int | Bool | Tuple _ | Array _ -> invalid_arg "Type.declaration"
