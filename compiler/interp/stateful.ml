let float : Value.t -> float = function
  | Float x -> x
  | Bool _ | Int _ | Text _ | Tuple _ | Array _ | Data _ | Function _ | Signal_function _ | Task _ | Ending _ ->
      Basis.Diagnostic.bug ~stage:"Interp" "a Float is something else"

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
        (* Or it would hold on to the instants before. *)
        Whole.evaluate !now;
        before := !now);
    successor;
  }

let time () : Value.instance =
  let now = ref 0L in
  {
    output =
      (fun instant _ ->
        now := Clock.later !now instant;
        Thunk.known (Value.Float (Clock.seconds !now)));
    commit = ignore;
    successor;
  }

let integral () : Value.instance =
  let sum = ref 0. and before = ref 0. and now = ref zero in
  {
    output =
      (fun instant input ->
        sum := !sum +. (instant.dt *. !before);
        now := input;
        Thunk.known (Value.Float !sum));
    commit = (fun () -> before := float (Thunk.demand !now));
    successor;
  }

let derivative nesting : Value.instance =
  let before = ref 0. and slope_before = ref 0. in
  let now = ref zero and slope_now = ref zero in
  {
    output =
      (fun instant input ->
        let before = !before and slope_before = !slope_before in
        let slope () =
          if instant.ns = 0L then slope_before
          else (float (Thunk.force input) -. before) /. instant.dt
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
