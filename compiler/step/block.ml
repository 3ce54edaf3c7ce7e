type t = { bytes : int; alignment : int }

let of_members members =
  let place (offsets, whole) member =
    let offset = Basis.Saturating_int.round_up whole.bytes ~alignment:member.alignment in
    let bytes = Basis.Saturating_int.add offset member.bytes in
    (offset :: offsets, { bytes; alignment = max whole.alignment member.alignment })
  in
  let offsets, { bytes; alignment } =
    List.fold_left place ([], { bytes = 0; alignment = 1 }) members
  in
  (List.rev offsets, { bytes = Basis.Saturating_int.round_up bytes ~alignment; alignment })

let of_alternatives blocks =
  let either a b = { bytes = max a.bytes b.bytes; alignment = max a.alignment b.alignment } in
  let { bytes; alignment } = List.fold_left either { bytes = 0; alignment = 1 } blocks in
  { bytes = Basis.Saturating_int.round_up bytes ~alignment; alignment }

let scalar bytes = { bytes; alignment = bytes }
let foreign = { bytes = 0; alignment = 8 }

(* A block of this many identical members, one after another. *)
let run count member = { member with bytes = Basis.Saturating_int.times count member.bytes }

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
          (1, scalar 1);
          (slots.floats, scalar (Basis.Real.bytes real));
          (slots.ints, scalar 4);
          (slots.bools, scalar 1);
          (slots.tags, scalar 1);
        ]
        @ List.map (fun (ty, count) -> (count, of_value real sums (Layout.ty ty))) slots.arrays
      in
      let present = List.filter (fun (count, _) -> count > 0) runs in
      snd (of_members (List.map (fun (count, member) -> run count member) present))

(* The total of [of_slots] over all sums and [of_scalar] over all other scalars. Each element of an
   array counts. *)
let rec count sums ~of_slots ~of_scalar (ty : Ir.ty) =
  match ty with
  | Bool | Int | Float | Nanoseconds | Foreign _ -> of_scalar ty
  | Array (n, element) -> Basis.Saturating_int.times n (count sums ~of_slots ~of_scalar element)
  | Sum k ->
      let slots = Layout.sum sums k in
      let array (ty, n) =
        Basis.Saturating_int.times n (count sums ~of_slots ~of_scalar (Layout.ty ty))
      in
      List.fold_left Basis.Saturating_int.add (of_slots slots) (List.map array slots.arrays)

let scalars sums =
  let of_slots (s : Layout.slots) = 1 + s.floats + s.ints + s.bools + s.tags in
  count sums ~of_slots ~of_scalar:(fun _ -> 1)

let numbers sums =
  let of_slots (s : Layout.slots) = s.floats in
  count sums ~of_slots ~of_scalar:(fun ty -> if ty = Float then 1 else 0)
