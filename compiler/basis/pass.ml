type 'program t = { name : string; program : 'program -> 'program; reason : string }

let make name program reason = { name; program; reason }

let run after program pass =
  let made = pass.program program in
  after pass made;
  made
