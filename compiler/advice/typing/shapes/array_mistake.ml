open Basis
open Typing
open Diagnostic
open Shape_fact

let is_array t =
  match Type.expand t with Data { tycon; _ } -> tycon = Environment.array | _ -> false

let unlike_sizes a b =
  match (Type.expand a, Type.expand b) with Size a, Size b -> a <> b | _ -> false

(* The source texts of both operands. *)
let operands fact =
  let quote = Wording.argument fact.words in
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

(* The type of the second operand, if it is a local name or a fully applied function. *)
let second_operand fact =
  let rec result arguments t =
    match (arguments, Type.expand t) with
    | [], _ -> Some t
    | _ :: rest, Function (_, r) -> result rest r
    | _ :: _, _ -> None
  in
  let type_of (e : Resolve.Ir.expr) =
    match e.desc with
    | Apply { style = Juxtaposed; _ } -> (
        match Resolve.Walk.application e with
        | { desc = Global g; _ }, arguments ->
            Option.bind (Wording.declared_type fact.words g) (result arguments)
        | _ -> None)
    | Local x -> (
        match List.assoc_opt x.name (Wording.inputs fact.words) with
        | Some t -> Some t
        | None -> Wording.local fact.words x)
    | _ -> None
  in
  match fact.expected.because with
  | Parameter { given = [ _; b ]; position = 1; _ } -> type_of b
  | _ -> None

(* Is the expression the field `sonar` of a robot's input, as in `i.sonar`? *)
let is_a_reading fact =
  match fact.subject with
  | Some { desc = Field { record = { desc = Local x; _ }; field = { text = "sonar"; _ }; _ }; _ } ->
      Wording.is_input fact.words x.name
  | Some _ | None -> false

(* `a * x` for a matrix and a vector, or for two matrices *)
let product fact =
  let element t =
    match Type.expand t with
    | Data { tycon; arguments = [ _; element ]; _ } when tycon = Environment.array -> Some element
    | _ -> None
  in
  let is_a_row t =
    match Option.map Type.expand (element t) with Some (Number _) -> true | _ -> false
  in
  let is_a_matrix t = Option.fold (element t) ~none:false ~some:is_a_row in
  match (arithmetic fact.expected, fact.expected.because, second_operand fact) with
  | Some "*", Parameter { given = [ first; second ]; _ }, Some other
    when is_a_matrix fact.found && (is_a_row other || is_a_matrix other) ->
      let a, b = operands fact in
      let text = Printf.sprintf "%s %s %s" (if is_a_row other then "matVec" else "matMul") a b in
      Some
        (hinted fact "to multiply a matrix by a %s, write `%s`"
           (if is_a_row other then "vector" else "matrix")
           text
        |> write (Span.merge first.span second.span) ("(" ^ text ^ ")"))
  | _ -> None

let computed fact =
  let is_of_two = Option.fold (second_operand fact) ~none:false ~some:is_array in
  let of_both operator =
    let a, b = operands fact in
    if is_of_two then
      Printf.sprintf "to compute with the elements of two arrays, write `zipWith (%s) %s %s`"
        operator a b
    else
      let each =
        Printf.sprintf "use `map (\\x -> x %s %s) %s` to compute with each element" operator b a
      in
      match b.[0] with
      | '0' .. '9' -> each
      | _ ->
          Printf.sprintf "%s, or `zipWith (%s) %s %s` to compute with the elements of two arrays"
            each operator a b
  in
  match fact.wanted with
  | Number _ when is_array fact.found ->
      Option.map
        (fun operator ->
          let d = hinted fact "%s" (of_both operator) in
          match fact.expected.because with
          | Parameter { given = [ first; second ]; _ } when is_of_two ->
              let a, b = operands fact in
              let text = Printf.sprintf "(zipWith (%s) %s %s)" operator a b in
              fix "use `zipWith`" [ (Span.merge first.span second.span, text) ] d
          | _ -> d)
        (arithmetic fact.expected)
  | Number _ when is_array fact.found && is_a_reading fact ->
      Some
        (hinted fact
           "this field contains all readings: for the distance ahead, write `frontSonar i`; for a \
            single sonar, write, for example, `sonars i ! 3`")
  | _ -> None

(* The function to write in place of `map` or `mapE`, the words that complete the hint `to apply a
   function …`, and the place to change. *)
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
      match (Wording.quote fact.words f.span, Wording.quote fact.words x.span) with
      | Some f, Some x ->
          Some
            (hinted fact "`map` is for arrays: apply the function directly, as in `%s %s`"
               (Source.grouped f) (Source.grouped x))
      | _ -> None)
  | _ -> None

let mapped fact =
  let applied name =
    match fact.expected.because with
    | Parameter { given = [ f; x ]; _ } -> (
        match (Wording.quote fact.words f.span, Wording.quote fact.words x.span) with
        | Some f, Some x ->
            Printf.sprintf "write `%s %s %s`" name (Source.grouped f) (Source.grouped x)
        | _ -> Printf.sprintf "use `%s`" name)
    | _ -> Printf.sprintf "use `%s`" name
  in
  Option.map
    (fun (name, of_what, place) ->
      hinted fact "to apply a function %s, %s" of_what (applied name) |> write place name)
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
      let xs = Wording.argument_or "xs" fact.words argument in
      error ~code:"E0301" ~at:fact.at "expected %s, found the function %s" (expected_text fact)
        (found_text fact)
      |> hint "`%s` takes two values; for all elements, write `%simumBy id %s`" name name xs
      |> Option.some
  | _ -> None

let written_as_a_tuple fact =
  match (fact.wanted, fact.given) with
  | Data _, Tuple (_ :: _ as given) when is_array fact.expected.ty ->
      error ~code:"E0301" ~at:fact.at "expected %s, found a tuple with %d elements"
        (expected_text fact) (List.length given)
      |> hint "%s"
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
      |> hint "%s"
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
                     "this has %d elements: change the size in its type, %s, or add or remove \
                      elements"
                     given (found_text fact))
           | _ ->
               "use `take` or `drop` to change the size of an array; the type of the result gives \
                the new size")
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
    hinted fact "its elements are records with the fields %s: choose one, as in `map (\\x -> x.%s)`"
      (Enumeration.all (List.map (Printf.sprintf "`%s`") shown))
      (List.hd (List.rev shown))
  in
  match (Option.map Type.expand (element fact.wanted), element fact.found) with
  | Some (Number _ | Bool), Some record -> Option.map message (Wording.fields fact.words record)
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
        (hinted fact "%s"
           (match f with
           | "sum" ->
               Printf.sprintf
                 "`sum` adds the elements of an array: for the sum of a signal over time, write \
                  `integral %s`"
                 x
           | _ -> Printf.sprintf "`%s` takes an array, as in `%s [a, b, c]`" f f))
  | _ -> None
