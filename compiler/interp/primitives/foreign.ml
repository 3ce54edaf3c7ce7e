let bug format = Basis.Diagnostic.bug ~stage:"Interp.Foreign" format

(* The layout of a type in C. *)
type layout =
  | Truth
  | Whole
  | Number
  | Picture
  | Parts of { record : bool; parts : layout list }
  | Elements of int * layout

let rec layout (program : Core.Ir.program) (ty : Core.Ir.ty) =
  match ty with
  | Bool -> Truth
  | Int -> Whole
  | Float -> Number
  | Tuple parts -> Parts { record = false; parts = List.map (layout program) parts }
  | Array (Size n, element) -> Elements (n, layout program element)
  | Data (tycon, arguments) -> (
      let is_it (d : Core.Ir.data) = d.tycon = tycon in
      let is_foreign (t : Core.Ir.foreign_type) = t.foreign_type = tycon in
      match (List.find_opt is_it program.data, List.exists is_foreign program.foreign.types) with
      | _, true -> Picture
      | Some { constructors = [ { fields; _ } ]; parameters; _ }, false ->
          let close = Core.Erasure.substitute (List.combine parameters arguments) in
          let part (_, ty) = layout program (close ty) in
          Parts { record = true; parts = List.map part fields }
      | _, _ -> bug "a kernel takes or returns the sum type `%s`" tycon.name)
  | Variable _ | String | Function _ | Signal_function _ | Array _ | Size _ ->
      bug "a kernel argument that is not a plain value"

let rec alignment = function
  | Truth -> 1
  | Whole -> 4
  | Number | Picture -> 8
  | Parts { parts; _ } -> List.fold_left (fun most part -> max most (alignment part)) 1 parts
  | Elements (_, element) -> alignment element

let aligned at layout =
  let unit_ = alignment layout in
  (at + unit_ - 1) / unit_ * unit_

(* Size in bytes, including the padding that C adds at the end of a struct. *)
let rec size = function
  | Truth -> 1
  | Whole -> 4
  | Number | Picture -> 8
  | Parts { parts; _ } as whole ->
      aligned (List.fold_left (fun at part -> aligned at part + size part) 0 parts) whole
  | Elements (count, element) -> count * size element

(* Calls [f part offset] for each part, from the first to the last. *)
let places at parts f =
  let next (at, results) part =
    let at = aligned at part in
    (at + size part, f part at :: results)
  in
  List.rev (snd (List.fold_left next (at, []) parts))

let rec write bytes at layout (value : Value.t) =
  match (layout, value) with
  | Truth, Bool b -> Bytes.set_uint8 bytes at (Bool.to_int b)
  | Whole, Int n -> Bytes.set_int32_ne bytes at n
  | Number, Float x -> Bytes.set_int64_ne bytes at (Int64.bits_of_float x)
  | Parts { parts; _ }, (Tuple values | Data { arguments = values; _ }) ->
      write_all bytes at parts values
  | Elements (count, element), Array values ->
      write_all bytes at (List.init count (fun _ -> element)) values
  | (Truth | Whole | Number | Picture | Parts _ | Elements _), _ ->
      bug "an argument of an unexpected type"

and write_all bytes at parts values =
  let places = places at parts (fun part at -> (part, at)) in
  List.iteri (fun i (part, at) -> write bytes at part (Thunk.force values.(i))) places

let rec read real bytes at layout : Value.t =
  match layout with
  | Truth -> Bool (Bytes.get_uint8 bytes at <> 0)
  | Whole -> Int (Bytes.get_int32_ne bytes at)
  | Number -> Float (Basis.Real.round real (Int64.float_of_bits (Bytes.get_int64_ne bytes at)))
  | Parts { record; parts } ->
      let values = read_all real bytes at parts in
      if record then Data { constructor = 0; arguments = values } else Tuple values
  | Elements (count, element) -> Array (read_all real bytes at (List.init count (fun _ -> element)))
  | Picture -> bug "a kernel that returns an image"

and read_all real bytes at parts =
  Array.of_list (places at parts (fun part at -> Thunk.known (read real bytes at part)))

let argument layout value : Kernels.argument =
  match (layout, (value : Value.t)) with
  | Picture, Image image -> Image image
  | _, value ->
      let bytes = Bytes.make (size layout) '\000' in
      write bytes 0 layout value;
      Struct bytes

let apply (program : Core.Ir.program) (f : Core.Primitive.foreign) arguments =
  let rec call (ty : Core.Ir.ty) arguments found =
    match (ty, arguments) with
    | Function (a, b), first :: others ->
        call b others (argument (layout program a) (Thunk.force first) :: found)
    | result, [] ->
        let result = layout program result in
        let bytes = Kernels.call f.symbol (List.rev found) ~size:(size result) in
        read program.real bytes 0 result
    | _, _ :: _ -> bug "`%s` has more arguments than its type" f.foreign_name
  in
  call (List.assoc f program.foreign.values) arguments []
