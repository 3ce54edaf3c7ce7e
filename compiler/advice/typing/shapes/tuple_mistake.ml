open Basis
open Typing
open Diagnostic
open Shape_fact

(* The text as an argument. A call in C notation, [f(x, y)], is converted to Frob notation. *)
let argument_of text = Source.grouped (Option.value (Other_notation.expression text) ~default:text)

let selected fact =
  match (fact.wanted, fact.given, fact.expected.because) with
  | Function _, Tuple (_ :: _), (Parameter { callee = Some "."; _ } | Operand { operator = "."; _ })
    ->
      let p = raw fact "p" in
      Some
        (hinted fact
           "to get the elements of a tuple, write an equation: `(a, b) = %s`; for a pair, you can \
            also write `fst %s` and `snd %s`"
           p p p)
  | _ -> None

let of_an_input fact =
  match (fact.wanted, fact.given, fact.subject) with
  | (Number _ | Bool), Tuple (_ :: _ :: _ as parts), Some { desc = Local x; _ }
    when Wording.is_input fact.words x.name ->
      Some
        (hinted fact "`%s` is the whole input: take it apart in the pattern, as in `proc (%s) -> …`"
           x.name
           (String.concat ", " (names (List.length parts)))
        |> label ~at:x.span "this is one name for the whole tuple")
  | _ -> None

(* The call with one tuple of this length in place of the mismatched argument and all later ones. If
   the number of these arguments differs from the length, all components but the first have
   generated names. *)
let gathered fact length =
  let before, after =
    match fact.expected.because with
    | Parameter { given; position; _ } ->
        ( List.filteri (fun i _ -> i < position - 1) given,
          List.filteri (fun i _ -> i >= position) given )
    | _ -> ([], [])
  in
  let quote (e : Resolve.Ir.expr) = Wording.quote fact.words e.span in
  let before =
    List.map (fun e -> " " ^ Option.fold (quote e) ~none:"…" ~some:Source.grouped) before
  in
  let written = if List.length after + 1 = length then List.map quote after else [] in
  let other i =
    match List.nth_opt written i with
    | Some (Some text) -> text
    | Some None | None -> Variable_name.nth Variable_name.Type (i + 1)
  in
  Printf.sprintf "%s%s (%s)" (callee fact) (String.concat "" before)
    (String.concat ", " (raw fact "a" :: List.init (length - 1) other))

(* `resetOn time (edge b)`, with only the second part of the pair *)
let second_part fact =
  match (fact.wanted, fact.expected.because) with
  | Tuple [ first; second ], Parameter { given; position; callee = Some f; _ }
    when Environment.is_event second && Environment.is_event fact.found
         && not (Environment.is_event first) -> (
      let quote (e : Resolve.Ir.expr) =
        Option.map Source.grouped (Wording.quote fact.words e.span)
      in
      let before = List.filteri (fun i _ -> i < position - 1) given in
      match (all (List.map quote before), source fact) with
      | Some before, Some event ->
          let input = Unrun_mistake.signal_for fact.words first in
          let pair = Printf.sprintf "(%s, %s)" input event in
          Some
            (hinted fact "pass the input and the event as a pair: `%s`"
               (String.concat " " ((f :: before) @ [ pair ]))
            |> write fact.at pair)
      | _ -> None)
  | _ -> None

let parameter fact =
  match (fact.wanted, fact.given) with
  | Tuple _, Data _ when second_part fact <> None -> second_part fact
  | Tuple (_ :: _ as wanted), (Number _ | Bool | Data _) when is_a_parameter fact ->
      let length = List.length wanted in
      Some
        (hinted fact "`%s` takes one tuple with %d elements: write `%s`" (callee fact) length
           (gathered fact length))
  | _ -> None

(* How to take a tuple apart where a tuple of a different length is expected. *)
let taken_apart fact given =
  let names = String.concat ", " (names (List.length given)) in
  match fact.expected.because with
  | Parameter { callee = Some ("fst" | "snd"); _ } ->
      hint "to get its elements, write an equation: `(%s) = %s`" names (raw fact "p")
  | Pattern _ -> hint "write the pattern as `(%s)`" names
  | (Signature _ | Annotation _ | Parameter _) when fact.subject = None ->
      let names =
        match fact.wanted with
        | Tuple wanted -> String.concat ", " (Shape_fact.names (List.length wanted))
        | _ -> names
      in
      hint "write the pattern as `(%s)`" names
  | _ -> Fun.id

