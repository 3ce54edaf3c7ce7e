type kind =
  | Additions
  | Multiplications
  | Divisions
  | Choices
  | Conversions
  | Calls of string
  | Pixels of string
  | Images of string
  | Loads
  | Stores

module Kinds = Map.Make (struct
  type t = kind

  let compare = Stdlib.compare
end)

(* Kinds of operations that do not occur are not in the map. *)
type t = int Kinds.t

let none = Kinds.empty
let several n kind = if n = 0 then none else Kinds.singleton kind n
let one kind = several 1 kind
let combine f = Kinds.union (fun _ a b -> Some (f a b))
let add = combine Basis.Saturating_int.add
let sum = List.fold_left add none
let larger = combine max
let times n t = if n = 0 then none else Kinds.map (Basis.Saturating_int.times n) t
let count t kind = Option.value (Kinds.find_opt kind t) ~default:0

let calls t =
  List.filter_map
    (fun (kind, n) ->
      match kind with
      | Calls name -> Some (name, n)
      | Pixels _ | Images _ | Additions | Multiplications | Divisions | Choices | Conversions
      | Loads | Stores ->
          None)
    (Kinds.bindings t)
