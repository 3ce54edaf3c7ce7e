let bug what = Basis.Diagnostic.bug ~stage:"Interp" "%s" what

let elements : Value.t -> Value.thunk array = function
  | Array elements -> elements
  | Bool _ | Int _ | Float _ | Text _ | Drawing _ | Image _ | Tuple _ | Data _ | Function _
  | Signal_function _ | Task _ | Ending _ ->
      bug "a value that is not an array"

let number : Value.t -> int = function
  | Int n -> Int32.to_int n
  | Bool _ | Float _ | Text _ | Drawing _ | Image _ | Tuple _ | Array _ | Data _ | Function _
  | Signal_function _ | Task _ | Ending _ ->
      bug "an index that is not an Int"

let element array k = Thunk.force (elements array).(k)
let of_int k = Thunk.known (Value.Int (Int32.of_int k))

(* Evaluates a value completely, so that a long fold does not build a long chain of thunks. *)
let rec whole thunk =
  match (Thunk.force thunk : Value.t) with
  | Tuple parts | Array parts | Data { arguments = parts; _ } -> Array.iter whole parts
  | Bool _ | Int _ | Float _ | Text _ | Drawing _ | Image _ | Function _ | Signal_function _
  | Task _ | Ending _ ->
      ()

let apply apply (p : Core.Primitive.t) ~size arguments : Value.t option =
  let given f = fun arguments -> apply (Thunk.force f) arguments in
  let made f = Thunk.delay f in
  let array thunk = elements (Thunk.force thunk) in
  let fold f first xs visit =
    Array.fold_left
      (fun before x ->
        let next = Thunk.known (given f [ before; x ]) in
        whole next;
        visit next;
        next)
      first (array xs)
  in
  let inside k xs = k >= 0 && k < Array.length xs in
  match (p, arguments) with
  | At, [ index; otherwise; xs ] ->
      let k = number (Thunk.force index) and xs = array xs in
      Some (Thunk.force (if inside k xs then xs.(k) else otherwise))
  | Length, [ xs ] -> Some (Int (Int32.of_int (Array.length (array xs))))
  | Replace, [ index; by; xs ] ->
      let k = number (Thunk.force index) and xs = Array.copy (array xs) in
      if inside k xs then xs.(k) <- by;
      Some (Array xs)
  | Generate, [ f ] ->
      Some (Array (Array.init size (fun k -> made (fun () -> given f [ of_int k ]))))
  | Map, [ f; xs ] -> Some (Array (Array.map (fun x -> made (fun () -> given f [ x ])) (array xs)))
  | Imap, [ f; xs ] ->
      Some (Array (Array.mapi (fun k x -> made (fun () -> given f [ of_int k; x ])) (array xs)))
  | Zip_with, [ f; xs; ys ] ->
      let one x y = made (fun () -> given f [ x; y ]) in
      Some (Array (Array.map2 one (array xs) (array ys)))
  | Foldl, [ f; first; xs ] -> Some (Thunk.force (fold f first xs ignore))
  | Scanl, [ f; first; xs ] ->
      let reversed = ref [] in
      ignore (fold f first xs (fun next -> reversed := next :: !reversed));
      Some (Array (Array.of_list (List.rev !reversed)))
  | _, _ -> None

let start signal_function : Value.instance =
  match (Thunk.force signal_function : Value.t) with
  | Signal_function start -> start ()
  | Bool _ | Int _ | Float _ | Text _ | Drawing _ | Image _ | Tuple _ | Array _ | Data _
  | Function _ | Task _ | Ending _ ->
      bug "a primitive runs a value that is not a signal function"

let side_by_side instances : Value.instance =
  {
    output =
      (fun instant input ->
        let one k (instance : Value.instance) =
          instance.output instant (Thunk.delay (fun () -> element (Thunk.force input) k))
        in
        Thunk.known (Value.Array (Array.mapi one instances)));
    commit =
      (fun () ->
        Array.iteri
          (fun k (instance : Value.instance) ->
            instance.commit ();
            Option.iter (fun next -> instances.(k) <- next) (instance.successor ()))
          instances);
    successor = (fun () -> None);
  }

let map_sf ~size f = side_by_side (Array.init size (fun _ -> start f))

let parallel signal_functions =
  side_by_side (Array.map start (elements (Thunk.force signal_functions)))
