open Basis

let error at format = Diagnostic.error ~code:"E0507" ~at format
let quoted = List.map (Printf.sprintf "`%s`")

let diagnostic ~name ~at : Resolve.Fact.setting -> Diagnostic.t = function
  | No_parameter { known } ->
      let d = error at "the program has no parameter `%s`" name in
      Diagnostic.note "%s"
        (if known = [] then
           "the program has no parameters; declare one with `param NAME :: TYPE = VALUE`"
         else
           "the program's parameters: "
           ^ Enumeration.all (quoted (List.sort_uniq String.compare known)))
        d
      |> Option.fold (Suggest.closest name known) ~none:Fun.id ~some:(fun near ->
             Diagnostic.hint "did you mean `%s`?" near)
  | Several_modules { qualified } ->
      error at "several modules have a parameter `%s`" name
      |> Diagnostic.hint "qualify the parameter with the name of its module: %s"
           (Enumeration.one_of (quoted qualified))
  | Invalid_value { value } ->
      error at "`%s` is not an expression" value
      |> Diagnostic.hint "write the value as in `--param %s=5`" name
