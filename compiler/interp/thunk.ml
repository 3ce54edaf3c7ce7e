type nesting = { mutable depth : int }
type 'a state = Known of 'a | Suspended of (unit -> 'a) | Running
type 'a t = { mutable state : 'a state; name : string; nesting : nesting option }

exception Postponed of (unit -> unit)

(* Maximum nesting of evaluations. Evaluating an equation takes a few hundred bytes of stack, or
   somewhat more if the equation is long. *)
let deepest = 400
let nesting () = { depth = 0 }
let known value = { state = Known value; name = ""; nesting = None }
let delay evaluate = { state = Suspended evaluate; name = ""; nesting = None }
let equation nesting ~name evaluate = { state = Suspended evaluate; name; nesting = Some nesting }

let evaluated t evaluate =
  t.state <- Running;
  match evaluate () with
  | value ->
      t.state <- Known value;
      value
  | exception exn ->
      t.state <- Suspended evaluate;
      raise_notrace exn

let rec force t =
  match (t.state, t.nesting) with
  | Known value, _ -> value
  | Running, _ ->
      Basis.Diagnostic.bug ~stage:"Interp" "`%s` needs its own value in the same instant" t.name
  | Suspended evaluate, None -> evaluated t evaluate
  | Suspended _, Some nesting when nesting.depth >= deepest ->
      raise_notrace (Postponed (fun () -> ignore (force t)))
  | Suspended evaluate, Some nesting ->
      nesting.depth <- nesting.depth + 1;
      Fun.protect
        ~finally:(fun () -> nesting.depth <- nesting.depth - 1)
        (fun () -> evaluated t evaluate)

(* Runs a stack of evaluations. If an evaluation is postponed, the evaluation that it needs runs
   first; then the postponed evaluation starts again. *)
let rec settle = function
  | [] -> ()
  | first :: others as all -> (
      match first () with
      | () -> settle others
      | exception Postponed needed -> settle (needed :: all))

let demand t =
  settle [ (fun () -> ignore (force t)) ];
  force t

let afresh nesting evaluate =
  let depth = nesting.depth in
  nesting.depth <- 0;
  Fun.protect ~finally:(fun () -> nesting.depth <- depth) evaluate
