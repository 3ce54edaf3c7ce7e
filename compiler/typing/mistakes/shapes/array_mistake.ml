open Basis
open Diagnostic
open Shape_fact

let is_array t =
  match Type.expand t with Data { tycon; _ } -> tycon = Environment.array | _ -> false

let unlike_sizes a b =
  match (Type.expand a, Type.expand b) with Size a, Size b -> a <> b | _ -> false

(* The source texts of both operands. *)
let operands fact =
  let quote (e : Resolve.Ir.expr) = Option.map Source.grouped (Show.quote fact.words e.span) in
  let texts =
    match (fact.expected.because, fact.subject) with
    | Operand { other; _ }, Some e -> [ quote other; quote e ]
    | Parameter { given = [ a; b ]; _ }, _ -> [ quote a; quote b ]
    | _ -> []
  in
  match texts with [ Some a; Some b ] -> (a, b) | _ -> ("xs", "ys")

let arithmetic (expected : Expected.t) =
  match expected.because with
  | Parameter { callee = Some (("+" | "-" | "*" | "/") as operator); _ }
  | Operand { operator = ("+" | "-" | "*" | "/") as operator; _ } ->
      Some operator
  | _ -> None

let with_each fact =
  Option.map
    (fun operator ->
      let a, b = operands fact in
      Printf.sprintf "(\\x -> x %s %s) %s" operator b a)
    (arithmetic fact.expected)

let computed fact =
  let of_both operator =
    let a, b = operands fact in
    let each =
      Printf.sprintf "use `map (\\x -> x %s %s) %s` to compute with each element" operator b a
    in
    match b.[0] with
    | '0' .. '9' -> each
    | _ ->
        Printf.sprintf "%s, or `zipWith (%s) %s %s` to compute with the elements of two arrays" each
          operator a b
  in
  match fact.wanted with
  | Number _ when is_array fact.found ->
      Option.map (fun operator -> hinted fact (of_both operator)) (arithmetic fact.expected)
  | _ -> None

(* The counterpart of `map` for this type, a description, and the place of `map`. *)
let counterpart fact =
  match (fact.expected.because, fact.given) with
  | Parameter { callee = Some ("map" | "fmap"); position = 2; at; _ }, t when Environment.is_event t
    ->
      Some ("mapE", "to an event's value", at)
  | Parameter { callee = Some "map"; position = 2; at; _ }, t when Environment.is_task t ->
      Some ("mapT", "to the result of a task", at)
  | Parameter { callee = Some "mapE"; position = 2; at; _ }, t when is_array t ->
      Some ("map", "to each element of an array", at)
  | _ -> None

(* `map f x`, where `x` is a single value *)
let mapped_over_a_value fact =
  match (fact.given, fact.expected.because) with
  | (Number _ | Bool | String), Parameter { callee = Some "map"; position = 2; given = [ f; x ]; _ }
    when is_array fact.expected.ty -> (
      match (Show.quote fact.words f.span, Show.quote fact.words x.span) with
      | Some f, Some x ->
          Some
            (hinted fact
               (Printf.sprintf "`map` is for arrays: apply the function itself, as in `%s %s`"
                  (Source.grouped f) (Source.grouped x)))
      | _ -> None)
  | _ -> None

let mapped fact =
  Option.map
    (fun (name, of_what, place) ->
      hinted fact (Printf.sprintf "to apply a function %s, use `%s`" of_what name)
      |> write place name)
    (counterpart fact)

let extreme fact =
  match (fact.wanted, fact.given, fact.subject) with
  | ( Number _,
      Function (from, _),
      Some
        {
          desc =
            Apply { head = { desc = Global { name = ("max" | "min") as name; _ }; _ }; argument; _ };
          _;
        } )
    when is_array from ->
      let xs = Option.fold (Show.quote fact.words argument.span) ~none:"xs" ~some:Source.grouped in
      error ~code:"E0301" ~at:fact.at "expected %s, found the function %s" (expected_text fact)
        (found_text fact)
      |> hint
           (Printf.sprintf "`%s` takes two values; for all elements, write `%simumBy id %s`" name
              name xs)
      |> Option.some
  | _ -> None

let written_as_a_tuple fact =
  match (fact.wanted, fact.given) with
  | Data _, Tuple (_ :: _ as given) when is_array fact.expected.ty ->
      error ~code:"E0301" ~at:fact.at "expected %s, found a tuple of %d" (expected_text fact)
        (List.length given)
      |> hint
           (match all (elements fact) with
           | Some elements ->
               Printf.sprintf "write an array in brackets: `[%s]`" (String.concat ", " elements)
           | None ->
               let parts = String.concat ", " (names (List.length given)) in
               Printf.sprintf
                 "take the tuple apart in an equation, `(%s) = %s`, and write an array in \
                  brackets, `[%s]`"
                 parts (raw fact "p") parts)
      |> Option.some
  | _ -> None

let of_another_size fact =
  match (fact.wanted, fact.given) with
  | Data { arguments = [ n; _ ]; _ }, Data { arguments = [ n'; _ ]; _ }
    when is_array fact.expected.ty && is_array fact.found && unlike_sizes n n' ->
      different fact
      |> hint
           (match fact.subject with
           | Some { desc = Array elements; _ } -> (
               let given = List.length elements in
               let count n = if n = 1 then "one element" else Printf.sprintf "%d elements" n in
               match Type.expand n with
               | Size wanted when wanted > given ->
                   Printf.sprintf "add %s, or write %s in the type"
                     (count (wanted - given))
                     (found_text fact)
               | Size wanted ->
                   Printf.sprintf "remove %s, or write %s in the type"
                     (count (given - wanted))
                     (found_text fact)
               | _ ->
                   Printf.sprintf
                     "this has %d elements: write that many in the type, %s, or change the elements"
                     given (found_text fact))
           | _ -> "use `take` or `drop` to change the size of an array; its type gives the new size")
      |> Option.some
  | _ -> None

let of_records fact =
  let element t =
    match Type.expand t with
    | Data { tycon; arguments = [ _; element ]; _ } when tycon = Environment.array -> Some element
    | _ -> None
  in
  let message (_, fields) =
    let shown = List.filteri (fun i _ -> i < 4) fields in
    hinted fact
      (Printf.sprintf
         "its elements are records with the fields %s: choose one, as in `map (\\x -> x.%s)`"
         (Enumeration.all (List.map (Printf.sprintf "`%s`") shown))
         (List.hd (List.rev shown)))
  in
  match (Option.map Type.expand (element fact.wanted), element fact.found) with
  | Some (Number _ | Bool), Some record -> Option.map message (Show.fields fact.words record)
  | _ -> None

let of_several_types fact =
  match fact.expected.because with
  | Element _ ->
      Some
        (hinted fact
           "all elements of an array must have the same type: for values of several types, use a \
            tuple, `(a, b)`, or a record")
  | _ -> None

let of_one_number fact =
  match (fact.wanted, fact.given, fact.expected.because) with
  | Data _, Number _, Parameter { callee = Some (("sum" | "mean" | "length") as f); _ }
    when is_array fact.expected.ty ->
      let x = grouped fact "x" in
      Some
        (hinted fact
           (match f with
           | "sum" ->
               Printf.sprintf
                 "`sum` adds the elements of an array: for the sum of a signal over time, write \
                  `integral %s`"
                 x
           | _ -> Printf.sprintf "`%s` takes an array, as in `%s [a, b, c]`" f f))
  | _ -> None
