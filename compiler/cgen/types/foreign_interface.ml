module F = Flow.Ir

type passing =
  | Nothing
  | Value of Ir.ty
  | Address of Ir.ty
  | Elements of Ir.ty
  | Struct of Interface.t

type t = { symbol : string; form : form }

and form =
  | Function of { arguments : passing list; result : passing }
  | Component of { input : Interface.t; output : Interface.t }

let state symbol = symbol ^ "_state"
let reset symbol = symbol ^ "_reset"
let step symbol = symbol ^ "_step"

let passing types ~fresh name (shape : F.shape) =
  match shape with
  | _ when Flow.Shape.leaves shape = [] -> Nothing
  | Leaf ((Bool | Int | Float | Foreign { copyable = false; _ }) as ty) ->
      Value (Interface.leaf_type types ty)
  | Leaf ((Sum _ | Foreign { copyable = true; _ }) as ty) -> Address (Interface.leaf_type types ty)
  | Repeated (_, Leaf ((Bool | Int | Float) as ty)) -> Elements (Interface.leaf_type types ty)
  | Leaf (Array _) | Repeated _ | Product _ ->
      Struct (Interface.of_type types ~name:(fun () -> fresh name) shape)

let letter k =
  if k < 26 then String.make 1 (Char.chr (Char.code 'a' + k)) else Printf.sprintf "a%d" k

let of_import types ~fresh (f : F.import) =
  let form =
    match f.kind with
    | Function ->
        let argument k = passing types ~fresh (Printf.sprintf "%s_%s" f.symbol (letter k)) in
        let arguments = List.mapi argument f.arguments in
        Function { arguments; result = passing types ~fresh (f.symbol ^ "_result") f.result }
    | Signal_function ->
        let interface suffix =
          Interface.of_shape types ~units:Units.unknown ~name:(f.symbol ^ suffix)
        in
        let input =
          match f.arguments with
          | [ shape ] -> interface "_input" shape
          | [] | _ :: _ :: _ ->
              Basis.Diagnostic.bug ~stage:"Cgen.Foreign_interface" "a component must have one input"
        in
        Component { input; output = interface "_output" f.result }
  in
  { symbol = f.symbol; form }

let prototype ~result name parameters : Ir.function_ =
  { linkage = External; result; name; parameters; body = []; comment = "" }

let prototypes t =
  match t.form with
  | Component { input; output } ->
      let self = (Ir.Pointer (Struct (state t.symbol)), "self") in
      [
        prototype ~result:Void (reset t.symbol) [ self ];
        prototype ~result:Void (step t.symbol)
          [
            self;
            (Real Double, "dt");
            (Pointer_to_const (Struct input.struct_name), "in");
            (Pointer (Struct output.struct_name), "out");
          ];
      ]
  | Function { arguments; result } ->
      let argument k passing =
        let name = letter k in
        match passing with
        | Nothing -> []
        | Value ty -> [ (ty, name) ]
        | Address ty | Elements ty -> [ (Ir.Pointer_to_const ty, name) ]
        | Struct i -> [ (Pointer_to_const (Struct i.struct_name), name) ]
      in
      let given = List.concat (List.mapi argument arguments) in
      let to_result ty = [ (Ir.Pointer ty, "result") ] in
      let returned, last =
        match result with
        | Nothing -> (Ir.Void, [])
        | Value ty -> (ty, [])
        | Address ty | Elements ty -> (Void, to_result ty)
        | Struct i -> (Void, to_result (Struct i.struct_name))
      in
      [ prototype ~result:returned t.symbol (given @ last) ]
