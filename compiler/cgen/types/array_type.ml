open Ir

let name (sums : Flow.Ir.sum array) (ty : Step.Ir.ty) =
  let rec base (ty : Step.Ir.ty) =
    match ty with
    | Array (_, element) -> base element
    | Bool -> "bool"
    | Int -> "int"
    | Float -> "float"
    | Nanoseconds -> "time"
    | Sum k -> Name.snake sums.(k).name
    | Foreign f -> Name.snake f.foreign_name
  in
  let rec sizes (ty : Step.Ir.ty) =
    match ty with
    | Array (n, element) -> string_of_int n :: sizes element
    | Bool | Int | Float | Nanoseconds | Sum _ | Foreign _ -> []
  in
  String.concat "_" (base ty :: sizes ty)

let element array index =
  let elements =
    match array with
    | Unary (Dereference, pointer) -> Arrow (pointer, "at")
    | array -> Member (array, "at")
  in
  Subscript (elements, index)

let definition name ~count ~element =
  Struct_definition
    {
      name;
      overlaid = false;
      members = [ { name = "at"; ty = Array (element, count); comment = "" } ];
      comment = "";
    }

type operation = At | Replace | Fill

let operations = [ At; Replace; Fill ]
let suffix = function At -> "at" | Replace -> "replace" | Fill -> "fill"
let plain desc : statement = { desc; comment = "" }

let function_ operation name ~struct_name ~count ~element:ty =
  let array = Struct struct_name in
  let size = Integer (Int32.of_int count) in
  let index = Name "index" in
  let inside = Binary (And, Binary (Less_equal, Integer 0l, index), Binary (Less, index, size)) in
  let given = Unary (Dereference, Name "array") in
  let own = element (Name "result") in
  let result, parameters, body =
    match operation with
    | At ->
        let chosen = Conditional (inside, element given (Name "index"), Name "otherwise") in
        ( ty,
          [ (Pointer_to_const array, "array"); (Int32, "index"); (ty, "otherwise") ],
          [ Return chosen ] )
    | Replace ->
        let then_ = [ plain (Assign (own (Name "index"), Name "element")) ] in
        ( array,
          [ (Pointer_to_const array, "array"); (Int32, "index"); (ty, "element") ],
          [
            Variable { ty = array; name = "result"; value = given };
            If { condition = inside; then_; else_ = [] };
            Return (Name "result");
          ] )
    | Fill ->
        let body = [ plain (Assign (own (Name "i"), Name "element")) ] in
        ( array,
          [ (ty, "element") ],
          [
            Variables { ty = array; names = [ "result" ] };
            For { index = "i"; count; body };
            Return (Name "result");
          ] )
  in
  { linkage = Static_inline; result; name; parameters; body = List.map plain body; comment = "" }
