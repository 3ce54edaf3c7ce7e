open Basis
open Typing

let compile_time = "functions, signal functions and labels exist only at compile time"

(* Why the value cannot be passed to or from C, and a hint. *)
let explain (obstacle : Declaration_fact.obstacle) =
  match obstacle with
  | Representation ->
      ("C has different functions for Int and Float", Some "write `Float[…]` or `Int[…]`")
  | Text -> (compile_time, Some "pass an `Int` that tells C which string you mean")
  | Compile_time -> (compile_time, None)
  | Type_of_c name ->
      let ty =
        match name with
        | "int" -> "`Int`"
        | "bool" -> "`Bool`"
        | _ -> "`Float`, which is a `double`"
      in
      ("a lower-case name is a type variable", Some ("write this C type as " ^ ty))
  | Several_types ->
      ( "a C function has one type",
        Some "import a separate C function for each type and size that you need" )

let refused (declared : Resolve.Ir.primitive) (refusal : Declaration_fact.refusal) =
  let name = declared.name.name in
  let error format = Diagnostic.error ~code:"E0380" ~at:declared.scheme.span format in
  match refusal with
  | Signal_function_with_parameters ->
      error "the foreign signal function `%s` cannot have parameters" name
      |> Diagnostic.hint "move the parameters into its input"
  | Not_a_signal_function ty ->
      error "`%s` is a foreign signal function, but `%s` is not a signal function type" name
        (Show.ty ty)
      |> Diagnostic.hint "declare a function without `sf`: `foreign %s :: %s = …`" name (Show.ty ty)
  | Signal_function ->
      error "`%s` has a signal function type, but is not declared with `sf`" name
      |> Diagnostic.hint "if it has state in C, declare it as `foreign sf %s :: …`" name
  | No_argument ty ->
      error "`%s` must have a function type, even if its C function takes no argument" name
      |> Diagnostic.hint "use `() -> %s`, and call it as `%s ()`" (Show.ty ty) name
  | Type_classes ->
      error "a foreign declaration cannot have class constraints"
      |> Diagnostic.hint "import a separate C function for each type that you need"
  | Not_passed { culprit; obstacle; to_c } ->
      let why, hint = explain obstacle in
      error "`%s` cannot %s C a value of type `%s`" name
        (if to_c then "give" else "take from")
        (Show.ty culprit)
      |> Diagnostic.note "%s" why
      |> Option.fold ~none:Fun.id ~some:(Diagnostic.hint "%s") hint

let imported_twice symbol ~(this : Declaration_fact.imported) ~(first : Declaration_fact.imported) =
  Diagnostic.error ~code:"E0381" ~at:this.at
    "the C function `%s` is imported here with the type `%s`" symbol (Show.ty this.ty)
  |> Diagnostic.label ~at:first.at "and here with the type `%s`" (Show.ty first.ty)
  |> Diagnostic.note "a C function has one type"
