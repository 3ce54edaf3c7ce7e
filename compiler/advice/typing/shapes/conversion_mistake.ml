open Typing
open Shape_fact

let of_a_number fact =
  match (fact.wanted, fact.given) with
  | Data { tycon = { name; _ }; _ }, Number _ ->
      Option.map (hinted fact "%s") (Representation_mistake.makes name (grouped fact "x"))
  | _ -> None

(* An array of seeds, as in `seeds = [1, 2, 3]`. *)
let of_seeds fact =
  let number (e : Resolve.Ir.expr) =
    match e.desc with Number { digits; unit_ = None; _ } -> int_of_string_opt digits | _ -> None
  in
  match (fact.wanted, fact.subject) with
  | Data { tycon = { name = "Seeds"; _ }; _ }, Some { desc = Array (_ :: _ as elements); span } -> (
      let numbers = List.filter_map number elements in
      match List.sort Int.compare numbers with
      | first :: _ as sorted when List.compare_lengths numbers elements = 0 ->
          let last = List.nth sorted (List.length sorted - 1) in
          let text = Printf.sprintf "%d `to` %d" first last in
          Some
            (hinted fact "write the first and the last seed: ``%s``" text
            |> Basis.Diagnostic.write span text)
      | _ -> None)
  | _ -> None

let is_operator fact =
  match fact.expected.because with
  | Parameter { callee = Some name; _ } -> (
      match name.[0] with 'a' .. 'z' | 'A' .. 'Z' -> false | _ -> true)
  | _ -> false

let of_a_text fact =
  match (fact.wanted, fact.given) with
  | Number (_, u), String
    when (not (Units.is_open u))
         &&
         match fact.expected.because with
         | Signature _ | Output _ | Branch _ | Parameter _ | Field _ -> not (is_operator fact)
         | _ -> false ->
      let zero =
        match Wording.measure fact.words u with "1" -> "0" | unit_ -> Printf.sprintf "0[%s]" unit_
      in
      Some (hinted fact "a string is only a label: write a number, such as `%s`, in its place" zero)
  | Number _, String ->
      Some
        (hinted fact "a string is only a label: you cannot compute with strings or concatenate them")
  | _ -> None

let alternatives names =
  let rec joined = function
    | [] -> ""
    | [ last ] -> last
    | [ a; b ] -> a ^ " or " ^ b
    | a :: others -> a ^ ", " ^ joined others
  in
  joined (List.map (Printf.sprintf "`%s`") names)

let by_a_constructor fact =
  match (fact.wanted, fact.given) with
  | Data _, Data _ -> (
      match Wording.makers fact.words fact.expected.ty ~of_:fact.found with
      | [] -> None
      | makers -> Some (hinted fact "use %s to convert this value" (alternatives makers)))
  | _ -> None

let capital_choice fact =
  match fact.subject with
  | Some { desc = Global { name; _ } | Local { name; _ }; _ } ->
      let meant = String.capitalize_ascii name in
      if List.mem meant (Wording.choices fact.words fact.expected.ty) then
        Some (hinted fact "did you mean `%s`?" meant |> Basis.Diagnostic.write fact.at meant)
      else None
  | Some _ | None -> None

let verdict_of_a_truth fact =
  match (fact.wanted, fact.given, source fact) with
  | Data { tycon = { name = "Verdict"; module_ = "Prelude" }; _ }, Bool, Some text ->
      let is_one_word = String.equal text (Basis.Source.grouped text) in
      let call = "verdict " ^ Basis.Source.grouped text in
      (* the span of an argument excludes its parentheses *)
      let written =
        match fact.expected.because with
        | (Parameter _ | Operand _) when fact.expected.parts = [] && is_one_word -> "(" ^ call ^ ")"
        | _ -> call
      in
      Some
        (hinted fact "turn the `Bool` into a `Verdict`: write `%s`" written
        |> Basis.Diagnostic.write fact.at written)
  | _ -> None

let is_written_out fact =
  match fact.subject with
  | Some { desc = Constructor _ | String _ | Number _; _ } -> true
  | Some _ | None -> false

let to_a_choice fact =
  match fact.expected.because with
  | Parameter _ | Operand _ | Field _ | Signature _ | Output _ | Branch _ -> (
      match (Wording.choices fact.words fact.expected.ty, fact.given) with
      | [], _ -> None
      | ([ _; _ ] as choices), Bool ->
          Some
            (hinted fact "use %s, as in `if %s then … else …`" (alternatives choices) (raw fact "b"))
      | choices, _ when is_written_out fact -> Some (hinted fact "use %s" (alternatives choices))
      | _ -> None)
  | _ -> None
