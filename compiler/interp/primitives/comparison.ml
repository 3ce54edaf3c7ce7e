let refuse () = Basis.Diagnostic.bug ~stage:"Interp" "values that are not comparable are compared"

(* Pairs the corresponding parts of two values of the same type, from first to last. *)
let pairs a b = List.combine (Array.to_list a) (Array.to_list b)

(* Drawings compare as equal, because they do not influence what a program does. So do values of
   type [Text], because they occur only in drawings. *)
let rec equal (a : Value.t) (b : Value.t) =
  match (a, b) with
  | Bool a, Bool b -> Bool.equal a b
  | Int a, Int b -> Int32.equal a b
  | Float a, Float b -> a = b
  | Text _, Text _ | Drawing _, Drawing _ -> true
  | Tuple a, Tuple b | Array a, Array b -> List.for_all equal_parts (pairs a b)
  | Data a, Data b ->
      a.constructor = b.constructor && List.for_all equal_parts (pairs a.arguments b.arguments)
  | ( ( Bool _ | Int _ | Float _ | Text _ | Drawing _ | Image _ | Tuple _ | Array _ | Data _
      | Function _ | Signal_function _ | Task _ | Ending _ ),
      _ ) ->
      refuse ()

and equal_parts (a, b) = equal (Thunk.force a) (Thunk.force b)

(* [numbers] compares two numbers; [equals] is the result if all parts are equal. *)
let rec ordered ~numbers ~equals (a : Value.t) (b : Value.t) =
  match (a, b) with
  | Bool a, Bool b -> if Bool.equal a b then equals else b
  | Int a, Int b -> if Int32.equal a b then equals else Int32.compare a b < 0
  | Float a, Float b -> numbers a b
  | Text _, Text _ | Drawing _, Drawing _ -> equals
  | Tuple a, Tuple b | Array a, Array b -> ordered_parts ~numbers ~equals (pairs a b)
  | Data a, Data b ->
      if a.constructor = b.constructor then
        ordered_parts ~numbers ~equals (pairs a.arguments b.arguments)
      else a.constructor < b.constructor
  | ( ( Bool _ | Int _ | Float _ | Text _ | Drawing _ | Image _ | Tuple _ | Array _ | Data _
      | Function _ | Signal_function _ | Task _ | Ending _ ),
      _ ) ->
      refuse ()

(* Compares the last parts directly, without testing them for equality first, because a NaN is not
   [<=] another NaN. *)
and ordered_parts ~numbers ~equals = function
  | [] -> equals
  | [ (a, b) ] -> ordered ~numbers ~equals (Thunk.force a) (Thunk.force b)
  | (a, b) :: others ->
      let a = Thunk.force a and b = Thunk.force b in
      less a b || (equal a b && ordered_parts ~numbers ~equals others)

and less a b = ordered ~numbers:( < ) ~equals:false a b

let less_equal a b = ordered ~numbers:( <= ) ~equals:true a b
