type t = int list array

let components graph =
  let n = Array.length graph in
  let unvisited = -1 in
  let number = Array.make n unvisited in
  let low = Array.make n 0 in
  let on_stack = Array.make n false in
  let stack = ref [] in
  let visited = ref 0 in
  let found = ref [] in
  let rec pop_until v component =
    match !stack with
    | w :: rest ->
        stack := rest;
        on_stack.(w) <- false;
        if w = v then w :: component else pop_until v (w :: component)
    | [] -> component
  in
  let enter v =
    number.(v) <- !visited;
    low.(v) <- !visited;
    incr visited;
    stack := v :: !stack;
    on_stack.(v) <- true
  in
  let close v =
    if low.(v) = number.(v) then
      found :=
        (match pop_until v [] with
        | [ _ ] as alone -> alone
        | component -> List.sort Int.compare component)
        :: !found
  in
  (* [edges]: the edges of [v] that the search has not followed yet. [path]: the vertices that lead
     from the root of the search to [v], each with its unfollowed edges. *)
  let rec search v edges path =
    match edges with
    | w :: edges when number.(w) = unvisited ->
        enter w;
        search w graph.(w) ((v, edges) :: path)
    | w :: edges ->
        if on_stack.(w) then low.(v) <- Int.min low.(v) number.(w);
        search v edges path
    | [] -> (
        close v;
        match path with
        | (parent, edges) :: path ->
            low.(parent) <- Int.min low.(parent) low.(v);
            search parent edges path
        | [] -> ())
  in
  for v = 0 to n - 1 do
    if number.(v) = unvisited then (
      enter v;
      search v graph.(v) [])
  done;
  List.rev !found

let is_cyclic graph = function
  | [] -> false
  | [ v ] -> List.exists (Int.equal v) graph.(v)
  | _ -> true

(* Maximum number of edges that the search for a shortest cycle examines. *)
let patience = 20_000_000

let rotate_to_smallest cycle =
  let smallest = List.fold_left min max_int cycle in
  let rec go before = function
    | v :: after when v <> smallest -> go (v :: before) after
    | after -> List.rev_append (List.rev after) (List.rev before)
  in
  go [] cycle

let shortest_cycle graph component =
  let n = Array.length graph in
  let inside = Array.make n false in
  List.iter (fun v -> inside.(v) <- true) component;
  let seen_from = Array.make n (-1) in
  let parent = Array.make n (-1) in
  let looked_at = ref 0 in
  (* Breadth-first search for a shortest cycle through [root] that has fewer than [bound]
     vertices. *)
  let through root bound =
    let queue = Queue.create () in
    let rec path_to v path = if v = root then root :: path else path_to parent.(v) (v :: path) in
    let rec visit v depth = function
      | [] -> next ()
      | w :: rest ->
          incr looked_at;
          if w = root then Some (path_to v [])
          else (
            if inside.(w) && seen_from.(w) <> root && depth < bound - 1 then (
              seen_from.(w) <- root;
              parent.(w) <- v;
              Queue.add (w, depth + 1) queue);
            visit v depth rest)
    and next () =
      match Queue.take_opt queue with
      | None -> None
      | Some (v, depth) -> if depth >= bound then None else visit v depth graph.(v)
    in
    Queue.add (root, 1) queue;
    next ()
  in
  let shortest, _ =
    List.fold_left
      (fun (best, length) root ->
        if length <= 1 || (!looked_at > patience && best <> []) then (best, length)
        else
          match through root length with
          | Some cycle -> (cycle, List.length cycle)
          | None -> (best, length))
      ([], max_int) component
  in
  rotate_to_smallest shortest
