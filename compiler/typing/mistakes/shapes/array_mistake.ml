open Basis

let is_array t =
  match Type.expand t with Data { tycon; _ } -> tycon = Environment.array | _ -> false

let unlike_sizes a b =
  match (Type.expand a, Type.expand b) with Size a, Size b -> a <> b | _ -> false

(* Both operands, as they are written. *)
let operands words ~subject (expected : Expected.t) =
  let quote (e : Resolve.Ir.expr) = Option.map Source.grouped (Show.quote words e.span) in
  let texts =
    match (expected.because, subject) with
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

let with_each words ~subject expected =
  Option.map
    (fun operator ->
      let a, b = operands words ~subject expected in
      Printf.sprintf "(\\x -> x %s %s) %s" operator b a)
    (arithmetic expected)

let computed words ~subject expected =
  let of_both operator =
    let a, b = operands words ~subject expected in
    let each = Printf.sprintf "`map (\\x -> x %s %s) %s` computes with each element" operator b a in
    match b.[0] with
    | '0' .. '9' -> each
    | _ -> Printf.sprintf "%s, `zipWith (%s) %s %s` with those of two arrays" each operator a b
  in
  Option.map of_both (arithmetic expected)

(* What does to other things what `map` does to arrays. *)
let mapped (expected : Expected.t) found =
  match (expected.because, Type.expand found) with
  | Parameter { callee = Some ("map" | "fmap"); position = 2; at; _ }, t when Environment.is_event t
    ->
      Some ("mapE", "of an event's value", at)
  | Parameter { callee = Some "map"; position = 2; at; _ }, t when Environment.is_task t ->
      Some ("mapT", "of what a task ends with", at)
  | Parameter { callee = Some "mapE"; position = 2; at; _ }, t when is_array t ->
      Some ("map", "of each element of an array", at)
  | _ -> None

let as_a_tuple words (subject : Resolve.Ir.expr option) parts =
  match subject with
  | Some { desc = Array elements; span } when List.compare_lengths elements parts = 0 -> (
      match List.map (fun (e : Resolve.Ir.expr) -> Show.quote words e.span) elements with
      | texts when not (List.mem None texts) ->
          Some (span, "(" ^ String.concat ", " (List.map Option.get texts) ^ ")")
      | _ -> None)
  | _ -> None

let extreme words (subject : Resolve.Ir.expr option) =
  match subject with
  | Some
      {
        desc =
          Apply { head = { desc = Global { name = ("max" | "min") as name; _ }; _ }; argument; _ };
        _;
      } ->
      let xs = Option.fold (Show.quote words argument.span) ~none:"xs" ~some:Source.grouped in
      Some
        (Printf.sprintf "`%s` is of two values; of all elements it is `%simumBy id %s`" name name xs)
  | _ -> None
