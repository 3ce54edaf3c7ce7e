open Basis
open Typing

let method_without_variable (method_ : Resolve.Ir.method_) (variable : Ir.variable) =
  Diagnostic.error ~code:"E0364" ~at:method_.span
    "the type of the method `%s` does not contain `%s`" method_.name.name variable.name
  |> Diagnostic.label ~at:method_.scheme.ty.span "nothing here determines the instance"

let constrained_variable (c : Resolve.Ir.constraint_) (variable : Ir.variable) =
  Diagnostic.error ~code:"E0365" ~at:c.span
    "the context of a method cannot constrain the class's own variable `%s`" variable.name
  |> Diagnostic.hint "make `%s` a superclass" c.class_.name

let instance_head words (instance : Resolve.Ir.instance) head =
  let diagnostic =
    Diagnostic.error ~code:"E0362" ~at:instance.head.span
      "the head of an instance must be a type constructor applied to distinct variables, not %s"
      (Wording.quoted words head)
  in
  let diagnostic =
    match Type.repr head with
    | Alias { expansion; _ } ->
        Diagnostic.note "this is a synonym for %s" (Wording.quoted words expansion) diagnostic
    | _ -> diagnostic
  in
  match Type.expand head with
  | Number ((Int | Float), _) | Data { units = _ :: _; _ } ->
      Diagnostic.note "a unit cannot select an instance" diagnostic
      |> Diagnostic.hint "write a unit variable, as in `Float[u]`"
  | Number _ ->
      Diagnostic.hint "write an instance for `Int[u]` and another for `Float[u]`" diagnostic
  | _ -> diagnostic

let shown words (instance : Resolve.Ir.instance) head =
  Wording.constraint_ words (Ir.Declared instance.class_) head

let second_instance words (instance : Resolve.Ir.instance) head ~first =
  Diagnostic.error ~code:"E0361" ~at:instance.span "there are two `%s` instances"
    (shown words instance head)
  |> Diagnostic.label ~at:first "the first one is here"
  |> Diagnostic.note "a class can have only one instance for each type constructor"

let missing_methods words (instance : Resolve.Ir.instance) head missing =
  let all shown = Enumeration.all (List.map (fun ((m : Ir.Global.t), _) -> shown m.name) missing) in
  let label diagnostic ((m : Ir.Global.t), at) =
    Diagnostic.label ~at "`%s` has no default" m.name diagnostic
  in
  let error =
    Diagnostic.error ~code:"E0363" ~at:instance.span "the instance `%s` does not define %s"
      (shown words instance head)
      (all (Printf.sprintf "`%s`"))
  in
  List.fold_left label error missing
  |> Diagnostic.hint "below the `where` of the instance, define %s"
       (all (Printf.sprintf "`%s = …`"))
