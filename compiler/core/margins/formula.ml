open Basis

type t =
  | Constant of bool
  | Column of int
  | Not of t
  | And of t * t
  | Or of t * t
  | Choice of t * t * t
  | Timed of { operator : string; time : int option; conditions : t list }

let not_ = function Constant b -> Constant (not b) | Not a -> a | a -> Not a

let and_ a b =
  match (a, b) with
  | Constant true, c | c, Constant true -> c
  | Constant false, _ | _, Constant false -> Constant false
  | a, b -> And (a, b)

let or_ a b =
  match (a, b) with
  | Constant false, c | c, Constant false -> c
  | Constant true, _ | _, Constant true -> Constant true
  | a, b -> Or (a, b)

let choice condition a b =
  match (condition, a, b) with
  | Constant true, c, _ | Constant false, _, c -> c
  | c, Constant true, b -> or_ c b
  | c, Constant false, b -> and_ (not_ c) b
  | c, a, Constant true -> or_ (not_ c) a
  | c, a, Constant false -> and_ c a
  | c, a, b -> Choice (c, a, b)

let rec json name : t -> Json.t = function
  | Constant b -> Bool b
  | Column n -> String (name n)
  | Not a -> List [ String "not"; json name a ]
  | And (a, b) -> List [ String "and"; json name a; json name b ]
  | Or (a, b) -> List [ String "or"; json name a; json name b ]
  | Choice (c, a, b) -> List [ String "if"; json name c; json name a; json name b ]
  | Timed { operator; time; conditions } ->
      let time = List.map (fun n -> Json.String (name n)) (Option.to_list time) in
      List ((Json.String operator :: time) @ List.map (json name) conditions)

let to_json name formula = Json.to_string (json name formula)
