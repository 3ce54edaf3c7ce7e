(* Writes random programs as C, a driver that runs all of them on random input, and the expected
   output according to the evaluator. Numbers are printed as bits, so that nothing is lost.

   Every other program is inlined but not optimized, so that the test also covers C that
   optimization would simplify. *)

open Flow

let count, seed =
  match Sys.argv with
  | [| _; count; seed |] -> (int_of_string count, int_of_string seed)
  | _ -> failwith "usage: random_c COUNT SEED"

let write path text =
  let out = open_out_bin path in
  output_string out text;
  close_out out

let bits x =
  let x = if Float.is_nan x then Evaluate.nan else x in
  Printf.sprintf "%Lx" (Int64.bits_of_float x)

(* The format of the driver. A slot that the constructor does not use is 0. *)
let printed : Evaluate.value -> string = function
  | Bool b -> if b then "1" else "0"
  | Int n -> Int32.to_string n
  | Float x -> bits x
  | Sum (tag, payload) ->
      let slot = match payload with [ Float x ] -> bits x | _ -> bits 0. in
      Printf.sprintf "%d/%s" tag slot
  | Array _ -> failwith "no array is made"

let c_float x = Cgen.Print.float_literal Double x

let set_input place : Evaluate.value -> string = function
  | Bool b -> Printf.sprintf "    %s = %b;\n" place b
  | Int n when Int32.equal n Int32.min_int -> Printf.sprintf "    %s = INT32_MIN;\n" place
  | Int n -> Printf.sprintf "    %s = %ld;\n" place n
  | Float x -> Printf.sprintf "    %s = %s;\n" place (c_float x)
  | Sum (tag, payload) ->
      let slot = match payload with [ Float x ] -> c_float x | _ -> "0.0" in
      Printf.sprintf "    %s.tag = %d;\n    %s.f0 = %s;\n" place tag place slot
  | Array _ -> failwith "no array is made"

let print_output place : Evaluate.value -> string = function
  | Bool _ -> Printf.sprintf "    show_int(%s ? 1 : 0);\n" place
  | Int _ -> Printf.sprintf "    show_int(%s);\n" place
  | Float _ -> Printf.sprintf "    show_float(%s);\n" place
  | Sum _ -> Printf.sprintf "    show_sum(%s.tag, %s.f0);\n" place place
  | Array _ -> failwith "no array is made"

let members prefix each values =
  String.concat "" (List.mapi (fun k v -> each (Printf.sprintf "%s.f%d" prefix (k + 1)) v) values)

let driver_start =
  {|#include <math.h>
#include <stdio.h>
#include <string.h>
#include <inttypes.h>

static void show_float(double x)
{
    uint64_t bits = UINT64_C(0x7ff8000000000000);
    if (x == x) {
        memcpy(&bits, &x, sizeof bits);
    }
    printf(" %" PRIx64, bits);
}

static void show_int(int32_t n)
{
    printf(" %" PRId32, n);
}

static void show_sum(unsigned tag, double f0)
{
    printf(" %u/", tag);
    uint64_t bits = UINT64_C(0x7ff8000000000000);
    if (f0 == f0) {
        memcpy(&bits, &f0, sizeof bits);
    }
    printf("%" PRIx64, bits);
}

|}

let instant name k outputs ({ dt; inputs } : Evaluate.instant) =
  String.concat ""
    [
      members "in" set_input inputs;
      Printf.sprintf "    %s_step(&self, &params, %s, &in, &out);\n" name (c_float dt);
      Printf.sprintf "    printf(\"%s instant %d:\");\n" name k;
      members "out" print_output outputs;
      "    printf(\"\\n\");\n";
    ]

let run_function name instants outputs =
  let body = String.concat "" (List.map2 (fun (k, i) o -> instant name k o i) instants outputs) in
  Printf.sprintf
    "static void run_%s(void)\n\
     {\n\
    \    struct %s_state self;\n\
    \    /* Those of the evaluator, not the defaults. */\n\
    \    const struct %s_params params = {true, 7, -3.25};\n\
    \    struct %s_input in;\n\
    \    struct %s_output out;\n\
    \    memset(&self, 0xa5, sizeof self);\n\
    \    memset(&out, 0xa5, sizeof out);\n\
    \    %s_reset(&self, &params);\n\
     %s}\n\n"
    name name name name name name body

(* The evaluator adds seconds, while the C code adds whole nanoseconds. Both agree if the times
   are exact binary fractions. *)
let exact_dt (i : Evaluate.instant) = if i.dt = 0.1 then { i with dt = 0.125 } else i

let rec causal rng =
  let program = Random_program.program rng in
  if Causality.is_causal program then program else causal rng

let () =
  let rng = Random.State.make [| seed |] in
  let driver = Buffer.create 65536 and expected = Buffer.create 65536 in
  let names = List.init count (Printf.sprintf "random%d") in
  List.iter (fun name -> Buffer.add_string driver (Printf.sprintf "#include \"%s.h\"\n" name)) names;
  Buffer.add_string driver driver_start;
  List.iteri
    (fun k name ->
      let program = { (causal rng) with name } in
      let instants = List.map exact_dt (Random_program.instants rng program) in
      let outputs = Evaluate.by_demand program instants in
      let prepared =
        if k mod 2 = 0 then Optimize.program program else Dead_code.program (Inline.program program)
      in
      let step = Step.Passes.program (Step.Of_flow.program prepared) in
      Step.Lint.program step;
      let files = Cgen.Emit.program step in
      write (name ^ ".h") files.Cgen.Emit.header;
      write (name ^ ".c") files.source;
      let instants = List.mapi (fun k i -> (k, i)) instants in
      Buffer.add_string driver (run_function name instants outputs);
      List.iteri
        (fun k values ->
          Buffer.add_string expected
            (Printf.sprintf "%s instant %d: %s\n" name k
               (String.concat " " (List.map printed values))))
        outputs)
    names;
  Buffer.add_string driver "int main(void)\n{\n";
  List.iter (fun name -> Buffer.add_string driver (Printf.sprintf "    run_%s();\n" name)) names;
  Buffer.add_string driver "    return 0;\n}\n";
  write "driver.c" (Buffer.contents driver);
  write "expected.txt" (Buffer.contents expected)
