type t = { header : string; source : string; host_table : string }

let program (program : Machine.Ir.program) =
  let files = Of_machine.program program in
  {
    header = Print.file files.header;
    source = Print.file files.source;
    host_table = Host_table.text program files;
  }
