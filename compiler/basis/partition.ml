(* A partition that can be split quickly: each class is a segment of [elements],
   the marked ones at its beginning. *)
type t = {
  elements : int array;
  place : int array;  (** where an element stands in [elements] *)
  class_of : int array;
  first : int array;  (** by class *)
  past : int array;
  marked : int array;  (** how many of the class are *)
  mutable classes : int;
}

(* Counting sort. *)
let of_labels ~distinct labels =
  let n = Array.length labels in
  let first = Array.make n 0 and past = Array.make n 0 in
  Array.iter (fun label -> past.(label) <- past.(label) + 1) labels;
  let next = ref 0 in
  for c = 0 to distinct - 1 do
    first.(c) <- !next;
    next := !next + past.(c);
    past.(c) <- first.(c)
  done;
  let elements = Array.make n 0 in
  let put label e =
    let place = past.(label) in
    elements.(place) <- e;
    past.(label) <- place + 1;
    place
  in
  let place = Array.mapi (fun e label -> put label e) labels in
  {
    elements;
    place;
    class_of = Array.copy labels;
    first;
    past;
    marked = Array.make n 0;
    classes = distinct;
  }

let size t c = t.past.(c) - t.first.(c)

(* Marks [e]; true if it is the first of its class. *)
let mark t e =
  let c = t.class_of.(e) in
  let goal = t.first.(c) + t.marked.(c) and here = t.place.(e) in
  if here < goal then false
  else begin
    let other = t.elements.(goal) in
    t.elements.(goal) <- e;
    t.elements.(here) <- other;
    t.place.(e) <- goal;
    t.place.(other) <- here;
    t.marked.(c) <- t.marked.(c) + 1;
    t.marked.(c) = 1
  end

(* Splits the marked elements off; their new class, unless all were marked. *)
let split t c =
  let marked = t.marked.(c) in
  t.marked.(c) <- 0;
  if marked = size t c then None
  else begin
    let fresh = t.classes in
    t.classes <- fresh + 1;
    t.first.(fresh) <- t.first.(c);
    t.past.(fresh) <- t.first.(c) + marked;
    t.first.(c) <- t.past.(fresh);
    for i = t.first.(fresh) to t.past.(fresh) - 1 do
      t.class_of.(t.elements.(i)) <- fresh
    done;
    Some fresh
  end

let congruence ~distinct ~labels ~arguments =
  let n = Array.length labels in
  let t = of_labels ~distinct labels in
  (* By element: who has it as an argument, and as which. *)
  let users = Array.make n [] in
  Array.iteri (fun e -> Array.iteri (fun i a -> users.(a) <- (i, e) :: users.(a))) arguments;
  let waiting = Queue.create () in
  let is_waiting = Array.make n false in
  let wait c =
    if not is_waiting.(c) then begin
      is_waiting.(c) <- true;
      Queue.add c waiting
    end
  in
  for c = 0 to t.classes - 1 do wait c done;
  let split_class c =
    match split t c with
    | None -> ()
    | Some fresh ->
        (* If the whole class has done its splitting, the smaller half tells
           as much as both. *)
        if is_waiting.(c) then wait fresh
        else wait (if size t fresh <= size t c then fresh else c)
  in
  let split_by_users_of c =
    let uses = ref [] in
    for i = t.first.(c) to t.past.(c) - 1 do
      uses := List.rev_append users.(t.elements.(i)) !uses
    done;
    let by_argument =
      match !uses with
      | ([] | [ _ ]) as few -> few
      | uses -> List.sort (fun (i, _) (j, _) -> Int.compare i j) uses
    in
    let rec go argument touched = function
      | (i, e) :: rest when Int.equal i argument ->
          let c = t.class_of.(e) in
          go argument (if mark t e then c :: touched else touched) rest
      | rest -> (
          List.iter split_class touched;
          match rest with
          | (i, _) :: _ -> go i [] rest
          | [] -> ())
    in
    go 0 [] by_argument
  in
  let rec work () =
    match Queue.take_opt waiting with
    | None -> ()
    | Some c ->
        is_waiting.(c) <- false;
        split_by_users_of c;
        work ()
  in
  work ();
  let smallest = Array.make n max_int in
  Array.iteri (fun e c -> smallest.(c) <- Int.min smallest.(c) e) t.class_of;
  Array.map (fun c -> smallest.(c)) t.class_of
