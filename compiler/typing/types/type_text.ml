type tree =
  | Word of string
  | Applied of string * tree list
  | Arrow of tree * tree
  | Group of tree list

let write tree =
  let buffer = Buffer.create 64 in
  let add = Buffer.add_string buffer in
  let parenthesized condition body =
    if condition then add "(";
    body ();
    if condition then add ")"
  in
  (* Syntactic context: 0 for any, 1 for the left of an arrow, 2 for a type argument. *)
  let rec go tightness = function
    | Word text -> add text
    | Applied (head, arguments) ->
        parenthesized (tightness > 1) (fun () ->
            add head;
            List.iter
              (fun argument ->
                add " ";
                go 2 argument)
              arguments)
    | Arrow (a, b) ->
        parenthesized (tightness > 0) (fun () ->
            go 1 a;
            add " -> ";
            go 0 b)
    | Group elements ->
        parenthesized true (fun () ->
            List.iteri
              (fun i element ->
                if i > 0 then add ", ";
                go 0 element)
              elements)
  in
  go 0 tree;
  Buffer.contents buffer

let applied head = function [] -> Word head | arguments -> Applied (head, arguments)

(* Each negative power follows a slash of its own. *)
let product powers =
  let factor (name, p) =
    if Rational.equal p Rational.one then name
    else if Rational.is_integer p then name ^ "^" ^ Rational.to_string p
    else Printf.sprintf "%s^(%s)" name (Rational.to_string p)
  in
  let below, above = List.partition (fun (_, p) -> Rational.is_negative p) powers in
  let numerator =
    match above with [] -> "1" | above -> String.concat " " (List.map factor above)
  in
  List.fold_left
    (fun text (name, p) -> text ^ "/" ^ factor (name, Rational.negate p))
    numerator below

let bracketed head units = if units = [] then head else head ^ "[" ^ String.concat ", " units ^ "]"

(* [Float[1]] is written [Float]; [n[1]] keeps its brackets. *)
let number representation unit_ =
  match representation with
  | `Named name when unit_ = "1" -> name
  | `Named name | `Variable name -> bracketed name [ unit_ ]

let base_names powers = List.map (fun ((g : Ir.Global.t), p) -> (g.name, p)) powers
