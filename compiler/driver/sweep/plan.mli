(** A sweep's plan, as its file says it. Numbers with units are texts still. *)

type 'a placed = { place : string;  (** [FILE:LINE:COLUMN] *) value : 'a }

type variation =
  | Range of { low : string; high : string; steps : int  (** 0: to be sampled *) }
  | Values of string list

type sampling = Grid | Random | Latin

type t = {
  program : string placed;
  trial : string placed option;  (** its label; without it the only one *)
  seeds : (int * int) option;  (** as the trial says if [None]; so for the next *)
  lasts : float option;
  rate : float option;  (** Hz; 50 if [None] *)
  worlds : string placed list;
  robots : string placed list;
  sampling : sampling;
  points : int;  (** of a sampling *)
  sampling_seed : int;
  params : (string * variation) placed list;
}

val read : Resources.t -> string -> (t, string) result
(** Of a file, read by the simulator's host. The error has a line for each mistake, as they are
    told. *)
