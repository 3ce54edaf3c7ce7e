type t = { count : int; operations : int; share : float; bytes : int }

let operations (t : Bounds.t) =
  let step = t.operations.step in
  let kinds = List.map (fun (_, kind) -> Cost.count step kind) Bounds.operations in
  List.fold_left ( + ) 0 (kinds @ List.map snd (Cost.calls step))

let bytes (t : Bounds.t) = (State.definition t.state (State.root t.state)).bytes

let of_programs ~(plain : Bounds.t) ~(watched : Bounds.t) =
  let without = operations plain in
  let more = operations watched - without in
  {
    count = List.length watched.program.claims;
    operations = more;
    share = float_of_int more /. float_of_int (max 1 without);
    bytes = bytes watched - bytes plain;
  }
