open Basis
module First = First_transitions

type hop = { from : int; by : Ir.transition }

type outcome =
  | Ends of { steps : int; possible : Ir.transition list array }
  | Goes_round of hop list
  | Goes_far

let most = 1000

(* Maximum number of states. It is larger than [most], the maximum length of a chain, because chains
   may branch. *)
let most_states = 8 * most

module States = Hashtbl.Make (struct
  type t = First.state

  let equal = ( = )
  let hash state = Hashtbl.hash_param 100 300 state
end)

exception Far

(* The graph of the states reachable from [roots]. A state's number is its index; each state has its
   transitions, with the numbers of their target states. *)
let explore first modes roots =
  let numbers = States.create 64 in
  let found = ref [] and waiting = Queue.create () in
  let number state =
    match States.find_opt numbers state with
    | Some n -> n
    | None ->
        let n = States.length numbers in
        if n >= most_states then raise_notrace Far;
        States.replace numbers state n;
        Queue.add state waiting;
        n
  in
  let targets = List.map (fun (t, state) -> (t, number state)) in
  let roots = List.map targets roots in
  while not (Queue.is_empty waiting) do
    let state = Queue.pop waiting in
    let next = targets (First.from_state first modes.(state.First.mode) state) in
    found := (state, next) :: !found
  done;
  (roots, Array.of_list (List.rev !found))

let possible modes states =
  let possible = Array.make (Array.length modes) [] in
  Array.iter
    (fun ((state : First.state), next) ->
      List.iter
        (fun (t, _) ->
          if not (List.memq t possible.(state.mode)) then
            possible.(state.mode) <- t :: possible.(state.mode))
        next)
    states;
  possible

(* The maximum number of modes that run in one instant, for each state in which the instant can
   start. Components must be sorted so that targets precede sources. *)
let lengths graph components =
  let length = Array.make (Array.length graph) 1 in
  List.iter
    (List.iter (fun v ->
         length.(v) <- List.fold_left (fun n w -> max n (1 + length.(w))) 1 graph.(v)))
    components;
  length

let round states graph component =
  let cycle = Graph.shortest_cycle graph component in
  let hop v w =
    let (state : First.state), next = states.(v) in
    let by, _ = List.find (fun (_, target) -> target = w) next in
    { from = state.mode; by }
  in
  List.map2 hop cycle (List.tl cycle @ [ List.hd cycle ])

let of_machine first index (m : Ir.machine) =
  let modes = Array.of_list m.modes in
  let late, strict = List.partition (fun (t : Ir.transition) -> t.delayed) m.controls in
  let from_owner = First.from_owner first index m in
  let running = List.concat_map (First.from_running first) m.modes in
  match explore first modes (List.map from_owner [ m.start; late; strict ] @ [ running ]) with
  | exception Far -> Goes_far
  | roots, states -> (
      let graph = Array.map (fun (_, next) -> List.map snd next) states in
      let components = Graph.components graph in
      match List.find_opt (Graph.is_cyclic graph) components with
      | Some component -> Goes_round (round states graph component)
      | None ->
          let length = lengths graph components in
          let longest = List.fold_left (fun n (_, state) -> max n length.(state)) 0 in
          let steps =
            match List.map longest roots with
            | [ start; late; strict; running ] -> max (max start (1 + running) + late) strict
            | _ -> Diagnostic.bug ~stage:"Flow.Chains" "other roots"
          in
          if steps > most + 1 then Goes_far else Ends { steps; possible = possible modes states })
