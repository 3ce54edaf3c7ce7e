open Basis

let instance ~at class_ =
  Diagnostic.error ~code:"E0366" ~at "you cannot declare an instance of `%s`" class_
  |> Diagnostic.note
       "the compiler already compares all values by structure, except those that contain functions"
  |> Diagnostic.hint "remove the instance"
