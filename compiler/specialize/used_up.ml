open Basis

let error ~at format = Diagnostic.error ~code:"E0413" ~at format

(* The place in the program (not in the library), and the calls that led there. *)
let place (c : Context.t) trail ~span = Context.own_place c trail ~span

let array_too_long c trail ~at (expansions : Context.expansion list) =
  let numbers = List.rev_map (fun (e : Context.expansion) -> string_of_int e.elements) expansions in
  let innermost = List.hd expansions in
  error ~at "an array of %s functions or signal functions is too large to compile"
    (String.concat " times " numbers)
  |> Diagnostic.here (Printf.sprintf "`%s` compiles each of them separately here" innermost.by)
  |> Context.with_trail trail
  |> Diagnostic.note
       "an array of numbers is computed in a loop, but each function or signal function in an \
        array gets its own code"
  |> Diagnostic.hint
       "make the array shorter, or run one signal function on an array of numbers: `mapSF f xs`"
  |> Diagnostic.emit c.Context.sink

let machine_too_large (c : Context.t) trail ~at (m : Context.machine) =
  error ~at "the state machine of `%s` has too many modes: more than %d" m.of_ m.modes
  |> Context.with_trail trail
  |> Diagnostic.note
       "there is one mode for each combination of a task or signal function that can run and \
        everything that can follow it"
  |> Diagnostic.hint
       "repeat a task with `repeatT n`, `whileT` or `forever`, which use one mode for all \
        repetitions"
  |> Diagnostic.emit c.sink

let type_name : Core.Ir.ty -> string = function
  | Data (tycon, _) -> Printf.sprintf "type `%s`" tycon.name
  | _ -> "same tuple type"

let too_wide (c : Context.t) trail ~at (wide : Context.wide) =
  error ~at "more than %d equations and calls define values of the %s" wide.uses (type_name wide.ty)
  |> Context.with_trail trail
  |> Diagnostic.note
       (Printf.sprintf
          "each of these values consists of %d numbers, and each number gets its own equation"
          wide.leaves)
  |> Diagnostic.hint "change several fields at once: `r { a = 1, b = 2 }`"
  |> Diagnostic.hint "keep many numbers of one type in an array: `Array 1000 Float` is one value"
  |> Diagnostic.emit c.sink

let too_many_copies (c : Context.t) trail ~at (name, copies) =
  error ~at "frobc makes too many copies of `%s`: more than %d" name copies
  |> Context.with_trail trail
  |> Diagnostic.note
       "frobc makes a copy for each combination of types, functions and signal functions among the \
        arguments; numbers do not count"
  |> Diagnostic.hint "pass the same functions each time; numbers may change"
  |> Diagnostic.emit c.sink

let too_many_calls (c : Context.t) trail ~at (core : Core.Ir.definition) =
  (match Context.most_called c with
  | Some (name, calls) when calls > 1 ->
      error ~at "compiling takes too much work: `%s` is called more than %d times at compile time"
        name calls
  | Some _ | None -> error ~at "compiling `%s` takes too much work" core.name.name)
  |> Context.with_trail trail
  |> Diagnostic.note
       "frobc evaluates a call with a function or signal function as argument or result at compile \
        time; if each level calls the next one twice, every level doubles the work"
  |> Diagnostic.hint "use fewer levels of functions, or give a result a name and use the name twice"
  |> Diagnostic.emit c.sink

let report (c : Context.t) (core : Core.Ir.definition) =
  let trail = Context.latest c in
  let at = place c trail ~span:core.span in
  let large (e : Context.expansion) = e.elements > 1 in
  let modes (m : Context.machine) = m.modes in
  let most (best : Context.machine option) m =
    match best with Some other when modes other >= modes m -> best | Some _ | None -> Some m
  in
  match
    ( List.filter large (Context.expansions trail),
      List.fold_left most None (Context.machines trail),
      Context.most_specialized c )
  with
  | (_ :: _ as expansions), _, _
    when List.fold_left (fun n (e : Context.expansion) -> n * e.elements) 1 expansions > 5_000 ->
      let innermost = List.hd expansions in
      array_too_long c trail ~at:(place c trail ~span:innermost.at) expansions
  | _, Some machine, _ when machine.modes > 100 ->
      machine_too_large c trail ~at:(place c trail ~span:machine.place) machine
  | _, _, Some (name, copies) when copies > 1_000 -> too_many_copies c trail ~at (name, copies)
  | _, _, _ -> (
      match Context.widest c with
      | Some wide when wide.uses * wide.leaves > 100_000 -> too_wide c trail ~at wide
      | Some _ | None -> too_many_calls c trail ~at core)

let name_of : Core.Ir.ty -> string = function
  | Data (tycon, _) -> Printf.sprintf "the type `%s`" tycon.name
  | _ -> "a tuple"

let report_type (c : Context.t) (core : Core.Ir.definition) ty =
  let trail = Context.latest c in
  let at = place c trail ~span:core.span in
  Diagnostic.error ~code:"E0316" ~at "a value of %s would contain more than %d numbers" (name_of ty)
    Types.most_leaves
  |> Context.with_trail trail
  |> Diagnostic.hint "use an array for many values of one type: `Array 1000 Float`"
  |> Diagnostic.emit c.sink

let report_nesting (c : Context.t) (core : Core.Ir.definition) ty =
  let trail = Context.latest c in
  let at = place c trail ~span:core.span in
  Diagnostic.error ~code:"E0316" ~at "a value of %s would nest data more than %d levels deep"
    (name_of ty) Types.deepest
  |> Context.with_trail trail
  |> Diagnostic.hint "put the fields into fewer levels of records"
  |> Diagnostic.emit c.sink
