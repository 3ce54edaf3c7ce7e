open Basis

let bug format = Diagnostic.bug ~stage:"Specialize.Task" format

type evaluator = span:Span.t -> result:Core.Ir.ty -> Value.t -> Value.argument -> Value.t

type head =
  | Runs of {
      signal_function : Value.t;
      primitive : Core.Primitive.t;
      output : Core.Ir.ty;
      result : Core.Ir.ty;
    }
  | Ends of Value.argument

let type_of input output result : Core.Ir.ty =
  Data ({ module_ = "Prelude"; name = "Task" }, [ input; output; result ])

let is_task (p : Core.Primitive.t) =
  match p with Make_task | Until_right | Return | Sequence -> true | _ -> false

let rec named c ~name ~at (value : Value.t) : Value.t =
  match value with
  | Primitive ({ primitive; _ } as p)
    when is_task primitive && (not (Context.in_prelude c at))
         && (Context.in_prelude c p.at || Hashtbl.mem c.definitions ("Prelude", p.owner)) ->
      let at = if Context.in_prelude c p.at then at else p.at in
      let owner =
        match name with
        | Some name when Hashtbl.mem c.definitions ("Prelude", p.owner) -> name
        | Some _ | None -> p.owner
      in
      Primitive { p with owner; at }
  | Choice { condition; then_; else_ } ->
      let then_ = named c ~name ~at then_ in
      Choice { condition; then_; else_ = named c ~name ~at else_ }
  | value -> value

let place_of ~otherwise (continuation : Value.t) =
  match continuation with
  | Function { code = Lambda (_, body); _ } -> body.span
  | _ -> otherwise

(* So many tasks in a row end at once in no program that means it. *)
let most_at_once = 1000

let report_circle (c : Context.t) ~span places =
  (* The circle is at the end of the list, its last step first. *)
  let circle =
    match places with
    | [] -> []
    | last :: before ->
        let rec until = function
          | place :: _ when Span.compare place last = 0 -> []
          | place :: others -> place :: until others
          | [] -> []
        in
        List.rev (last :: until before)
  in
  let label d at = Diagnostic.label ~at "then this, at once" d in
  (match circle with
  | first :: others ->
      let others = List.filteri (fun i _ -> i < 10) others in
      List.fold_left label
        (Diagnostic.error ~code:"E0402" ~at:first "these tasks follow each other in no time"
        |> Diagnostic.here "this starts when the one before has ended at once")
        others
  | [] -> Diagnostic.error ~code:"E0402" ~at:span "these tasks follow each other in no time")
  |> Diagnostic.note "each cycle of tasks must take time: `return` takes none"
  |> Diagnostic.hint "put a task into the cycle that takes time, such as `sleepT 10[ms] output`"
  |> Diagnostic.emit c.sink;
  raise Context.Stopped

let sequence types owner at first rest : Value.t =
  Primitive { primitive = Sequence; types; arguments = [ rest; first ]; owner; at }

let reduced (c : Context.t) apply ~span task =
  let rec reduce places count (task : Value.t) : Value.t =
    match task with
    | Primitive { primitive = Sequence; types = [ a; b; _; d ] as types; arguments = [ rest; first ]; owner; at }
      ->
        follow places count types (owner, at) rest
          { first with value = reduce places count first.value }
          ~result:(type_of a b d)
    | Choice { condition; then_; else_ } ->
        let then_ = reduce places count then_ in
        Choice { condition; then_; else_ = reduce places count else_ }
    | task -> task
  and follow places count types origin rest (first : Value.argument) ~result =
    match first.value with
    | Primitive { primitive = Return; arguments = [ value ]; _ } ->
        let place = place_of ~otherwise:span rest.value in
        let places = place :: places in
        if count = most_at_once then report_circle c ~span places;
        reduce places (count + 1) (apply ~span:place ~result rest.value value)
    | Choice { condition; then_; else_ } ->
        let branch value = follow places count types origin rest { first with value } ~result in
        let then_ = branch then_ in
        Choice { condition; then_; else_ = branch else_ }
    | Unspecified -> Unspecified
    | _ -> sequence types (fst origin) (snd origin) first rest
  in
  reduce [] 0 task

let rec head (task : Value.t) =
  match task with
  | Primitive { primitive = Sequence; arguments = [ _; first ]; _ } -> head first.value
  | Primitive
      {
        primitive = (Make_task | Until_right) as primitive;
        types = [ _; output; result ];
        arguments = [ signal_function ];
        _;
      } ->
      Runs { signal_function = signal_function.value; primitive; output; result }
  | Primitive { primitive = Return; arguments = [ value ]; _ } -> Ends value
  | _ -> bug "what is no task, or not reduced"

let rec after (task : Value.t) result : Value.t =
  match task with
  | Primitive { primitive = Sequence; types; arguments = [ rest; first ]; owner; at } ->
      sequence types owner at { first with value = after first.value result } rest
  | Primitive { primitive = Make_task | Until_right; types = [ a; b; c ]; owner; at; _ } ->
      Primitive { primitive = Return; types = [ c; a; b ]; arguments = [ result ]; owner; at }
  | _ -> bug "what has ended is no task that runs"

let rec name (task : Value.t) =
  match task with
  | Primitive { primitive = Sequence; arguments = [ _; first ]; _ } -> name first.value
  | Primitive { primitive = Return; _ } -> "ended"
  | Primitive { owner; _ } -> owner
  | _ -> bug "a name of what is no task"

let rec place (task : Value.t) =
  match task with
  | Primitive { primitive = Sequence; arguments = [ _; first ]; _ } -> place first.value
  | Primitive { at; _ } -> at
  | _ -> bug "the place of what is no task"

let rec next_place (task : Value.t) =
  match task with
  | Primitive
      { primitive = Sequence; arguments = [ _; { value = Primitive { primitive = Sequence; _ } as first; _ } ]; _ } ->
      next_place first
  | Primitive { primitive = Sequence; arguments = [ { value = Function { code = Lambda (_, body); _ }; _ }; _ ]; _ } ->
      body.span
  | Primitive { at; _ } -> at
  | _ -> bug "the place of what is no task"