let ordinal n =
  match List.nth_opt [ "first"; "second"; "third"; "fourth"; "fifth"; "sixth" ] n with
  | Some text -> text
  | None -> string_of_int (n + 1) ^ "th"

let without i list = List.filteri (fun j _ -> i <> j) list

(* Describes the element that only the longer list contains, if the types of the elements show which
   one it is. *)
let odd_part fact wanted given =
  let text t =
    match Type.expand t with
    | Type.Number (_, u) -> "number of " ^ Wording.measure fact.words u
    | t -> Wording.type_ fact.words t
  in
  let odd longer shorter =
    let fits i _ = List.for_all2 (fun a b -> text a = text b) (without i longer) shorter in
    let places =
      List.mapi (fun i t -> (i, t, fits i t)) longer |> List.filter (fun (_, _, fits) -> fits)
    in
    match places with
    | [ (i, t, _) ] ->
        Some
          (Some i, Printf.sprintf "the %s element, %s," (ordinal i) (Wording.described fact.words t))
    | (_, t, _) :: _ ->
        Some
          ( None,
            if Wording.is_any_number t then "a number"
            else Printf.sprintf "an element of type %s" (Wording.described fact.words t) )
    | [] -> None
  in
  match List.compare_lengths wanted given with
  | 1 when List.compare_length_with given (List.length wanted - 1) = 0 ->
      Option.map (fun (_, part) -> hint "%s is missing" part) (odd wanted given)
  | -1 when List.compare_length_with wanted (List.length given - 1) = 0 ->
      Option.map
        (fun (i, part) ->
          match (i, fact.subject, all (elements fact)) with
          | Some i, Some { desc = Tuple _; span }, Some texts ->
              let text = "(" ^ String.concat ", " (without i texts) ^ ")" in
              fun d -> hint "%s is one too many: write `%s`" part text d |> write span text
          | _ -> hint "%s" (part ^ " is one too many"))
        (odd given wanted)
  | _ -> None

let of_another_length fact =
  match (fact.wanted, fact.given) with
  | Tuple (_ :: _ as wanted), Tuple (_ :: _ as given) when List.compare_lengths wanted given <> 0 ->
      error ~code:"E0301" ~at:fact.at "expected a tuple with %d elements, found one with %d"
        (List.length wanted) (List.length given)
      |> (match fact.subject with
         | Some { desc = Tuple _; _ } -> Fun.id
         | _ -> here "this is %s" (found_text fact))
      |> (fun d ->
      match (taken_apart fact given d, fact.subject) with
      | d, Some { desc = Tuple _; _ } when d.hints = [] ->
          Option.value (odd_part fact wanted given) ~default:Fun.id d
      | d, _ -> d)
      |> Option.some
  | _ -> None

let written_as_an_array fact =
  match (fact.wanted, fact.subject) with
  | Tuple (_ :: _ as parts), Some { desc = Array elements; span }
    when Array_mistake.is_array fact.given && List.compare_lengths elements parts = 0 ->
      let message texts =
        let tuple = "(" ^ String.concat ", " texts ^ ")" in
        hinted fact "use parentheses for a tuple: `%s`" tuple |> write span tuple
      in
      List.map (fun (e : Resolve.Ir.expr) -> Wording.quote fact.words e.span) elements
      |> all |> Option.map message
  | _ -> None

(* The components as separate arguments; generated names replace long components. *)
let side_by_side fact components =
  let written = elements fact in
  let argument i _ =
    match List.nth_opt written i with
    | Some (Some text) -> argument_of text
    | _ -> Variable_name.nth Variable_name.Type i
  in
  String.concat " " (List.mapi argument components)

(* The subject, or its definition if it is a local name. *)
let call fact =
  match fact.subject with
  | Some { desc = Local x; _ } -> Wording.definition fact.words x
  | subject -> subject

