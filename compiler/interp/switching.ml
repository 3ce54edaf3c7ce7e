let bug what = Basis.Diagnostic.bug ~stage:"Interp.Switching" "%s" what

let started nesting (value : Value.t) =
  match value with
  | Signal_function start -> Thunk.afresh nesting start
  | Bool _ | Int _ | Float _ | Text _ | Drawing _ | Image _ | Tuple _ | Array _ | Data _
  | Function _ | Task _ | Ending _ ->
      bug "the target of a switch is not a signal function"

let component index (value : Value.t) =
  match value with
  | Tuple parts -> parts.(index)
  | Bool _ | Int _ | Float _ | Text _ | Drawing _ | Image _ | Array _ | Data _ | Function _
  | Signal_function _ | Task _ | Ending _ ->
      bug "a value that is not a tuple"

let part nesting thunk index =
  Thunk.equation nesting ~name:"a switch" (fun () ->
      Thunk.force (component index (Thunk.force thunk)))

(* The value of an event if it occurs. [Event] is the second constructor. *)
let occurrence event =
  match Thunk.force event with
  | Value.Data { constructor = 0; _ } -> None
  | Data { arguments = [| value |]; _ } -> Some value
  | Bool _ | Int _ | Float _ | Text _ | Drawing _ | Image _ | Tuple _ | Array _ | Data _
  | Function _ | Signal_function _ | Task _ | Ending _ ->
      bug "a value that is not an event"

let apply f argument =
  match Thunk.force f with
  | Value.Function f -> f argument
  | Bool _ | Int _ | Float _ | Text _ | Drawing _ | Image _ | Tuple _ | Array _ | Data _
  | Signal_function _ | Task _ | Ending _ ->
      bug "a continuation that is not a function"

(* The instance that runs from this instant on, and its output in this instant. *)
type next = { instance : Value.instance; output : Value.thunk }

let enter nesting value input =
  let instance = started nesting value in
  { instance; output = instance.output Clock.first input }

(* [active] runs until [next] replaces it. [next] is computed in each instant. *)
type running = {
  mutable active : Value.instance;
  mutable switched : bool;
  mutable next : next option Thunk.t;
}

let nothing = Thunk.known None

(* [visible]: whether the output in this instant already comes from the new instance. *)
let output nesting running ~visible old =
  if not visible then old
  else
    let next = running.next in
    Thunk.equation nesting ~name:"a switch" (fun () ->
        match Thunk.force next with
        | None -> Thunk.force old
        | Some { output; _ } -> Thunk.force output)

(* Once an instance can no longer switch, it is replaced by the instance that it runs. This allows a
   definition to restart itself any number of times. *)
let commit running =
  (match Thunk.demand running.next with
  | None -> running.active.commit ()
  | Some { instance; _ } ->
      instance.commit ();
      running.active <- instance;
      running.switched <- true);
  running.next <- nothing;
  running.active <- Option.value (running.active.successor ()) ~default:running.active

let start nesting thunk =
  { active = started nesting (Thunk.demand thunk); switched = false; next = nothing }

let switch nesting ~delayed before continuation : Value.instance =
  let running = start nesting before in
  let output instant input =
    let now = running.active.output instant input in
    if running.switched then now
    else
      let event = part nesting now 1 in
      running.next <-
        Thunk.equation nesting ~name:"a switch" (fun () ->
            Option.map
              (fun value -> enter nesting (apply continuation value) input)
              (occurrence event));
      output nesting running ~visible:(not delayed) (part nesting now 0)
  in
  let successor () = if running.switched then Some running.active else None in
  { output; commit = (fun () -> commit running); successor }

let recurring nesting ~delayed first : Value.instance =
  let running = start nesting first in
  let output instant input =
    let own = part nesting input 0 and event = part nesting input 1 in
    let now = running.active.output instant own in
    running.next <-
      Thunk.equation nesting ~name:"a switch" (fun () ->
          Option.map (fun value -> enter nesting (Thunk.force value) own) (occurrence event));
    output nesting running ~visible:(not delayed) now
  in
  { output; commit = (fun () -> commit running); successor = (fun () -> None) }

let on_event nesting body : Value.instance =
  let body = ref (started nesting (Thunk.demand body)) in
  (* The time since the last instant of the body; [None] before its first instant. *)
  let since = ref None and ran = ref nothing in
  let output instant input =
    let elapsed = Option.map (fun ns -> Clock.later ns instant) !since in
    let own = Option.value elapsed ~default:Clock.first in
    since := elapsed;
    let body = !body in
    ran :=
      Thunk.equation nesting ~name:"onEvent" (fun () ->
          Option.map
            (fun value -> { instance = body; output = body.output own value })
            (occurrence input));
    let ran = !ran in
    Thunk.equation nesting ~name:"onEvent" (fun () ->
        match Thunk.force ran with
        | None -> Value.Data { constructor = 0; arguments = [||] }
        | Some { output; _ } -> Data { constructor = 1; arguments = [| output |] })
  in
  let commit () =
    match Thunk.demand !ran with
    | None -> ()
    | Some { instance; _ } ->
        instance.commit ();
        body := Option.value (instance.successor ()) ~default:instance;
        since := Some 0L
  in
  { output; commit; successor = (fun () -> None) }

let initially nesting choose : Value.instance =
  let chosen = ref None in
  let output instant input =
    match !chosen with
    | Some first ->
        let { instance; _ } = Thunk.demand first in
        instance.output instant input
    | None ->
        let first =
          Thunk.equation nesting ~name:"initially" (fun () ->
              enter nesting (apply choose input) input)
        in
        chosen := Some first;
        Thunk.equation nesting ~name:"initially" (fun () -> Thunk.force (Thunk.force first).output)
  in
  let running () =
    match !chosen with
    | Some first -> (Thunk.demand first).instance
    | None -> bug "the state of a signal function that has not started"
  in
  { output; commit = (fun () -> (running ()).commit ()); successor = (fun () -> Some (running ())) }
