open Basis
open Typing

(* The corrected left-hand side `mix (x, y) = …`, if the program has `mix x y = …` but the signature
   has one tuple parameter. *)
let as_one_tuple words ~name parameters (expected : Expected.t) =
  match (name, Type.expand expected.ty) with
  | Some name, Function (first, _) -> (
      let quote (p : Resolve.Ir.pattern) = Wording.quote words p.span in
      let all = List.filter_map quote parameters in
      match Type.expand first with
      | Tuple elements
        when List.compare_lengths elements parameters = 0 && List.compare_lengths all parameters = 0
        ->
          Some (Printf.sprintf "%s (%s) = …" name (String.concat ", " all))
      | _ -> None)
  | _ -> None

let too_many words ~name ~at ~parameters (expected : Expected.t) ~result allowed =
  let what = match name with Some name -> "`" ^ name ^ "`" | None -> "this function" in
  let diagnostic =
    match allowed with
    | 0 ->
        Diagnostic.error ~code:"E0302" ~at "%s has a parameter, but its type is not a function type"
          what
    | 1 ->
        Diagnostic.error ~code:"E0302" ~at
          "%s has more than one parameter, but its type allows only one" what
    | _ ->
        Diagnostic.error ~code:"E0302" ~at "%s has too many parameters: its type allows only %d"
          what allowed
  in
  let diagnostic = Reason_label.add words expected diagnostic in
  match Type.expand result with
  | _ when as_one_tuple words ~name parameters expected <> None ->
      Diagnostic.hint
        "the signature has one parameter, a tuple: write `%s`, or write `->` between the types"
        (Option.get (as_one_tuple words ~name parameters expected))
        diagnostic
  | Signal_function _ ->
      let quote (p : Resolve.Ir.pattern) = Wording.quote words p.span in
      let texts = List.filter_map quote parameters in
      let hint =
        match (name, List.rev texts) with
        | Some name, last :: others
          when List.length texts = List.length parameters && List.length others = allowed ->
            Printf.sprintf
              "make the signal the input of a `proc`: begin the definition with `%s = proc %s ->`"
              (String.concat " " (name :: List.rev others))
              last
        | _ -> "take the signal in a `proc`: `proc x -> …`"
      in
      Diagnostic.hint "%s" hint diagnostic
  | _ -> (
      let texts =
        List.filter_map (fun (p : Resolve.Ir.pattern) -> Wording.quote words p.span) parameters
      in
      match (name, expected.because) with
      | Some name, Signature _ when List.length texts = List.length parameters ->
          Diagnostic.hint
            "the signature needs a type for each parameter (`%s`) and one for the result: `%s :: \
             %s -> …`"
            (String.concat "`, `" texts) name
            (String.concat " -> " (List.map (fun _ -> "…") texts))
            diagnostic
      | _ -> diagnostic)

let in_a_tuple words ~name ~at (parts : Resolve.Ir.pattern list) expected =
  let quote (p : Resolve.Ir.pattern) = Option.map Source.grouped (Wording.quote words p.span) in
  let texts = List.filter_map quote parts in
  Diagnostic.error ~code:"E0301" ~at "`%s` takes %d separate arguments, not a tuple" name
    (List.length parts)
  |> Reason_label.add words expected
  |>
  if List.compare_lengths texts parts <> 0 then Fun.id
  else
    let text = String.concat " " texts in
    fun d -> Diagnostic.hint "write `%s %s = …`" name text d |> Diagnostic.write at text

(* The signature with these types inserted before its result, which is a signal function. *)
let with_types signature types =
  let insert i =
    String.sub signature 0 i
    ^ String.concat "" (List.map (Printf.sprintf "%s -> ") types)
    ^ String.sub signature i (String.length signature - i)
  in
  let starts i =
    i + 3 <= String.length signature && String.equal (String.sub signature i 3) "SF "
  in
  let rec find i =
    if i > String.length signature then None
    else if starts i && (i = 0 || signature.[i - 1] = ' ') then Some (insert i)
    else find (i + 1)
  in
  find 0

(* `f d = proc i -> …` with the signature `f :: SF a b`, which lacks the type of `d`. *)
let lacking_types words ~name ~at (expected : Expected.t) lacking =
  let names, types = List.split lacking in
  let types = List.map (fun t -> Source.grouped (Wording.type_ words t)) types in
  let shown = Enumeration.all (List.map (Printf.sprintf "`%s`") names) in
  let d =
    Diagnostic.error ~code:"E0302" ~at "the signature of `%s` lacks the type of %s" name shown
    |> Reason_label.add words expected
  in
  match expected.because with
  | Signature { at; _ } -> (
      match Option.bind (Wording.quote words at) (fun text -> with_types text types) with
      | Some text -> Diagnostic.hint "write `%s :: %s`" name text d |> Diagnostic.write at text
      | None -> d)
  | _ -> d

let refutable_input ~(pattern : Resolve.Ir.pattern) input d =
  Diagnostic.hint "%s"
    (match Type.expand input with
    | Tuple (_ :: _ :: _ as parts) ->
        Printf.sprintf "take the input apart, as in `(%s)`, or use `_`, which matches every value"
          (String.concat ", " (Shape_fact.names (List.length parts)))
    | _ -> "use `_`, which matches every value")
    d
  |> Diagnostic.write pattern.span "_"
