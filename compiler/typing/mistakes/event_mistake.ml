open Basis

let is_of name t =
  match Type.expand t with
  | Type.Data { tycon; _ } -> tycon = Environment.built_in name
  | _ -> false

let is_maybe = is_of "Maybe"

let content t =
  match Type.expand t with Type.Data { arguments = [ content ]; _ } -> Some content | _ -> None

let is_function t = match Type.expand t with Type.Function _ -> true | _ -> false

let is_plain t =
  match Type.expand t with
  | Number _ | Bool | String | Tuple _ -> true
  | Data _ -> not (Environment.is_event t || Environment.is_task t)
  | _ -> false

let written words (e : Resolve.Ir.expr option) otherwise =
  Option.bind e (fun e -> Show.quote words e.span)
  |> Option.fold ~none:otherwise ~some:Source.grouped

(* Both operands of `||`, from the arguments of [mergeE a b] of truths. *)
let of_truths words subject =
  let b = written words subject "b" in
  Printf.sprintf
    "`a || b` holds where one of two truths does; an event is `edge %s`, where it becomes True, or \
     `when %s`, wherever it is"
    b b

let matched_as ~value = function
  | "Event" ->
      Printf.sprintf "%s is matched by `Event x` where it occurs, by `NoEvent` elsewhere" value
  | _ -> Printf.sprintf "%s is matched by `Just x` or `Nothing`" value

(* A record as it is built, or what else such a value is called. *)
let value words t =
  match Show.fields words t with
  | Some (constructor, fields) when List.compare_length_with fields 4 <= 0 ->
      Printf.sprintf "(%s { %s })" constructor
        (String.concat ", " (List.map (Printf.sprintf "%s = …") fields))
  | _ -> "x"

(* The second of a pair, which stands for the whole. *)
let is_beside wanted found =
  match Type.expand wanted with
  | Tuple [ _; second ] -> (
      match (Type.expand second, Type.expand found) with
      | Bool, Bool -> true
      | Data { tycon; _ }, Data { tycon = other; _ } -> tycon = other
      | _ -> false)
  | _ -> false

let is_of_nothing t =
  Environment.is_event t
  && Option.fold (content t) ~none:false ~some:(fun t -> Type.expand t = Tuple [])

(* The time of `after 5[s] ()`. *)
let after words (subject : Resolve.Ir.expr option) =
  match subject with
  | Some
      {
        desc =
          Apply
            {
              head =
                {
                  desc =
                    Apply { head = { desc = Global { name = "after"; _ }; _ }; argument = time; _ };
                  _;
                };
              _;
            };
        _;
      } ->
      Option.map Source.grouped (Show.quote words time.span)
  | _ -> None

let of_numbers found =
  Environment.is_event found
  && Option.fold (content found) ~none:false ~some:(fun t ->
         match Type.expand t with Number _ -> true | _ -> false)

(* What each event adds, for `accumHold 0 (tag e 1)`. *)
let added_up words (subject : Resolve.Ir.expr option) =
  let quoted (e : Resolve.Ir.expr) = Option.map Source.grouped (Show.quote words e.span) in
  let event =
    match subject with
    | Some
        {
          desc =
            Apply
              {
                head =
                  {
                    desc =
                      Apply { head = { desc = Global { name = "tag"; _ }; _ }; argument = e; _ };
                    _;
                  };
                argument = x;
                _;
              };
          _;
        } -> (
        match (quoted e, quoted x) with
        | Some e, Some x -> Some (Printf.sprintf "tag %s (\\n -> n + %s)" e x)
        | _ -> None)
    | Some e -> Option.map (fun e -> Printf.sprintf "mapE (\\x n -> n + x) %s" e) (quoted e)
    | None -> None
  in
  Printf.sprintf "each event brings a function of what was before; to add up the numbers it is `%s`"
    (Option.value event ~default:"mapE (\\x n -> n + x) e")

(* `hold 2[s] b`, of a truth that is to last for a time. *)
let for_a_time words wanted found =
  Type.expand found = Bool
  &&
  match Option.map Type.expand (content wanted) with
  | Some (Number (_, u)) -> String.equal (Show.measure words u) "s"
  | _ -> false

(* A record or another value that is neither a choice nor an event. *)
let is_thing t =
  match Type.expand t with
  | Data _ | Tuple (_ :: _) -> not (Environment.is_event t || Environment.is_task t || is_maybe t)
  | _ -> false

(* How `x`, which has this type, leads to what is wanted: by the field that is called like it. *)
let within words t wanted =
  match (Show.fields words t, Type.expand wanted) with
  | Some (_, fields), Data { tycon; _ } when List.mem (String.uncapitalize_ascii tycon.name) fields
    ->
      "x." ^ String.uncapitalize_ascii tycon.name
  | _ -> "x"

let accumulated words ~name ~at (arguments : (Resolve.Ir.expr * Type.t) list) d =
  let text (e : Resolve.Ir.expr) =
    Option.fold (Show.quote words e.span) ~none:"…" ~some:Source.grouped
  in
  match arguments with
  | [ (start, _); (f, change); (e, event) ] when Environment.is_event event && is_function change ->
      let takes_its_value =
        match Type.expand change with Function (_, result) -> is_function result | _ -> false
      in
      let event = Printf.sprintf (if takes_its_value then "mapE %s %s" else "tag %s %s") in
      let event = if takes_its_value then event (text f) (text e) else event (text e) (text f) in
      let cure = Printf.sprintf "%s %s (%s)" name (text start) event in
      Diagnostic.error ~code:"E0301" ~at:f.span "`%s` takes no function of its own" name
      |> Diagnostic.label ~at:e.span "the event brings it"
      |> Diagnostic.hint (Printf.sprintf "write `%s`" cure)
      |> Diagnostic.write at cure
  | _ -> d

