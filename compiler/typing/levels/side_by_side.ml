open Ir

let map = Environment.built_in "map"
let zip_with = Environment.built_in "zipWith"
let broadcast = Environment.built_in "parB"
let each_its_own = Environment.built_in "parZ"
let needs = [ broadcast ]

(* Runs all elements of the array on a signal. *)
let run make ~input ~output ~size (all : expr) (signal : expr) =
  let ty =
    let outputs = Data { tycon = Environment.array; units = []; arguments = [ size; output ] } in
    Signal_function (signal.ty, outputs)
  in
  let head = make { types = [ size; input; output ]; representations = [] } in
  let head = { all with desc = head; ty = Function (all.ty, ty) } in
  Some (Run ({ all with desc = Apply (head, all); ty }, signal))

let mentions (x : Local.t) =
  Parts.exists (fun (e : expr) -> match e.desc with Local (y, _) -> x.id = y.id | _ -> false)

let of_application (f : expr) (last : expr) =
  match f.desc with
  | Apply
      ( { desc = Primitive (g, { types = [ Signal_function (input, output); _; size ]; _ }); _ },
        {
          desc =
            Lambda
              ([ { desc = Bound x; _ } ], { desc = Run ({ desc = Local (y, _); _ }, signal); _ });
          _;
        } )
    when g = map && x.id = y.id && not (mentions x signal) ->
      run (fun types -> Global (broadcast, types)) ~input ~output ~size last signal
  | Apply
      ( {
          desc =
            Apply
              ( { desc = Primitive (g, { types = Signal_function (input, output) :: types; _ }); _ },
                {
                  desc =
                    Lambda
                      ( [ { desc = Bound x; _ }; { desc = Bound s; _ } ],
                        { desc = Run ({ desc = Local (y, _); _ }, { desc = Local (t, _); _ }); _ }
                      );
                  _;
                } );
          _;
        },
        all )
    when g = zip_with && x.id = y.id && s.id = t.id ->
      let size = List.nth types 2 in
      run (fun types -> Primitive (each_its_own, types)) ~input ~output ~size all last
  | _ -> None
