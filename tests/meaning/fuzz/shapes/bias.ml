type root = Any | Small | Cascade | Handed_on | Errand

type t = {
  events : int;
  switches : int;
  tasks : int;
  library : int;
  odd_numbers : int;
  depth : int;
  width : int;
  chains : int;
  root : root;
}

let even =
  {
    events = 12;
    switches = 3;
    tasks = 1;
    library = 3;
    odd_numbers = 20;
    depth = 0;
    width = 0;
    chains = 1;
    root = Any;
  }

let all =
  [|
    even;
    { even with events = 3; library = 8 };
    { even with events = 5; switches = 14; tasks = 4; library = 5 };
    { even with odd_numbers = 2 };
    { even with depth = 1 };
    { even with width = 5 };
    { even with chains = 8 };
    { even with root = Small };
    { even with root = Cascade };
    { even with root = Handed_on };
    { even with root = Errand };
  |]

let count = Array.length all
let alike = 20
let of_program ~seed number = all.(abs (seed + (number / alike)) mod count)
