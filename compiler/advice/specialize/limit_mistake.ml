open Basis
open Specialize

let each_combination =
  "frobc makes a separate copy for each combination of types, functions and signal functions in \
   the arguments, but not for different numbers"

let repeat_a_task =
  "repeat a task with `repeatT n`, `whileT` or `forever`, which use one mode for all repetitions"

let specializations ~at ~name ~limit (inside : Limit_fact.machine option) =
  let d =
    Diagnostic.error ~code:"E0413" ~at "`%s` is specialized for more than %d different arguments"
      name limit
  in
  (match inside with
  | Some { of_; modes } ->
      Diagnostic.note
        "the state machine of `%s` already has %d modes: one for each combination of a task or \
         signal function and everything that can follow it"
        of_ modes d
      |> Diagnostic.hint "%s" repeat_a_task
  | None -> Diagnostic.note "%s" each_combination d)
  |> Diagnostic.hint "to allow more, use the option `--specialization-limit`"

let elements ~at ~numbers ~by =
  Diagnostic.(
    error ~code:"E0413" ~at "an array of %s functions or signal functions is too large to compile"
      (String.concat " times " (List.map string_of_int numbers))
    |> here "`%s` needs a separate copy of each element here" by
    |> note
         "an array of numbers is computed in a loop, but each function or signal function in an \
          array gets its own code"
    |> hint
         "make the array shorter, or run one signal function on an array of numbers: `mapSF f xs`")

let modes ~at ({ of_; modes } : Limit_fact.machine) =
  Diagnostic.(
    error ~code:"E0413" ~at "the state machine of `%s` has too many modes: more than %d" of_ modes
    |> note
         "each combination of a task or signal function and everything that can follow it needs \
          its own mode"
    |> hint "%s" repeat_a_task)

let wide ~at (ty : Core.Ir.ty) ~leaves ~uses =
  let type_name =
    match ty with
    | Data (tycon, _) -> Printf.sprintf "type `%s`" tycon.name
    | _ -> "same tuple type"
  in
  Diagnostic.(
    error ~code:"E0413" ~at "more than %d equations and calls define values of the %s" uses
      type_name
    |> note "each of these values consists of %d numbers, and each number gets its own equation"
         leaves
    |> hint "change several fields at once: `r { a = 1, b = 2 }`"
    |> hint "keep many numbers of one type in an array: `Array 1000 Float` is one value")

let copies ~at ~name ~copies =
  Diagnostic.(
    error ~code:"E0413" ~at "frobc makes too many copies of `%s`: more than %d" name copies
    |> note "%s" each_combination
    |> hint "pass the same functions each time; only numbers may change")

let work ~at (definition : Core.Ir.definition) most_called =
  (match most_called with
  | Some (name, calls) when calls > 1 ->
      Diagnostic.error ~code:"E0413" ~at
        "compiling takes too much work: `%s` is called more than %d times at compile time" name
        calls
  | Some _ | None ->
      Diagnostic.error ~code:"E0413" ~at "compiling `%s` takes too much work" definition.name.name)
  |> Diagnostic.note
       "frobc evaluates a call at compile time if its result or an argument is a function or \
        signal function; if each function calls the next one twice, every level of calls doubles \
        the work"
  |> Diagnostic.hint
       "nest the calls less deeply, or name a result and use the name twice instead of repeating \
        the call"

let name_of : Core.Ir.ty -> string = function
  | Data (tycon, _) -> Printf.sprintf "the type `%s`" tycon.name
  | _ -> "a tuple"

let leaves ~at ty ~limit =
  Diagnostic.(
    error ~code:"E0316" ~at "a value of %s would contain more than %d numbers" (name_of ty) limit
    |> hint "use an array for many values of one type: `Array 1000 Float`")

let data_nested ~at ty ~limit =
  Diagnostic.(
    error ~code:"E0316" ~at "a value of %s would contain data nested more than %d levels deep"
      (name_of ty) limit
    |> hint "nest the records less deeply")

let functions_nested ~at (definition : Core.Ir.definition) =
  Diagnostic.(
    error ~code:"E0413" ~at "`%s` needs functions that are nested too deeply" definition.name.name
    |> note
         "the functions or signal functions form a chain of thousands, and each contains the \
          previous one"
    |> hint "compose fewer of them, or write one signal function that does the same")

let diagnostic ({ at; calls; excess } : Limit_fact.t) =
  Shown_calls.label calls
    (match excess with
    | Calls_nested limit ->
        Diagnostic.error ~code:"E0413" ~at "calls are nested more than %d levels deep" limit
    | Specializations { name; limit; inside } -> specializations ~at ~name ~limit inside
    | Elements { numbers; by } -> elements ~at ~numbers ~by
    | Modes machine -> modes ~at machine
    | Wide { ty; leaves; uses } -> wide ~at ty ~leaves ~uses
    | Copies { name; copies = most } -> copies ~at ~name ~copies:most
    | Work { definition; most_called } -> work ~at definition most_called
    | Leaves { ty; limit } -> leaves ~at ty ~limit
    | Data_nested { ty; limit } -> data_nested ~at ty ~limit
    | Functions_nested definition -> functions_nested ~at definition)
