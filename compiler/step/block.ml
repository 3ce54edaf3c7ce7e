type t = { bytes : int; alignment : int }

let of_members members =
  let place (offsets, whole) member =
    let offset = Basis.Amount.round_up whole.bytes ~alignment:member.alignment in
    let bytes = Basis.Amount.add offset member.bytes in
    (offset :: offsets, { bytes; alignment = max whole.alignment member.alignment })
  in
  let offsets, { bytes; alignment } =
    List.fold_left place ([], { bytes = 0; alignment = 1 }) members
  in
  (List.rev offsets, { bytes = Basis.Amount.round_up bytes ~alignment; alignment })

let of_alternatives blocks =
  let either a b = { bytes = max a.bytes b.bytes; alignment = max a.alignment b.alignment } in
  let { bytes; alignment } = List.fold_left either { bytes = 0; alignment = 1 } blocks in
  { bytes = Basis.Amount.round_up bytes ~alignment; alignment }

let scalar bytes = { bytes; alignment = bytes }

let foreign = { bytes = 0; alignment = Layout.largest_alignment }

(* Members one after another, all alike. *)
let run count member = { member with bytes = Basis.Amount.times count member.bytes }

let rec of_value real sums (ty : Ir.ty) =
  match ty with
  | Bool -> scalar 1
  | Int -> scalar 4
  | Float -> scalar (Basis.Real.bytes real)
  | Nanoseconds -> scalar 8
  | Array (n, element) -> run n (of_value real sums element)
  | Foreign { copyable = true; _ } -> foreign
  | Foreign { copyable = false; _ } -> scalar 8
  | Sum k ->
      let slots = Layout.sum sums k in
      let runs =
        [
          (1, scalar 1); (slots.floats, scalar (Basis.Real.bytes real)); (slots.ints, scalar 4);
          (slots.bools, scalar 1);
          (slots.tags, scalar 1);
        ]
        @ List.map
            (fun (ty, count) -> (count, of_value real sums (Layout.ty ty)))
            slots.arrays
      in
      let present = List.filter (fun (count, _) -> count > 0) runs in
      snd (of_members (List.map (fun (count, member) -> run count member) present))

let rec scalars sums (ty : Ir.ty) =
  match ty with
  | Bool | Int | Float | Nanoseconds | Foreign _ -> 1
  | Array (n, element) -> Basis.Amount.times n (scalars sums element)
  | Sum k ->
      let slots = Layout.sum sums k in
      let arrays =
        List.fold_left
          (fun sum (ty, count) ->
            Basis.Amount.add sum (Basis.Amount.times count (scalars sums (Layout.ty ty))))
          0 slots.arrays
      in
      Basis.Amount.add arrays (1 + slots.floats + slots.ints + slots.bools + slots.tags)

let rec numbers sums (ty : Ir.ty) =
  match ty with
  | Float -> 1
  | Bool | Int | Nanoseconds | Foreign _ -> 0
  | Array (n, element) -> Basis.Amount.times n (numbers sums element)
  | Sum k ->
      let slots = Layout.sum sums k in
      let slot (ty, count) = Basis.Amount.times count (numbers sums (Layout.ty ty)) in
      List.fold_left Basis.Amount.add slots.floats (List.map slot slots.arrays)