let hint words ~subject ~(expected : Expected.t) ~found =
  let wanted = expected.ty in
  match expected.because with
  | Parameter { callee = Some ("mergeE" | "mergeR" | "pairEvents"); _ }
    when Environment.is_event wanted && Type.expand found = Bool ->
      Some (of_truths words subject)
  | Value _ when is_maybe found && Environment.is_event wanted ->
      Some (matched_as ~value:"an event" "Event")
  | Value _ when Environment.is_event found && is_maybe wanted ->
      Some (matched_as ~value:"a `Maybe`" "Maybe")
  | Operand { operator = ("==" | "/=") as operator; other; _ }
    when (Environment.is_event wanted || is_maybe wanted)
         && not (Environment.is_event found || is_maybe found) -> (
      let constructor = if is_maybe wanted then "Just" else "Event" in
      let text = Option.bind subject (fun e -> Show.quote words e.span) in
      match (Show.quote words other.span, text) with
      | Some other, Some text ->
          Some
            (Printf.sprintf "what is in it is compared so: `%s %s %s %s`" other operator constructor
               (Source.grouped text))
      | _ -> Some (Printf.sprintf "what is in it is compared as `%s x`" constructor))
  | Parameter { callee = Some ("accum" | "accumHold" | "dAccumHold"); _ }
    when Environment.is_event wanted && Option.fold (content wanted) ~none:false ~some:is_function
    ->
      Some
        (if of_numbers found then added_up words subject
         else if Environment.is_event found then
           Printf.sprintf
             "each event brings a function of what was before: `tag %s (\\n -> n + 1)`; `count` \
              counts events"
             (written words subject "e")
         else
           "after the initial value comes an event with a function of what was before: `tag e (\\n \
            -> n + 1)`")
  | Parameter { callee = Some ("hold" | "dHold"); position = 2; _ }
    when Environment.is_event wanted && for_a_time words wanted found ->
      Some
        (Printf.sprintf
           "`hold x0 e` keeps the value of an event; that a condition was True at some instant of \
            the last seconds is `within 2[s] %s`: `import Past`"
           (written words subject "b"))
  | Parameter { callee = Some (("hold" | "dHold") as hold); _ }
    when Environment.is_event wanted && is_plain found && Type.expand found <> Bool ->
      Some
        (Printf.sprintf
           "this has a value at every instant, and needs no `%s`, which keeps that of an event; \
            `tag e %s` is an event with the value that it has where `e` occurs"
           hold (written words subject "x"))
  | (Parameter _ | Field _ | Signature _ | Output _ | Branch _ | Element _)
    when Environment.is_event wanted && is_plain found && Type.expand found <> Bool -> (
      match content wanted with
      | Some x ->
          Some
            (Printf.sprintf
               "`tag e %s` is such an event, with this value where the event `e` occurs; there is \
                none at all in `NoEvent`"
               (value words x))
      | None -> None)
  | (Parameter _ | Signature _ | Output _ | Branch _)
    when is_of_nothing found && Environment.is_event wanted
         && Option.fold (content wanted) ~none:false ~some:is_plain ->
      Some
        (Printf.sprintf
           "the value of such an event is `()`: `tag %s x` is one with the value of `x`"
           (written words subject "e"))
  | Condition when Environment.is_event found && after words subject <> None ->
      Some
        (Printf.sprintf "this occurs once, at one instant; `elapsed %s ()` is True from then on"
           (Option.get (after words subject)))
  | Condition when Type.expand found = Tuple [] ->
      Some "`()` says no more than that something has happened, or has ended"
  | Condition when is_maybe found && Option.map Type.expand (content found) = Some Bool ->
      Some
        (Printf.sprintf
           "`fromMaybe False %s` is what is in it, and False in `Nothing`, as where a time has run \
            out"
           (written words subject "m"))
  | Parameter { callee = Some (("edge" | "when" | "falling") as f); _ }
    when Environment.is_event found ->
      Some (Printf.sprintf "this is an event already, and needs no `%s`" f)
  | Parameter { callee = Some f; _ }
    when Type.expand wanted = Bool
         && Environment.is_event found
         && not (List.mem f [ "&&"; "||"; "not" ]) ->
      Some (Printf.sprintf "`isEvent %s` tells whether it occurs now" (written words subject "e"))
  | Output (Parameter { position = 1; _ }) when is_beside wanted found ->
      Some
        (Printf.sprintf "the output stands beside it: `(output, %s)`"
           (Option.value
              (Option.bind subject (fun (e : Resolve.Ir.expr) -> Show.quote words e.span))
              ~default:"…"))
  | Parameter { callee = Some f; takes; _ }
    when Environment.is_event found && is_thing wanted
         && not (List.mem f [ "switch"; "dSwitch"; "mkTask"; "."; "map" ]) ->
      Some
        (Printf.sprintf
           "an event has a value only where it occurs: `mapE (\\x -> %s %s%s) %s` is the event of \
            what `%s` makes of it"
           f
           (within words (Option.get (content found)) wanted)
           (if takes > 1 then " …" else "")
           (written words subject "e") f)
  | (Parameter _ | Operand _ | Branch _)
    when Type.expand found = Tuple [] && not (Environment.is_event wanted) -> (
      match subject with
      | Some { desc = Local _; _ } ->
          Some
            "the events of `edge`, `when` and `after` have the value `()`: `tag e x` is one with \
             the value of `x`"
      | _ -> None)
  | _ -> None
