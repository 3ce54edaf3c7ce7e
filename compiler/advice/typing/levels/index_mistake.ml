open Basis
open Typing
open Typing.Ir

let not_constant sources ?array (e : expr) (problem : Level_fact.problem) =
  let error at format = Diagnostic.error ~code:"E0347" ~at format in
  let index = match e.desc with Local (x, _) -> x.name | Global (g, _) -> g.name | _ -> "i" in
  (match problem with
  | Variable (x, at) ->
      error at "the index of `!` must be constant, but `%s` is not" x.name
      |> Diagnostic.label ~at:x.span "`%s` is bound here" x.name
  | Param (p, at) ->
      error at
        "the index of `!` must be constant, but the parameter `%s` is only known when the program \
         starts"
        p.name
  | Computed at when Span.compare at e.span = 0 -> error at "the index of `!` must be constant"
  | Computed at ->
      error e.span "the index of `!` must be constant" |> Diagnostic.label ~at "this is computed")
  |> Diagnostic.note "an index can be a number, the name of a constant, or arithmetic on these"
  |> Diagnostic.hint "%s"
       (let quoted = Option.bind array (fun (a : expr) -> Source.quote sources a.span) in
        let index = Option.value (Source.quote sources e.span) ~default:index in
        let missing =
          match Option.map (fun (a : expr) -> a.ty) array with
          | Some (Data { arguments = [ _; Number _ ]; _ }) -> "0"
          | Some (Data { arguments = [ _; Bool ]; _ }) -> "False"
          | _ -> "x"
        in
        match quoted with
        | Some array when String.length array + String.length index < 60 ->
            Printf.sprintf
              "use `at %s %s %s`, which takes any index and returns `%s` if there is no such \
               element"
              (Source.grouped index) missing (Source.grouped array) missing
        | _ ->
            Printf.sprintf
              "use `at %s x xs`, which takes any index and returns `x` if there is no such element"
              (Source.grouped index))

let outside sources ~(array : expr) ~(index : expr) value ~size =
  let error format = Diagnostic.error ~code:"E0332" ~at:index.span format in
  match size with
  | Some n ->
      error "index %d is out of range for an array of %d elements" value n
      |> Diagnostic.label ~at:array.span "this is `%s`" (Show.ty array.ty)
      |> Diagnostic.hint "%s"
           (if n = 1 then "its only element has index 0"
            else
              let array =
                match Source.quote sources array.span with
                | Some text when String.length text < 40 -> text
                | Some _ | None -> "xs"
              in
              Printf.sprintf "the first element is `%s ! 0`, the last `%s ! %d`%s" array array
                (n - 1)
                (if value = n then "; check the other indices too" else ""))
  | None ->
      error "index %d is out of range for every array" value |> Diagnostic.hint "indices start at 0"
