type t = { share : float; confidence : float }
type decision = Holds | Fails | Open

let ratio = 4.

let decide { share; confidence } runs =
  let allowed = 1. -. share in
  let boundary = log (1. /. (1. -. confidence)) in
  (* How much one run changes the log-likelihood ratio between another failure rate and the allowed
     one. *)
  let gain other held =
    if held then log ((1. -. other) /. (1. -. allowed)) else log (other /. allowed)
  in
  let fewer = gain (allowed /. ratio) in
  let more = gain (min (ratio *. allowed) ((1. +. allowed) /. 2.)) in
  let rec from count good bad = function
    | _ when good >= boundary -> (Holds, count)
    | _ when bad >= boundary -> (Fails, count)
    | [] -> (Open, count)
    | held :: rest -> from (count + 1) (good +. fewer held) (bad +. more held) rest
  in
  from 0 0. 0. runs

(* {1 The Clopper–Pearson interval} *)

(* The probability of at most k successes in n trials with probability p. *)
let at_most k n p =
  if p <= 0. then 1.
  else if p >= 1. then if k >= n then 1. else 0.
  else
    (* Computes the logarithm of each term from the logarithm of the previous term. *)
    let sum = ref 0. and term = ref (float_of_int n *. log1p (-.p)) in
    let odds = log p -. log1p (-.p) in
    for i = 0 to k do
      sum := !sum +. exp !term;
      term := !term +. log (float_of_int (n - i) /. float_of_int (i + 1)) +. odds
    done;
    min 1. !sum

(* Finds, by bisection, where a function that decreases from 1 to 0 takes the given value. *)
let crossing f value =
  let rec within low high rounds =
    let middle = (low +. high) /. 2. in
    if rounds = 0 then middle
    else if f middle > value then within middle high (rounds - 1)
    else within low middle (rounds - 1)
  in
  within 0. 1. 60

let bounds ~confidence ~held n =
  let tail = (1. -. confidence) /. 2. in
  let least = if held = 0 then 0. else crossing (at_most (held - 1) n) (1. -. tail) in
  let most = if held = n then 1. else crossing (at_most held n) tail in
  (least, most)
