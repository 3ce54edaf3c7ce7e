let bug what = Basis.Diagnostic.bug ~stage:"Interp.Tasks" "%s" what

(* Inspects the output of a [mkTask]: a pair of an output and an event. Constructor 1 is [Event]. *)
let by_event output : (Value.thunk, Value.thunk) Either.t =
  match Thunk.force output with
  | Value.Tuple [| shown; event |] -> (
      match Thunk.force event with
      | Value.Data { constructor = 1; arguments = [| result |] } -> Right result
      | Data { constructor = 0; _ } -> Left shown
      | _ -> bug "a value that is not an event")
  | _ -> bug "an output that is not a pair"

let by_side output : (Value.thunk, Value.thunk) Either.t =
  match Thunk.force output with
  | Value.Data { constructor = 0; arguments = [| shown |] } -> Left shown
  | Data { constructor = 1; arguments = [| result |] } -> Right result
  | _ -> bug "an output that is neither `Left` nor `Right`"

let make signal_function = Value.Task (Runs { signal_function; ended = by_event })
let until_right signal_function = Value.Task (Runs { signal_function; ended = by_side })

let started nesting signal_function =
  match Thunk.force signal_function with
  | Value.Signal_function start -> Thunk.afresh nesting start
  | _ -> bug "a task made from a value that is not a signal function"

let next_task continuation result =
  match Thunk.force continuation with
  | Value.Function f -> f result
  | _ -> bug "the continuation of a task is not a function"

(* The running instance, and the continuations that follow it, the next one first. *)
type running = {
  instance : Value.instance;
  ended : Value.thunk -> (Value.thunk, Value.thunk) Either.t;
  rest : Value.thunk list;
}

type state = Starting | Running of running | Ended of Value.thunk

(* The state after an instant, and the output in that instant. *)
type step = { state : state; shown : Value.thunk }

let nothing = Thunk.known (Value.Tuple [||])

(* Starts a task in its first instant. If the task ends immediately, starts the next one in the same
   instant, and so on. *)
let rec enter nesting (task : Value.t) rest input =
  match task with
  | Task (First (first, continuation)) ->
      enter nesting (Thunk.force first) (continuation :: rest) input
  | Task (Returns result) -> go_on nesting result rest input
  | Task (Runs { signal_function; ended }) ->
      let instance = started nesting signal_function in
      look nesting { instance; ended; rest } (instance.output Clock.first input) input
  | _ -> bug "a value that is not a task"

and go_on nesting result rest input =
  match rest with
  | [] -> { state = Ended result; shown = nothing }
  | continuation :: rest -> enter nesting (next_task continuation result) rest input

and look nesting running output input =
  match running.ended output with
  | Left shown -> { state = Running running; shown }
  | Right result -> go_on nesting result running.rest input

let left value = Value.Data { constructor = 0; arguments = [| value |] }
let right value = Value.Data { constructor = 1; arguments = [| value |] }

let run nesting task : Value.instance =
  let state = ref Starting in
  let step = ref (Thunk.known { state = Starting; shown = nothing }) in
  let output instant input =
    let before = !state in
    let evaluate =
      match before with
      | Starting -> fun () -> enter nesting (Thunk.force task) [] input
      | Running running ->
          let now = running.instance.output instant input in
          fun () -> look nesting running now input
      | Ended _ -> fun () -> { state = before; shown = nothing }
    in
    let now = Thunk.equation nesting ~name:"a task" evaluate in
    step := now;
    Thunk.equation nesting ~name:"a task" (fun () ->
        match Thunk.force now with
        | { state = Ended result; _ } -> right result
        | { shown; _ } -> left shown)
  in
  let commit () =
    match (Thunk.demand !step).state with
    | Running running ->
        running.instance.commit ();
        let instance = Option.value (running.instance.successor ()) ~default:running.instance in
        state := Running { running with instance }
    | (Starting | Ended _) as other -> state := other
  in
  { output; commit; successor = (fun () -> None) }
