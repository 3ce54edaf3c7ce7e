open Ir

let text = Buffer.add_string
let is_operator x = match x.[0] with 'a' .. 'z' | 'A' .. 'Z' | '_' -> false | _ -> true

let separated b separator print list =
  List.iteri
    (fun i x ->
      if i > 0 then text b separator;
      print x)
    list

let between b opening closing print =
  text b opening;
  print ();
  text b closing

let words b print parts =
  List.iter
    (fun part ->
      text b " ";
      print b part)
    parts

let enclosed b opening closing print list =
  between b opening closing (fun () -> separated b ", " print list)

let name b (x : name) =
  if is_operator x.text then between b "(" ")" (fun () -> text b x.text) else text b x.text

let qualified b (x : qualified) =
  match x.qualifier with
  | None -> name b x.name
  | Some q ->
      text b q.text;
      text b ("." ^ x.name.text)

let infix b (x : qualified) =
  if is_operator x.name.text then text b x.name.text
  else between b "`" "`" (fun () -> qualified b x)

(* {1 Units and types} *)

let rational { numerator; denominator } =
  if denominator = 1 && numerator >= 0 then string_of_int numerator
  else if denominator = 1 then Printf.sprintf "(%d)" numerator
  else Printf.sprintf "(%d/%d)" numerator denominator

let rec unit_to b (u : unit_) =
  match u.desc with
  | One -> text b "1"
  | Unit_name x -> text b x.text
  | Times (l, r) ->
      unit_to b l;
      text b " ";
      factor b r
  | Over (l, r) ->
      unit_to b l;
      text b "/";
      factor b r
  | To (u, exponent) ->
      base b u;
      text b "^";
      text b (rational exponent)

and factor b u =
  match u.desc with
  | Times _ | Over _ -> between b "(" ")" (fun () -> unit_to b u)
  | One | Unit_name _ | To _ -> unit_to b u

and base b u =
  match u.desc with
  | Unit_name _ -> unit_to b u
  | One | Times _ | Over _ | To _ -> between b "(" ")" (fun () -> unit_to b u)

let in_brackets b units = enclosed b "[" "]" (unit_to b) units

let rec type_to b (t : ty) =
  match t.desc with
  | Function (a, r) ->
      argument_of_arrow b a;
      text b " -> ";
      type_to b r
  | Type { name; units; arguments } ->
      qualified b name;
      Option.iter (in_brackets b) units;
      words b simple_type arguments
  | Size_operation { operator; left; right } ->
      between b "(" ")" (fun () ->
          argument_of_arrow b left;
          text b
            (match operator with
            | Plus_sizes -> " + "
            | Minus_sizes -> " - "
            | Times_sizes -> " * ");
          argument_of_arrow b right)
  | Type_variable _ | Representation _ | Tuple_type _ | Size _ -> simple_type b t

and argument_of_arrow b t =
  match t.desc with
  | Function _ -> between b "(" ")" (fun () -> type_to b t)
  | Type _ | Type_variable _ | Representation _ | Tuple_type _ | Size _ | Size_operation _ ->
      type_to b t

and simple_type b t =
  match t.desc with
  | Type_variable x -> text b x.text
  | Representation { name = x; unit_ } ->
      text b x.text;
      in_brackets b [ unit_ ]
  | Tuple_type ts -> enclosed b "(" ")" (type_to b) ts
  | Type { arguments = []; _ } | Size_operation _ -> type_to b t
  | Size n -> text b (string_of_int n)
  | Type _ | Function _ -> between b "(" ")" (fun () -> type_to b t)

let context b constraints =
  let constraint_ (c, t) =
    qualified b c;
    text b " ";
    simple_type b t
  in
  match constraints with
  | [] -> ()
  | [ one ] ->
      constraint_ one;
      text b " => "
  | several ->
      enclosed b "(" ")" constraint_ several;
      text b " => "

let qualified_type b (t : qualified_type) =
  context b t.context;
  type_to b t.ty

let signature b (s : signature) =
  separated b ", " (name b) s.names;
  text b " :: ";
  qualified_type b s.ty