let takes_two_of_a_kind name = List.mem name [ "min"; "max"; "mergeE"; "mergeR" ]

(* `max x (max y z)` for these arguments of `max`. *)
let rec nested name = function
  | [] -> ""
  | [ last ] -> last
  | [ a; b ] -> Printf.sprintf "%s %s %s" name a b
  | first :: others -> Printf.sprintf "%s %s (%s)" name first (nested name others)

let nested_of fact name (es : Resolve.Ir.expr list) =
  let quote (e : Resolve.Ir.expr) = Wording.quote fact.words e.span in
  Option.map (fun texts -> nested name (List.map argument_of texts)) (all (List.map quote es))

(* `min(x, y, z)` or `mergeE [a, b, c]` *)
let of_more_than_two fact =
  let report ~at name es =
    Option.map
      (fun text ->
        error ~code:"E0301" ~at "`%s` takes two values, but is given %d" name (List.length es)
        |> hint "write `%s`" text)
      (nested_of fact name es)
  in
  match (fact.expected.because, fact.subject, call fact) with
  | ( Parameter { callee = Some name; position = 1; _ },
      Some { desc = Array (_ :: _ :: _ :: _ as es) | Tuple (_ :: _ :: _ :: _ as es); span },
      _ )
    when takes_two_of_a_kind name && Environment.is_event fact.wanted ->
      report ~at:span name es
  | ( _,
      _,
      Some
        {
          desc =
            Apply
              {
                head = { desc = Global { name; _ }; _ };
                argument = { desc = Tuple (_ :: _ :: _ :: _ as es); _ };
                style = Juxtaposed;
              };
          span;
        } )
    when takes_two_of_a_kind name && match fact.given with Function _ -> true | _ -> false ->
      report ~at:span name es
  | _ -> None

(* `max(x, 0)`, where the general type of `max` accepts a tuple as its first argument. *)
let of_all_arguments fact =
  match (fact.wanted, fact.given, call fact) with
  | ( (Number _ | Bool | String | Tuple _ | Data _),
      Function _,
      Some
        {
          desc =
            Apply
              {
                head = { desc = Global { name; _ }; _ };
                argument = { desc = Tuple es; _ };
                style = Juxtaposed;
              };
          span;
        } )
    when List.length es = 1 + Argument_mistake.missing_arguments fact.found ->
      let quote (e : Resolve.Ir.expr) = Wording.quote fact.words e.span in
      let d =
        error ~code:"E0301" ~at:span "`%s` takes %d arguments, but is given one tuple" name
          (List.length es)
      in
      Some
        (match all (List.map quote es) with
        | Some texts ->
            let text = String.concat " " (name :: List.map argument_of texts) in
            hint "write the arguments without parentheses or commas: `%s`" text d
            |> fix (Printf.sprintf "write `%s`" text) [ (span, "(" ^ text ^ ")") ]
        | None -> hint "write the arguments without parentheses or commas, as in `f x y`" d)
  | _ -> None

