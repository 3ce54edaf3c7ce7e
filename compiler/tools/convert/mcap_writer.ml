type channel = { id : int; mutable count : int; mutable index : (int * int) list }
(* [index]: times and offsets of the channel's messages in the current chunk, in reverse order. *)

type t = {
  out : out_channel;
  mutable position : int;
  mutable crc : int;  (** CRC of all bytes before [position] *)
  chunk : Buffer.t;  (** records of the current chunk *)
  mutable chunk_times : (int * int) option;
      (** times of the first and last messages in the chunk *)
  mutable times : (int * int) option;  (** times of the first and last messages in the file *)
  (* Data for the summary. Each list is in reverse order. *)
  mutable schemas : (string * string) list;  (** names and schemas *)
  mutable channels : (channel * string) list;
  mutable chunks : string list;
  mutable attachments : string list;
  mutable all_metadata : string list;
}

let magic = "\x89MCAP0\r\n"
let full = 1 lsl 20

(* {1 Fields and records} *)

let u16 b n = Buffer.add_uint16_le b n
let u32 b n = Buffer.add_int32_le b (Int32.of_int n)
let u64 b n = Buffer.add_int64_le b (Int64.of_int n)

let text b s =
  u32 b (String.length s);
  Buffer.add_string b s

let made fields =
  let b = Buffer.create 256 in
  fields b;
  Buffer.contents b

(* A map or an array: its size in bytes, followed by its contents. *)
let sized b fields = text b (made fields)

let head op length =
  made (fun b ->
      Buffer.add_uint8 b op;
      u64 b length)

let record op fields =
  let content = made fields in
  head op (String.length content) ^ content

let put t bytes =
  output_string t.out bytes;
  t.crc <- Crc32.update t.crc bytes;
  t.position <- t.position + String.length bytes

let start out =
  let t =
    {
      out;
      position = 0;
      crc = 0;
      chunk = Buffer.create (full + (full / 4));
      chunk_times = None;
      times = None;
      schemas = [];
      channels = [];
      chunks = [];
      attachments = [];
      all_metadata = [];
    }
  in
  put t magic;
  put t
    (record 0x01 (fun b ->
         text b "";
         text b "frobc"));
  t

(* {1 Attachments and metadata} *)

let attach t ~name ~media_type channel =
  let at = t.position and size = in_channel_length channel in
  let fields =
    made (fun b ->
        u64 b 0;
        u64 b 0;
        text b name;
        text b media_type;
        u64 b size)
  in
  let length = String.length fields + size + 4 in
  put t (head 0x09 length);
  put t fields;
  let rec copy crc left =
    if left = 0 then crc
    else
      let part = really_input_string channel (min left 65536) in
      put t part;
      copy (Crc32.update crc part) (left - String.length part)
  in
  seek_in channel 0;
  let crc = copy (Crc32.update 0 fields) size in
  put t (made (fun b -> u32 b crc));
  let index b =
    u64 b at;
    u64 b (length + 9);
    u64 b 0;
    u64 b 0;
    u64 b size;
    text b name;
    text b media_type
  in
  t.attachments <- record 0x0a index :: t.attachments

let metadata t ~name pairs =
  let at = t.position in
  let add b (key, value) =
    text b key;
    text b value
  in
  let written =
    record 0x0c (fun b ->
        text b name;
        sized b (fun b -> List.iter (add b) pairs))
  in
  put t written;
  let index b =
    u64 b at;
    u64 b (String.length written);
    text b name
  in
  t.all_metadata <- record 0x0d index :: t.all_metadata

(* {1 Messages} *)

let schema t (name, schema) =
  let rec number n = function
    | [] -> None
    | (other, _) :: _ when String.equal other name -> Some n
    | _ :: others -> number (n - 1) others
  in
  match number (List.length t.schemas) t.schemas with
  | Some id -> id
  | None ->
      let id = List.length t.schemas + 1 in
      let fields b =
        u16 b id;
        text b name;
        text b "jsonschema";
        text b schema
      in
      let written = record 0x03 fields in
      Buffer.add_string t.chunk written;
      t.schemas <- (name, written) :: t.schemas;
      id

let channel t ~topic ~schema:given =
  let schema = schema t given and id = List.length t.channels in
  let fields b =
    u16 b id;
    u16 b schema;
    text b topic;
    text b "json";
    sized b ignore
  in
  let written = record 0x04 fields and channel = { id; count = 0; index = [] } in
  Buffer.add_string t.chunk written;
  t.channels <- (channel, written) :: t.channels;
  channel

let interval times time =
  match times with None -> Some (time, time) | Some (first, _) -> Some (first, time)

let of_interval b times =
  let first, last = Option.value times ~default:(0, 0) in
  u64 b first;
  u64 b last

let all_channels t = List.rev_map fst t.channels

(* Writes the message index of each channel for the current chunk. Returns the offsets of the
   indexes and their total length. *)
let write_indexes t =
  let start = t.position in
  let one channel =
    let at = t.position in
    let entry b (time, offset) =
      u64 b time;
      u64 b offset
    in
    let entries b = List.iter (entry b) (List.rev channel.index) in
    put t
      (record 0x07 (fun b ->
           u16 b channel.id;
           sized b entries));
    channel.index <- [];
    (channel.id, at)
  in
  let places = List.map one (List.filter (fun c -> c.index <> []) (all_channels t)) in
  (places, t.position - start)

let end_chunk t =
  if Buffer.length t.chunk > 0 then (
    let records = Buffer.contents t.chunk and at = t.position in
    let size = String.length records in
    let fields =
      made (fun b ->
          of_interval b t.chunk_times;
          u64 b size;
          u32 b (Crc32.update 0 records);
          text b "";
          u64 b size)
    in
    put t (head 0x06 (String.length fields + size));
    put t fields;
    put t records;
    let length = t.position - at and times = t.chunk_times in
    let places, indexes = write_indexes t in
    let place b (id, at) =
      u16 b id;
      u64 b at
    in
    let index b =
      of_interval b times;
      u64 b at;
      u64 b length;
      sized b (fun b -> List.iter (place b) places);
      u64 b indexes;
      text b "";
      u64 b size;
      u64 b size
    in
    t.chunks <- record 0x08 index :: t.chunks;
    t.chunk_times <- None;
    Buffer.clear t.chunk)

let message t channel ~time data =
  channel.index <- (time, Buffer.length t.chunk) :: channel.index;
  let fields =
    made (fun b ->
        u16 b channel.id;
        u32 b channel.count;
        u64 b time;
        u64 b time)
  in
  Buffer.add_string t.chunk (head 0x05 (String.length fields + String.length data));
  Buffer.add_string t.chunk fields;
  Buffer.add_string t.chunk data;
  channel.count <- channel.count + 1;
  t.chunk_times <- interval t.chunk_times time;
  t.times <- interval t.times time;
  if Buffer.length t.chunk >= full then end_chunk t

(* {1 The end} *)

let statistics t b =
  let channels = all_channels t in
  u64 b (List.fold_left (fun sum c -> sum + c.count) 0 channels);
  u16 b (List.length t.schemas);
  u32 b (List.length channels);
  u32 b (List.length t.attachments);
  u32 b (List.length t.all_metadata);
  u32 b (List.length t.chunks);
  of_interval b t.times;
  sized b (fun b ->
      List.iter
        (fun c ->
          u16 b c.id;
          u64 b c.count)
        channels)

let finish t =
  end_chunk t;
  put t (record 0x0f (fun b -> u32 b t.crc));
  let summary = t.position in
  t.crc <- 0;
  let group (op, records) =
    let at = t.position in
    List.iter (put t) (List.rev records);
    record 0x0e (fun b ->
        Buffer.add_uint8 b op;
        u64 b at;
        u64 b (t.position - at))
  in
  let groups =
    [
      (0x03, List.map snd t.schemas);
      (0x04, List.map snd t.channels);
      (0x0b, [ record 0x0b (statistics t) ]);
      (0x08, t.chunks);
      (0x0a, t.attachments);
      (0x0d, t.all_metadata);
    ]
  in
  let offsets = List.map group (List.filter (fun (_, records) -> records <> []) groups) in
  let at = t.position in
  List.iter (put t) offsets;
  put t (head 0x02 20);
  put t
    (made (fun b ->
         u64 b summary;
         u64 b at));
  put t (made (fun b -> u32 b t.crc));
  put t magic
