type t = { bytes : int; alignment : int }

let of_members members =
  let place (offsets, whole) member =
    let offset = Amount.round_up whole.bytes ~alignment:member.alignment in
    let bytes = Amount.add offset member.bytes in
    (offset :: offsets, { bytes; alignment = max whole.alignment member.alignment })
  in
  let offsets, { bytes; alignment } =
    List.fold_left place ([], { bytes = 0; alignment = 1 }) members
  in
  (List.rev offsets, { bytes = Amount.round_up bytes ~alignment; alignment })

let of_alternatives blocks =
  let either a b = { bytes = max a.bytes b.bytes; alignment = max a.alignment b.alignment } in
  let { bytes; alignment } = List.fold_left either { bytes = 0; alignment = 1 } blocks in
  { bytes = Amount.round_up bytes ~alignment; alignment }

let scalar bytes = { bytes; alignment = bytes }

let foreign = { bytes = 0; alignment = Machine.Layout.largest_alignment }

(* Members one after another, all alike. *)
let run count member = { member with bytes = Amount.times count member.bytes }

let rec of_value real sums (ty : Machine.Ir.ty) =
  match ty with
  | Bool -> scalar 1
  | Int -> scalar 4
  | Float -> scalar (Basis.Real.bytes real)
  | Nanoseconds -> scalar 8
  | Array (n, element) -> run n (of_value real sums element)
  | Foreign { copyable = true; _ } -> foreign
  | Foreign { copyable = false; _ } -> scalar 8
  | Sum k ->
      let slots = Machine.Layout.sum sums k in
      let runs =
        [
          (1, scalar 1); (slots.floats, scalar (Basis.Real.bytes real)); (slots.ints, scalar 4); (slots.bools, scalar 1);
          (slots.tags, scalar 1);
        ]
        @ List.map
            (fun (ty, count) -> (count, of_value real sums (Machine.Layout.ty ty)))
            slots.arrays
      in
      let present = List.filter (fun (count, _) -> count > 0) runs in
      snd (of_members (List.map (fun (count, member) -> run count member) present))

let rec scalars sums (ty : Machine.Ir.ty) =
  match ty with
  | Bool | Int | Float | Nanoseconds | Foreign _ -> 1
  | Array (n, element) -> Amount.times n (scalars sums element)
  | Sum k ->
      let slots = Machine.Layout.sum sums k in
      let arrays =
        List.fold_left
          (fun sum (ty, count) ->
            Amount.add sum (Amount.times count (scalars sums (Machine.Layout.ty ty))))
          0 slots.arrays
      in
      Amount.add arrays (1 + slots.floats + slots.ints + slots.bools + slots.tags)

let rec numbers sums (ty : Machine.Ir.ty) =
  match ty with
  | Float -> 1
  | Bool | Int | Nanoseconds | Foreign _ -> 0
  | Array (n, element) -> Amount.times n (numbers sums element)
  | Sum k ->
      let slots = Machine.Layout.sum sums k in
      let slot (ty, count) = Amount.times count (numbers sums (Machine.Layout.ty ty)) in
      List.fold_left Amount.add slots.floats (List.map slot slots.arrays)
