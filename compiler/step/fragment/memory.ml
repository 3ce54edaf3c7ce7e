module F = Flow.Ir
open Basis
open Fragment
open Computation

let broken what = Diagnostic.bug ~stage:"Step.Memory" "%s" what

let differentiate draft ~(value : Ir.field) ~(input : Ir.field) atom span =
  let statements = function
    | [ now; kept ] ->
        let operation = operation ~span in
        let change = operation F.Subtract Float [ now; Ir.Field input ] in
        [
          Ir.If
            {
              uninitialized = [];
              condition = operation F.Less Float [ Float 0.; Dt ];
              then_ =
                [
                  Assign
                    { place = Own value; value = operation F.Divide Float [ change; Dt ]; span };
                ];
              else_ = [];
              predicted = false;
              span;
            };
          Assign { place = Own input; value = kept; span };
        ]
    | _ -> broken "a derivative with the wrong number of operands"
  in
  Draft.add draft (Draft.work ~operands:[ atom; atom ] ~advances:value span statements)

(* The local time after this step. *)
let later ~limited (time : Ir.field) =
  if limited then Ir.Soon (Field time, Dt_nanoseconds) else Later (Field time, Dt_nanoseconds)

let advance ~limited state (eq : F.equation) =
  match State.memory state eq.defines with
  | Some (Elapsed { time; restart = Bool false }) ->
      Some (Ir.Assign { place = Own time; value = later ~limited time; span = eq.span })
  | Some (Integrated { value; input }) ->
      let operation = operation ~span:eq.span in
      let step = operation F.Multiply Float [ Dt; input ] in
      let sum = operation F.Add Float [ Field value; step ] in
      Some (Assign { place = Own value; value = sum; span = eq.span })
  | Some (Ticked { time; period }) ->
      (* If the period is at most 8 * 10^18, the sum cannot overflow: the time was less than the
         period, and dt is at most 10^18. *)
      let limited = match period with Float x -> x <= 8e18 | Signal _ | Bool _ | Int _ -> false in
      Some (Assign { place = Own time; value = later ~limited time; span = eq.span })
  | Some (Elapsed _ | Delayed _ | Differentiated _ | Kept _) | None -> None

(* Resets the time to 0 if the condition is true; otherwise advances it. *)
let start_again draft time restart span =
  let statements restart =
    let else_ = later ~limited:false time in
    let value =
      match one restart with
      | Operation { operator = Not; arguments = [ condition ]; _ } ->
          Ir.Select { condition; then_ = else_; else_ = Zero_time; span }
      | condition -> Select { condition; then_ = Zero_time; else_; span }
    in
    [ Ir.Assign { place = Own time; value; span } ]
  in
  Draft.add draft (Draft.work ~operands:[ restart ] ~advances:time span statements)

(* The remaining time is stored at the end of the step, with the other state, because everything
   else reads the old value. *)
let tick fresh draft (s : F.signal) time period span =
  let internal () =
    let internal = { s with id = fresh (); name = ""; ty = F.Float } in
    Draft.count_nanoseconds draft internal;
    internal
  in
  let before = internal () and rest = internal () and next = internal () in
  let computed signal ?choice operands build =
    Draft.add draft (Computed { signal; operands; build; choice; weight = 2; span })
  in
  let on_period build = function
    | [ time; period ] -> build time period
    | _ -> broken "ticks with the wrong number of operands"
  in
  Draft.leaf draft before (Field time);
  computed s [ Signal before; period ] (on_period (fun time period -> Ir.Reached { time; period }));
  computed rest [ Signal before; period ] (on_period (fun time period -> Ir.Rest { time; period }));
  computed next ~choice:(Signal s, Signal rest, Signal before)
    [ Signal s; Signal rest; Signal before ] (function
    | [ condition; then_; else_ ] -> Select { condition; then_; else_; span }
    | _ -> broken "a choice with the wrong number of operands");
  Draft.keep_at_end draft time (Signal next) ~leaf:(Some before) span

(* Reads a time by converting its nanoseconds. *)
let read_time fresh draft (eq : F.equation) time build =
  let now = { eq.defines with id = fresh (); name = "" } in
  Draft.count_nanoseconds draft now;
  Draft.leaf draft now (Field time);
  let operands = [ F.Signal now ] and build arguments = build (one arguments) in
  Draft.add draft
    (Computed { signal = eq.defines; operands; build; choice = None; weight = 5; span = eq.span })

let step ~fresh draft state (eq : F.equation) =
  let s = eq.defines in
  let memory_of (atom : F.atom) =
    match atom with Signal s -> State.memory state s | Bool _ | Int _ | Float _ -> None
  in
  match State.memory state s with
  | None -> (
      match eq.rhs with
      | Op (Elementary Nanoseconds, [ seconds ]) -> (
          match memory_of (Draft.resolve draft seconds) with
          | Some (Elapsed { time; _ }) -> read_time fresh draft eq time (fun e -> In_nanoseconds e)
          | Some _ | None -> Draft.add_computed draft eq)
      | _ -> Draft.add_computed draft eq)
  | Some (Kept field | Delayed field) -> Draft.leaf draft s (Field field)
  | Some (Elapsed { time; restart }) ->
      (match Draft.resolve draft restart with
      | Bool false -> ()
      | again -> start_again draft time again eq.span);
      read_time fresh draft eq time (fun e -> Seconds e)
  | Some (Ticked { time; period }) -> tick fresh draft s time (Draft.resolve draft period) eq.span
  | Some (Integrated { value; _ }) -> Draft.leaf draft s (Field value)
  | Some (Differentiated { value; input }) ->
      Draft.leaf draft s (Field value);
      let argument =
        match eq.rhs with
        | Derivative atom -> Draft.resolve draft atom
        | _ -> broken "a derivative without an operand"
      in
      differentiate draft ~value ~input argument eq.span

let next draft state (eq : F.equation) =
  match (State.memory state eq.defines, eq.rhs) with
  | Some (Delayed field), Delay { next; _ } ->
      Some (field, Draft.resolve draft next, Some eq.defines, eq.span)
  | Some (Integrated { input = Field input; _ }), Integral atom ->
      Some (input, Draft.resolve draft atom, None, eq.span)
  | _, _ -> None

let assign field value span = Ir.Assign { place = Own field; value; span }

let keep draft state span (s : F.signal) =
  match State.memory state s with
  | Some (Kept field) ->
      [
        Draft.work
          ~operands:[ Draft.resolve draft (F.Signal s) ]
          span
          (fun e -> [ assign field (one e) span ]);
      ]
  | Some _ | None -> []

let reset draft state (eq : F.equation) =
  let span = eq.span in
  let constant span fields =
    Draft.work span (fun _ -> List.map (fun (f, e) -> assign f e span) fields)
  in
  match (State.memory state eq.defines, eq.rhs) with
  | Some (Delayed field), Delay { init; _ } ->
      let operands = [ Draft.resolve draft init ] in
      [ Draft.work ~operands span (fun e -> [ assign field (one e) span ]) ]
  | Some (Elapsed { time; _ } | Ticked { time; _ }), _ -> [ constant span [ (time, Zero_time) ] ]
  | Some (Integrated { value; input = Field input } | Differentiated { value; input }), _ ->
      [ constant span [ (value, Float 0.); (input, Float 0.) ] ]
  | Some (Integrated { value; _ }), _ -> [ constant span [ (value, Float 0.) ] ]
  | _, _ -> keep draft state span eq.defines