(* Arduino's `map(x, 0, 1023, 0, 5)` *)
let mapped_range fact =
  match (fact.given, fact.expected.because, fact.subject) with
  | ( Tuple [ _; _; _; _; _ ],
      Parameter { callee = Some "map"; position = 1; _ },
      Some { desc = Tuple es; _ } ) ->
      let written =
        Option.bind
          (all (List.map (fun (e : Resolve.Ir.expr) -> Wording.quote fact.words e.span) es))
          (fun texts -> Other_notation.expression ("map(" ^ String.concat ", " texts ^ ")"))
      in
      error ~code:"E0301" ~at:fact.at "`map` applies a function to each element of an array"
      |> hint "to convert a number from one range to another, write `%s`"
           (Option.value written ~default:"(x - a) / (b - a) * (d - c) + c")
      |> Option.some
  | _ -> None

(* `latch (set, reset)` *)
let without_winner fact =
  match (fact.given, fact.expected.because, fact.subject) with
  | ( Tuple [ _; _ ],
      Parameter { callee = Some "latch"; position = 1; given = [ _ ]; _ },
      Some { desc = Tuple _; span } ) ->
      let text = Option.value (Wording.quote fact.words span) ~default:"(set, reset)" in
      let d =
        error ~code:"E0301" ~at:fact.at "expected %s, found a tuple with 2 elements"
          (expected_text fact)
        |> hint ~topic:(Call "latch")
             "say what happens if both are True: write `latch ResetWins %s` or `latch SetWins %s`"
             text text
      in
      Some d
  | _ -> None

(* The text, unless it is a number. *)
let signal_of text =
  match text with
  | Some text when text <> "" && not (Character.is_digit text.[0]) -> Some text
  | Some _ | None -> None

let is_a_letter = function 'a' .. 'z' | 'A' .. 'Z' -> true | _ -> false

let separated_by_commas fact =
  match (fact.wanted, fact.given, fact.expected.because) with
  | ( (Number _ | Bool | String | Data _),
      Tuple (_ :: _ as components),
      Parameter { position = 1; callee = Some name; takes; _ } )
    when is_a_letter name.[0] ->
      let arguments = side_by_side fact components in
      error ~code:"E0301" ~at:fact.at "expected %s, found a tuple with %d elements"
        (expected_text fact) (List.length components)
      |> hint ~topic:(Call name) "%s"
           (match (takes, name) with
           | 1, "atan" -> Printf.sprintf "for two numbers, write `atan2 %s`" arguments
           | 1, ("integral" | "derivative") when List.find_map signal_of (elements fact) <> None ->
               Printf.sprintf "`%s` takes one argument and starts at 0: write `%s %s`" name name
                 (argument_of (Option.get (List.find_map signal_of (elements fact))))
           | 1, _ -> Printf.sprintf "`%s` takes one argument, not a tuple" name
           | _ ->
               Printf.sprintf "write the arguments without parentheses or commas: `%s %s`" name
                 arguments)
      |> Option.some
  | _ -> None

(* The text with its only comma replaced by a decimal point, if the comma is between two whole
   numbers. *)
let with_decimal_point text =
  let starts_with_a_whole_number text =
    let rec after i =
      if i < String.length text && Character.is_digit text.[i] then after (i + 1) else i
    in
    let stop = after 0 in
    stop > 0 && (stop = String.length text || text.[stop] <> '.')
  in
  let rec ends_with_a_whole_number text stop =
    stop > 0
    &&
    match text.[stop - 1] with
    | c when Character.is_digit c -> ends_with_a_whole_number text (stop - 1)
    | c -> stop < String.length text && not (Character.is_name c || c = '.')
  in
  match String.split_on_char ',' text with
  | [ before; after ]
    when starts_with_a_whole_number after && ends_with_a_whole_number before (String.length before)
    ->
      Some (before ^ "." ^ after)
  | _ -> None

(* `0,4[m]` *)
let of_a_decimal_comma fact =
  match (fact.wanted, fact.given, fact.subject) with
  | Number _, Tuple [ _; _ ], Some { desc = Tuple [ _; { desc = Number _; _ } ]; span } ->
      Option.map
        (fun text ->
          hinted fact "use a decimal point, because a comma makes a tuple: write `%s`" text
          |> write span text)
        (Option.bind (Wording.quote fact.words span) with_decimal_point)
  | _ -> None

let of_a_function_and_its_argument fact =
  match (fact.wanted, fact.given, fact.subject) with
  | Function _, Tuple (first :: others), Some { desc = Tuple (head :: arguments); span }
    when not
           (List.exists
              (fun t -> match Type.expand t with Type.Function _ -> true | _ -> false)
              others) -> (
      let quote (e : Resolve.Ir.expr) = Wording.quote fact.words e.span in
      match (Type.expand first, quote head, all (List.map quote arguments)) with
      | Function _, Some head, Some arguments ->
          let text = String.concat " " (head :: List.map Source.grouped arguments) in
          Some
            (hinted fact "a comma makes a tuple: separate the arguments with spaces, `(%s)`" text
            |> write span ("(" ^ text ^ ")"))
      | _ -> None)
  | _ -> None
