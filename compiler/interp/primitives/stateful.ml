open Number.Float

let float : Value.t -> float = function
  | Float x -> x
  | Bool _ | Int _ | Text _ | Drawing _ | Image _ | Tuple _ | Array _ | Data _ | Function _
  | Signal_function _ | Task _ | Ending _ ->
      Basis.Diagnostic.bug ~stage:"Interp" "a value that is not a Float"

let zero = Thunk.known (Value.Float 0.)
let successor () = None

let delay initial : Value.instance =
  let before = ref initial and now = ref initial in
  {
    output =
      (fun _ input ->
        now := input;
        !before);
    commit =
      (fun () ->
        (* Otherwise the thunk would keep the previous instants alive. *)
        Whole.evaluate !now;
        before := !now);
    successor;
  }

let time real : Value.instance =
  let now = ref 0L in
  {
    output =
      (fun instant _ ->
        now := Clock.later !now instant;
        Thunk.known (Value.Float (Clock.seconds real !now)));
    commit = ignore;
    successor;
  }

let step_time real : Value.instance =
  {
    output = (fun instant _ -> Thunk.known (Value.Float (Clock.seconds real instant)));
    commit = ignore;
    successor;
  }

let bool : Value.t -> bool = function
  | Bool b -> b
  | Float _ | Int _ | Text _ | Drawing _ | Image _ | Tuple _ | Array _ | Data _ | Function _
  | Signal_function _ | Task _ | Ending _ ->
      Basis.Diagnostic.bug ~stage:"Interp" "a value that is not a Bool"

let time_since real nesting : Value.instance =
  let before = ref 0L and now = ref (Thunk.known 0L) in
  {
    output =
      (fun instant restart ->
        let before = !before in
        let time () = if bool (Thunk.force restart) then 0L else Clock.later before instant in
        let time = Thunk.equation nesting ~name:"timeSince" time in
        now := time;
        Thunk.delay (fun () -> Value.Float (Clock.seconds real (Thunk.force time))));
    commit = (fun () -> before := Thunk.demand !now);
    successor;
  }

(* No run lasts 2^63 ns. *)
let ticks nesting period : Value.instance =
  let before = ref 0L and now = ref (Thunk.known (0L, false)) in
  let rest time period =
    if period < 1. then Some 0L
    else if period < 0x1p63 && Int64.compare (Int64.of_float period) time <= 0 then
      Some (Int64.rem time (Int64.of_float period))
    else None
  in
  {
    output =
      (fun instant _ ->
        let time = Clock.later !before instant in
        let tick () =
          match rest time (float (Thunk.force period)) with
          | Some rest -> (rest, true)
          | None -> (time, false)
        in
        let tick = Thunk.equation nesting ~name:"ticks" tick in
        now := tick;
        Thunk.delay (fun () -> Value.Bool (snd (Thunk.force tick))));
    commit = (fun () -> before := fst (Thunk.demand !now));
    successor;
  }

let integral real : Value.instance =
  let sum = ref 0. and before = ref 0. and now = ref zero in
  {
    output =
      (fun instant input ->
        sum := add real !sum (multiply real (Clock.seconds real instant) !before);
        now := input;
        Thunk.known (Value.Float !sum));
    commit = (fun () -> before := float (Thunk.demand !now));
    successor;
  }

let derivative real nesting : Value.instance =
  let before = ref 0. and slope_before = ref 0. in
  let now = ref zero and slope_now = ref zero in
  {
    output =
      (fun instant input ->
        let before = !before and slope_before = !slope_before in
        let slope () =
          if Int64.equal instant 0L then slope_before
          else
            let change = subtract real (float (Thunk.force input)) before in
            divide real change (Clock.seconds real instant)
        in
        now := input;
        slope_now := Thunk.equation nesting ~name:"derivative" (fun () -> Value.Float (slope ()));
        !slope_now);
    commit =
      (fun () ->
        before := float (Thunk.demand !now);
        slope_before := float (Thunk.demand !slope_now));
    successor;
  }
