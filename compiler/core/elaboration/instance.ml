open Basis

let bug format = Diagnostic.bug ~stage:"Core.Instance" format

(* A type constructor, as the key of an instance. *)
type head =
  | Data_head of Ir.Global.t
  | Bool_head
  | Int_head
  | Float_head
  | String_head
  | Tuple_head of int
  | Function_head
  | Signal_function_head
  | Array_head

type table = (Ir.Global.t * head, Ir.instance) Hashtbl.t

let split : Ir.ty -> (head * Ir.ty list) option = function
  | Variable _ | Size _ -> None
  | Bool -> Some (Bool_head, [])
  | Int -> Some (Int_head, [])
  | Float -> Some (Float_head, [])
  | String -> Some (String_head, [])
  | Tuple parts -> Some (Tuple_head (List.length parts), parts)
  | Function (a, b) -> Some (Function_head, [ a; b ])
  | Signal_function (a, b) -> Some (Signal_function_head, [ a; b ])
  | Data (tycon, arguments) -> Some (Data_head tycon, arguments)
  | Array (size, element) -> Some (Array_head, [ size; element ])

let table instances =
  let table = Hashtbl.create 64 in
  List.iter
    (fun (i : Ir.instance) ->
      match split i.head with
      | Some (head, _) -> Hashtbl.replace table (i.class_, head) i
      | None -> bug "the instance of `%s` is for a type variable" i.class_.name)
    instances;
  table

let find table ~class_ ~name ty types =
  match split ty with
  | None -> None
  | Some (head, arguments) -> (
      let missing () =
        bug "the method `%s` of class `%s` has no definition for a type" name class_.Ir.Global.name
      in
      match Hashtbl.find_opt table (class_, head) with
      | None -> missing ()
      | Some (i : Ir.instance) -> (
          match List.assoc_opt name i.methods with
          | Some (Ir.Given definition) -> Some (definition, arguments @ types)
          | Some (Ir.Default definition) -> Some (definition, ty :: types)
          | None -> missing ()))
