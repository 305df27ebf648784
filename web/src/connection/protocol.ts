// Printed by tools/protocol from src/service/workbench/protocol.def; change that file, not this one. Times are nanoseconds of
// virtual time. docs/workbench-protocol.md describes the messages.

/** `row` and `field` of symbols, `rack` and `slot` of a module in merker.toml */
export interface Problem { code: string; severity: 'error' | 'warning'; file: string; line: number; column: number; length: number; text: string; arguments: string[]; row?: number; field?: string; rack?: number; slot?: string }
/** without a project it is empty; `browsers`: how many are at it */
export interface PlcRow { plc: number; project: string; folder: string; mode: string; browsers: number }
export interface WatchItem { operand: string; format?: string }
export interface ModifyItem { operand: string; value: string; format?: string }
/** `item`: its place in the list, from 0 */
export interface RefusedItem { item: number; problem: Problem }
export interface NamedItem { operand: string }
/** an item with a problem stays as "?" */
export interface WatchedItem { operand: string; symbol: string; comment: string; type: string; bits: number; format: string; problem?: Problem }
/** `bits` is 1 for binary values, 0 for a number of a plant or an analog terminal */
export interface CurveItem { operand: string; symbol: string; type?: string; unit?: string; bits?: number; problem?: Problem }
export interface FileRow { path: string; size: number; kind: 'source' | 'symbols' | 'hardware' | 'table' | 'scenario' | 'state' | 'recording' | 'other' }
export interface UnsavedFile { path: string; text: string }
/** addresses of the declared variables */
export interface BlockInterface { block: string; file: string; line: number; variables: { name: string; address: string }[] }
/** `id` and `calls` are like "FC 1" */
export interface BlockRow { id: string; symbol: string; title: string; language: string; load: number; work: number; file: string; line: number; calls: string[]; version: string; checksum: string }
export interface Compared { id: string; state: 'same' | 'different' | 'onlyOffline' | 'onlyOnline'; where: string }
/** in columns and rows of characters. `ends`: the wire begins or ends in the middle of its first or last column; `written`: the operand in the text, if another form of it is shown; `node` names the element by its last statement (`first`: a group without brackets, also by its first one), `pin` its operand. Lines are counted from the first one of the network: `line` of the statement, `value` of the one that loads or transfers the operand (`bcd`: as BCD; `type`: as it is declared, "S5TIME"; `parameter`: of the CALL at `value`); `flow` of a wire: which bits of the program status are ANDed to its signal; without it the signal is not known */
export interface NetworkShape { kind: 'wire' | 'rail' | 'frame' | 'text' | 'contact' | 'coil' | 'negation' | 'field'; x: number; y: number; w: number; h: number; text?: string; written?: string; ends?: 'begins' | 'ends'; node?: number; pin?: number; first?: number; line?: number; value?: number; bcd?: true; type?: string; parameter?: string; flow?: [number, 'vke' | 'sta' | 'notSta'][] }
/** `label`: what jumps lead to; `line`, `end`: its lines in the text; `first`: that of its first statement, 0: none. `reason`: why it stays AWL, and the line of the statement; `sentences`: the network in words */
export interface NetworkPicture { number: number; title: string; comment: string; label: string; line: number; end: number; first: number; view: 'kop' | 'fup' | 'awl'; reason?: string; reasonLine?: number; w: number; h: number; shapes: NetworkShape[]; sentences: string[] }
export interface NetworkElementPlace { node?: number; first?: number }
/** an element; `node` -1: the whole network */
export interface NetworkOrigin { network: number; node?: number; first?: number }
/** at the element or operand that `node`, `pin` and `first` name; -1: the network. `insert`: of an `element` of `networks.elements`; `title` and `comment` of `newNetwork` and `heading`; `label`: what jumps lead to, empty: none. `paste`: the AWL `text`; elements go where `insert` puts one, whole networks (they begin with NETWORK or NETZWERK) before or behind the network, rungs with coils below the one of `node`. `move`: what `from` names */
export interface NetworkEdit { action: 'insert' | 'addInput' | 'negate' | 'closeBranch' | 'setOperand' | 'delete' | 'newRung' | 'paste' | 'move' | 'newNetwork' | 'deleteNetwork' | 'heading' | 'label'; node?: number; pin?: number; first?: number; place?: 'before' | 'behind' | 'parallel' | 'branch' | 'atPin'; element?: string; operands?: string[]; title?: string; comment?: string[]; label?: string; text?: string; from?: NetworkOrigin }
/** names in KOP and FUP; empty: not in this view; `other`: in the other mnemonics. LABEL stands for the action `label` */
export interface NetworkElement { id: string; kop: string; fup: string; group: 'bit' | 'compare' | 'box' | 'move' | 'call' | 'coil'; key?: string; other?: { kop: string; fup: string } }
export interface SymbolEntry { name: string; operand: string; type: string; comment: string }
/** `instanceOf`: the function block of an instance data block */
export interface BlockEntry { id: string; symbol: string; title: string; instanceOf?: string }
/** OB: those of the CPU; of the others the first and the last */
export interface BlockNumbers { OB: number[]; FB: [number, number]; FC: [number, number]; DB: [number, number] }
/** `offset` in bytes or words; `code` is words like "7E03 0004"; `line` is 0 without a source; `initial`, `value`: of a variable or word of a data block */
export interface MachineCodeRow { offset: number; code: string; text: string; line: number; initial: string; value: string }
/** a variable of a data block: `operand` and `format` for `watch.set` and `variables.write`; `address` is like "4.3", of STEP 5 a word; `path` like "Setpoint[2].Speed"; `section` "IN", "OUT", "IN_OUT" or "STAT" of an instance */
export interface DataRow { operand: string; format: string; address: string; path: string; type: string; section: string; initial: string; actual: string; comment: string }
/** a structure that is a data type or an instance: `path` like "Line.Motors[]", of an array its element, whatever its index; `type` is the symbol in quotes, without one like "UDT 1" */
export interface DataStructure { path: string; type: string }
/** `code`: the machine code as instructions; `checksum`: of a block of STEP 7 with its interface, else empty; `source`: from its keyword to its END_, empty for a block without one */
export interface BlockText { id: string; code: string; checksum: string; source: string }
/** `bits`: which of its bits are used as bits */
export interface AssignedByte { area: string; byte: number; bits: number; byByte: boolean; byWord: boolean; byDWord: boolean }
/** `instance`: the data block of a CALL; `from`: where the block is */
export interface UsedBlock { id: string; instance?: string; from: 'program' | 'cpu' | 'library' | 'missing' }
/** `local`: bytes of local data of its own, where the PLC has local data; `uses`: blocks that it calls, data blocks that it opens or accesses */
export interface StructureRow { id: string; local?: number; uses: UsedBlock[] }
/** `access` is "R", "W", "RW" or "CALL" */
export interface Reference { operand: string; symbol: string; block: string; file: string; line: number; network: number; instruction: string; access: string }
export interface SymbolRow { symbol: string; operand: string; type: string; comment: string }
export interface TypedSymbol { symbol: string; operand: string; type?: string; comment?: string }
export interface AddressRange { first: number; bytes: number }
export interface Terminal { text: string; operand: string; symbol: string }
export interface Fault { name: string; title: string; on: boolean }
/** `page` of the modules whose parameters have pages; `fixed`: cannot be changed; `causes`: any of the `choices` */
export interface Parameter { key: string; kind: 'text' | 'address' | 'number' | 'choice' | 'flag' | 'bits' | 'amount' | 'length' | 'characters' | 'causes'; value: string | number | boolean | number[] | string[] | null; given?: boolean; choices?: string[] | number[]; count?: number; group?: number; min?: number; max?: number; hint?: string; page?: string; fixed?: true }
export interface Channel { side: 'input' | 'output' | 'number'; number: number; parameters: Parameter[] }
/** `slot` is like "4" or "2.2"; `parameters` and `channels` only of `hardware.edit` */
export interface Slot { slot: string; order: string; name: string; type: string; kind: string; inputs: AddressRange | null; outputs: AddressRange | null; terminals: Terminal[]; properties: [string, string][]; leds?: Record<string, string>; faults: Fault[]; present: boolean; parameters?: Parameter[]; channels?: Channel[] }
/** with `bus` it is none: the slaves of the AS-Interface at the CP in the slot `place`, or the DP slave with the address `place` */
export interface Rack { rack: number; slots: Slot[]; bus?: 'asi' | 'profibus'; place?: string }
export interface ModuleType { order: string; name: string; text: string; kind: string; slots: [number, number]; inputBytes: number; outputBytes: number; current: number }
export interface KeyValue { key: string; value: string | number | boolean }
/** see below */
export interface Change { change: 'place' | 'remove' | 'move' | 'set' | 'plant'; rack?: number; slot?: string; type?: string; toRack?: number; toSlot?: string; table?: string; key?: string; value?: string | number | boolean | unknown[] | null; side?: string; number?: number; name?: string; kind?: string; parameters?: KeyValue[]; wires?: KeyValue[] }
/** `rack`, `slot` and `name` where a module has this address */
export interface EventModule { address: number; output: boolean; rack?: number; slot?: string; name?: string }
/** `event` is like "16#2521"; `clock` is empty where the PLC has no clock */
export interface DiagnosticEntry { number: number; event: string; time: number; clock: string; text: string; help: string; block?: string; offset?: number; file?: string; line?: number; network?: number; module?: EventModule }
export interface BlockLevel { block: string; offset: number; file?: string; line?: number; network?: number; db: string; di: string }
/** `registers`: AKKU1 ..., those that the PLC has */
export interface InterruptLevel { ob: number; priority: number; registers: Record<string, string>; block: string; offset: number; file?: string; line?: number; network?: number }
/** a temporary variable; `address` is like "4.3" */
export interface LocalRow { address: string; name: string; type: string; value: string; comment: string }
export interface LocalLevel { block: string; bytes: string; rows: LocalRow[] }
export interface PlantValue { name: string; unit: string; value: number; binary: boolean; input: boolean; writable: boolean; min: number; max: number; operand: string; symbol: string; stuck: number | null }
/** of "time" in seconds */
export interface PlantKind { name: string; parameters: { key: string; form: 'number' | 'time' | 'whole' | 'flag'; standard: number; min: number; max: number }[]; signals: { name: string; input: boolean; binary: boolean; unit: string }[] }
/** `parameters` as in merker.toml: times in seconds, true and false as 1 and 0 */
export interface PlantRow { name: string; kind: string; title: string; parameters: Record<string, number>; values: PlantValue[]; faults: Fault[] }
/** the positioning axis of the CPU: its parameters, where each signal of its plant belongs, the instance data blocks of its SFB */
export interface Axis { output: 'analog' | 'digital'; directionSignal: boolean; controlType: number; rotary: boolean; inverted: boolean; rotaryEnd: number; lowLimit: number; highLimit: number; targetRange: number; highestSpeed: number; creepSpeed: number; wires: { signal: string; operand: string }[]; blocks: { id: string; function: number }[] }
/** `data` is base64 */
export interface UploadedPart { path: string; data: string }
/** `quoted`: a problem whose sentence the text contains. [import.md](formats/import.md#the-report) */
export interface ReportRow { effect: 'came' | 'changed' | 'lost' | 'beside'; text: string; quoted?: { code: string; text: string; arguments: string[] } }
/** `can`: what the machine can do; `serial`: it has an interface X27; `empty`: no block in the CPU; `changed`: the first 200 paths that are newer than the program of the CPU; of several stations `station` is the one that is shown and `network` their project, else both are empty */
export interface Project { name: string; folder: string; mpiAddress: number; can: ('breakpoints' | 'cyclePoints' | 'stacks' | 'information' | 'blocks' | 'download' | 'completion' | 'references' | 'symbols' | 'rack' | 'plants' | 'interrupts' | 'engine' | 'snapshots' | 'timersByHand' | 'modeSwitch' | 'leds' | 'clock' | 'nc')[]; family: 'S7' | 'S5'; model: string; example: boolean; serial: boolean; empty: boolean; changed: string[]; station: string; network: string }
/** `rate` is like "187.5 kbit/s"; `ip` on Ethernet, `slaves` of a DP master; PROFIBUS stands behind the others */
export interface PlannedSubnet { name: string; kind: string; rate: string; highest: number; nodes: { station: string; address: number; ip?: string }[]; slaves: { address: number; name: string; model: string }[] }
/** a project of several stations as its merker.toml has it: `shown` is the station that the other requests are about; `model` is empty if a station cannot be read; `circles`: global data, operands with their stations; `connections`: configured S7 connections */
export interface StationsPlan { name: string; shown: string; stations: { name: string; folder: string; model: string }[]; subnets: PlannedSubnet[]; circles: { circle: number; rate: number; from: string; to: string[]; status: string[] }[]; connections: { station: string; kind: string; id: number; active: boolean; partner: string }[]; problems: Problem[] }
/** `frame` is like "8E1"; `partner`: what the simulated partner speaks, `waiting`: bytes that it is still to send; `connection` as in `[serial]` of merker.toml, empty: the partner, `place` where that is, `problem` why it could not be opened; `seen`: all characters so far */
export interface SerialLine { protocol: 'ASCII' | '3964' | '3964R' | 'RK512'; mode: 'RS422' | 'RS422 master' | 'RS485'; baud: number; frame: string; powered: boolean; partner: 'characters' | '3964' | 'RK512'; partnerBaud: number; partnerFrame: string; waiting: number; connection: string; place: string; connected: boolean; problem: string; seen: number }
/** `seconds` since it was connected; octets; `lost`: indications that it did not read */
export interface S7Client { partner: string; kind: 'PG' | 'OP' | 'other'; pdu: number; seconds: number; requests: number; received: number; sent: number; lost: number }
/** of a configured connection; `port` 0: it is the partner that calls; `outside`: on another computer, where clients may not come from */
export interface S7Partner { id: string; host: string; port: number; active: boolean; state: 'connected' | 'calls' | 'waits' | 'outside'; pdu: number }
/** of the station that is shown, `kind` is S7 or what a CP 343-1 speaks; `state` as of S7Partner, `inside`: the partner is a station of the project, `closed`: no server carries it */
export interface ConfiguredConnection { kind: 's7' | 'tcp' | 'iso-on-tcp' | 'udp' | 'e-mail'; id: number; partner: string; active: boolean; state: 'connected' | 'calls' | 'waits' | 'outside' | 'inside' | 'closed' }
/** of an address, the last time `seconds` ago; connections refused: none was free for its kind, it called another rack or slot, too many sockets were open, the station has no power, no subnet leads to the one that it called; broken off: no ISO on TCP, no S7 communication, something did not come in time, answers were not read, another one needed its socket; requests denied: protection, wrong password, wrong setup */
export interface S7Refusal { partner: string; why: 'resource' | 'slot' | 'socket' | 'power' | 'way' | 'transport' | 'protocol' | 'late' | 'unread' | 'room' | 'protection' | 'password' | 'setup'; times: number; seconds: number }
export interface Lamps { SF: 'off' | 'on' | 'slow' | 'fast'; BF: 'off' | 'on' | 'slow' | 'fast'; DC5V: 'off' | 'on' | 'slow' | 'fast'; FRCE: 'off' | 'on' | 'slow' | 'fast'; RUN: 'off' | 'on' | 'slow' | 'fast'; STOP: 'off' | 'on' | 'slow' | 'fast' }
export interface Playback { path: string; actions: number; done: number; state: 'playing' | 'paused' | 'ended' | 'failed'; problem?: Problem }

/** The fields and the result of each request. */
export interface Requests {
  /** MRES is the complete operation (memory reset); without `modeSwitch` only RUN and STOP */
  'cpu.switch': { fields: { position: 'RUN-P' | 'RUN' | 'STOP' | 'MRES' }; result: Record<string, never> };
  'cpu.power': { fields: { on: boolean; battery?: boolean }; result: Record<string, never> };
  'cpu.start': { fields: { kind?: 'warm' | 'cold' }; result: Record<string, never> };
  'cpu.stop': { fields: Record<string, never>; result: Record<string, never> };
  /** memory reset */
  'cpu.reset': { fields: Record<string, never>; result: Record<string, never> };
  /** triggers the event of OB 40, 80, 82, 83, 85 or 86 manually (S7-SIM-13), of the module at this address; for 82, 83, 86 also the outgoing event */
  'cpu.trigger': { fields: { ob: number; address?: number; going?: boolean }; result: Record<string, never> };
  /** sets the clock of the CPU; `time` is like "2005-09-01 08:00:00.000", from 1990 to 2089, parts of a second can be missing */
  'cpu.setClock': { fields: { time: string }; result: Record<string, never> };
  /** only in STOP */
  'cpu.engine': { fields: { engine: 'interpreter' | 'jit' }; result: Record<string, never> };
  /** waits for the end of the cycle and writes the whole CPU into a [file](formats/cpu-state.md), `*.state`; P1308 beyond 8 MB */
  'cpu.save': { fields: { path: string; replace?: boolean }; result: Record<string, never> };
  /** restores the CPU; P1319 for the state of another CPU, P1320 for an invalid file */
  'cpu.load': { fields: { path: string }; result: Record<string, never> };
  /** S5 timers are paused and are set by `variables.write` */
  'timers.mode': { fields: { manual: boolean }; result: Record<string, never> };
  /** these numbers, or all */
  'timers.reset': { fields: { timers?: number[] }; result: Record<string, never> };
  /** records the operations of all browsers on the CPU */
  'record.start': { fields: Record<string, never>; result: Record<string, never> };
  /** into a [file](formats/recording.md), `*.rec`; without a path they are discarded */
  'record.stop': { fields: { path?: string; replace?: boolean }; result: { actions: number } };
  /** each action at its instant of virtual time */
  'play.start': { fields: { path: string }; result: { actions: number } };
  /** pauses the playback while the CPU continues */
  'play.pause': { fields: { on: boolean }; result: Record<string, never> };
  /** ends it */
  'play.stop': { fields: Record<string, never>; result: Record<string, never> };
  'time.pace': { fields: { mode: 'real' | 'fast' | 'pause'; factor?: number }; result: Record<string, never> };
  /** while paused: runs exactly this number of OB 1 cycles */
  'time.step': { fields: { cycles?: number }; result: Record<string, never> };
  /** is only answered */
  'ping': { fields: Record<string, never>; result: Record<string, never> };
  /** `list` is a number chosen by the page; a refused list leaves none of its number; `point`, `once`: see below */
  'watch.set': { fields: { list: number; items: WatchItem[]; everyMs?: number; point?: 'begin' | 'end' | 'stop' | 'now'; once?: boolean }; result: { items: WatchedItem[] } };
  'watch.drop': { fields: { list: number }; result: Record<string, never> };
  'variables.read': { fields: { items: WatchItem[] }; result: { items: { text: string; raw: number | null; problem?: Problem }[] } };
  /** all or none; with `each` those that can be written, and `refused` names the others; an input sets its terminal; a held bit is 0 again when this browser disconnects */
  'variables.write': { fields: { items: ModifyItem[]; held?: boolean; each?: boolean }; result: { refused: RefusedItem[] } };
  /** writes at that point of the cycle: once, or each time until it is dropped */
  'modify.set': { fields: { list: number; items: ModifyItem[]; point: 'begin' | 'end' | 'stop'; once?: boolean; each?: boolean }; result: { refused: RefusedItem[] } };
  'modify.drop': { fields: { list: number }; result: Record<string, never> };
  /** all or none; overlapping operands are refused */
  'variables.force': { fields: { items: ModifyItem[] }; result: Record<string, never> };
  /** without `items`: all */
  'variables.unforce': { fields: { items?: NamedItem[] }; result: Record<string, never> };
  /** operands, or names `plant.X`, `terminal.MODULE.DO0`; `everyMs` is virtual time, 0: every cycle */
  'trend.set': { fields: { list: number; items: NamedItem[]; everyMs?: number }; result: { items: CurveItem[] } };
  /** the answer of `trend.set`, without creating curves */
  'trend.check': { fields: { items: NamedItem[] }; result: { items: CurveItem[] } };
  'trend.drop': { fields: { list: number }; result: Record<string, never> };
  'files.list': { fields: Record<string, never>; result: { files: FileRow[] } };
  'files.read': { fields: { path: string }; result: { text: string; revision: number } };
  /** `revision` is that of the text that was read; another one is refused. Written completely or not at all */
  'files.write': { fields: { path: string; text: string; revision: number }; result: { revision: number } };
  /** missing folders are created, at most 32 within each other */
  'files.create': { fields: { path: string; text?: string }; result: { revision: number } };
  /** a name listed in `[program]` of merker.toml is changed there as well; folders that are empty then go */
  'files.delete': { fields: { path: string }; result: Record<string, never> };
  /** likewise */
  'files.rename': { fields: { path: string; to: string }; result: Record<string, never> };
  /** `files`: unsaved texts in place of the files. Problems are a result here: the first 2,000, and how many more */
  'program.check': { fields: { files?: UnsavedFile[] }; result: { problems: Problem[]; more: number; blocks: number; interfaces?: BlockInterface[] } };
  /** compile and download these blocks, or all; refused in RUN (S7-SIM-11), allowed in RUN-P and STOP; in STOP only if merker.toml has changed */
  'program.load': { fields: { blocks?: string[] }; result: Record<string, never> };
  'program.blocks': { fields: { side?: 'offline' | 'online' }; result: { blocks: BlockRow[] } };
  'program.compare': { fields: Record<string, never>; result: { blocks: Compared[] } };
  /** blocks of the CPU as AWL sources, one file each, never replacing a file: `FC1.awl`, or `online/FC1.awl` for a block that the project has; it is compiled only if `sources` names it */
  'program.upload': { fields: { blocks?: string[] }; result: { files: string[] } };
  /** from the CPU */
  'program.delete': { fields: { blocks: string[] }; result: Record<string, never> };
  'program.listing': { fields: { block: string; side?: 'offline' | 'online'; mnemonics?: 'german' | 'international' }; result: { text: string } };
  /** the code instruction by instruction with the lines of the source; of a data block its variables or words. P1308 for a block of the system, which has none */
  'program.machineCode': { fields: { block: string; side?: 'offline' | 'online'; mnemonics?: 'german' | 'international' }; result: { block: string; file: string; unit: 'byte' | 'word'; rows: MachineCodeRow[] } };
  /** a mnemonic is its word, its operands, its id */
  'program.completion': { fields: Record<string, never>; result: { symbols: SymbolEntry[]; blocks: BlockEntry[]; mnemonics: { german: [string, string, string][]; international: [string, string, string][] }; numbers: BlockNumbers } };
  /** declares the 20 bytes that a new organization block of STEP 7 begins with */
  'program.startInformation': { fields: { ob: number }; result: { text: string } };
  /** cross reference, of one operand or all: the first 20,000 rows, and how many more */
  'program.references': { fields: { operand?: string }; result: { rows: Reference[]; more: number } };
  /** the variables of a data block: the first 20,000, and how many more. Actual values of the project, or with `online` those that the CPU has now. `assignments`: what BEGIN says of them; `without`: the variables whose value no constant says, they are not in it; P1308 for a block without data */
  'program.data': { fields: { block: string; side?: 'offline' | 'online' }; result: { block: string; file: string; instanceOf?: string; assignments: string; without: string[]; rows: DataRow[]; more: number; structures: DataStructure[] } };
  /** the assignment list; symbols that nothing uses, operands that have none */
  'program.assignments': { fields: Record<string, never>; result: { bytes: AssignedByte[]; timers: number[]; counters: number[]; unused: SymbolRow[]; withoutSymbol: string[] } };
  /** each block with code, and what it calls, opens or accesses */
  'program.structure': { fields: Record<string, never>; result: { blocks: StructureRow[] } };
  /** the networks of the block at this line as KOP or FUP; `text`: unsaved, in place of the file. Elements have the names of `mnemonics`, those of the text; reasons and sentences are in `language`. A network without ladder is shown as function blocks, one without either as AWL. P1308 if there is no block */
  'networks.show': { fields: { file: string; text?: string; line: number; view?: 'kop' | 'fup'; language?: 'german' | 'english'; display?: 'written' | 'symbolic' | 'absolute' }; result: { block: string; line: number; end: number; mnemonics: 'german' | 'international'; networks: NetworkPicture[] } };
  /** an element put in, taken out, changed in this network of the block at `line`: lines `from` to before `to` of the text become `lines`, which the browser puts into it; then the element of `network` is selected. In the `view` KOP a network that KOP can draw stays one. P1308 says why an edit is not possible */
  'networks.edit': { fields: { file: string; text: string; line: number; network: number; edit: NetworkEdit; view?: 'kop' | 'fup'; language?: 'german' | 'english' }; result: { from: number; to: number; lines: string[]; network: number; node: number; pin: number; first: number } };
  /** elements of this network as AWL for `paste`, a box without what comes to it; without `elements` the whole network with its title and comment. P1308 says why it is not possible */
  'networks.copy': { fields: { file: string; text: string; line: number; network: number; elements?: NetworkElementPlace[]; language?: 'german' | 'english' }; result: { lines: string[] } };
  /** what can be put into a network */
  'networks.elements': { fields: { mnemonics?: 'german' | 'international' }; result: { elements: NetworkElement[] } };
  /** `block`, or `file` and `line`; each browser has one. `instance`: only the calls of a function block with this instance data block, else the last of all */
  'status.show': { fields: { block?: string; file?: string; line?: number; instance?: number }; result: { block: string } };
  'status.hide': { fields: Record<string, never>; result: Record<string, never> };
  /** all of this file; the answer is where they were placed */
  'breakpoints.set': { fields: { file: string; lines: number[] }; result: { lines: number[] } };
  'debug.go': { fields: Record<string, never>; result: Record<string, never> };
  'debug.step': { fields: { kind?: 'into' | 'over' | 'out' }; result: Record<string, never> };
  /** `problems` of the lines that are no rows: they would be lost with `symbols.write` */
  'symbols.read': { fields: Record<string, never>; result: { path: string; rows: SymbolRow[]; revision: number; problems: Problem[] } };
  /** problems have `row` (from 0) and `field` */
  'symbols.check': { fields: { rows: TypedSymbol[] }; result: { problems: Problem[] } };
  /** with problems nothing is saved (S7-SYM-03) */
  'symbols.write': { fields: { rows: TypedSymbol[]; revision?: number }; result: { revision: number } };
  'symbols.import': { fields: { format: 'asc' | 'sdf' | 'dif' | 'seq' | 'sym'; text: string }; result: { rows: SymbolRow[]; problems: Problem[] } };
  /** these rows, or the table of the project: the text, and as base64 the bytes of the file in the code page of Windows that has most of its characters (437 for STEP 5, 65001 is UTF-8); `missing` of them are '?' in the file */
  'symbols.export': { fields: { format: 'asc' | 'sdf' | 'dif' | 'seq' | 'sym'; rows?: TypedSymbol[] }; result: { text: string; data: string; codePage: number; missing: number } };
  'hardware.read': { fields: Record<string, never>; result: { racks: Rack[] } };
  /** remove/insert, wire break, load voltage ... (as in scenarios) */
  'hardware.fault': { fields: { rack: number; slot: string; fault: string; on: boolean }; result: Record<string, never> };
  'hardware.catalogue': { fields: Record<string, never>; result: { types: ModuleType[] } };
  /** `text` of a merker.toml; nothing is written */
  'hardware.edit': { fields: { text: string; changes?: Change[] }; result: { text: string; racks: Rack[]; cpu: { table: string; parameters: Parameter[] }[]; configured: boolean; current: { rack: number; taken: number; possible: number }[]; problems: Problem[] } };
  /** newest first */
  'diagnosis.buffer': { fields: Record<string, never>; result: { entries: DiagnosticEntry[] } };
  'diagnosis.stacks': { fields: Record<string, never>; result: { blocks: BlockLevel[]; interrupts: InterruptLevel[]; locals: LocalLevel[] } };
  /** module information; 0 or an empty text where the PLC has none */
  'diagnosis.information': { fields: Record<string, never>; result: { model: string; mode: string; stopReason: string; clock: string; memory: Record<string, number | string>; cycle: Record<string, number | string>; limits: Record<string, number | string> } };
  /** S7 communication: an empty place, nobody is served; `beyond`: other computers can come; `connections` null: unlimited; `pg`, `op`, `basic` of them kept */
  'diagnosis.connections': { fields: Record<string, never>; result: { place: string; beyond: boolean; connections: number | null; pg: number; op: number; basic: number; confirmed: number; refused: number; broken: number; requests: number; denied: number; clients: S7Client[]; partners: S7Partner[]; refusals: S7Refusal[]; configured: ConfiguredConnection[] } };
  'process.list': { fields: Record<string, never>; result: { plants: PlantRow[]; axis: Axis | null } };
  /** what can be put beside the CPU */
  'process.kinds': { fields: Record<string, never>; result: { kinds: PlantKind[] } };
  /** the event `process`, at most 30 a second */
  'process.watch': { fields: { on: boolean }; result: Record<string, never> };
  /** as `plant NAME.X = v` of a scenario; P0989 outside `min` and `max`; a held signal is released when this browser disconnects */
  'process.set': { fields: { plant: string; value: string; to: number; held?: boolean }; result: Record<string, never> };
  /** a sensor or actuator, named by its signal, is stuck: at `to`, else at its current value */
  'process.fault': { fields: { plant: string; fault: string; on: boolean; to?: number }; result: Record<string, never> };
  /** back to its start */
  'process.reset': { fields: { plant: string }; result: Record<string, never> };
  /** the event `serial`, at most 5 a second; null without X27 */
  'serial.watch': { fields: { on: boolean }; result: { line: SerialLine | null } };
  /** what the partner or the line does, a step of a scenario without `serial X27`: `send "ABC" CR`, `answer "W" with "01250"`, `partner 3964R`; P0993 without X27 */
  'serial.do': { fields: { step: string }; result: Record<string, never> };
  /** `models`, `sinumerik`: of `projects.new`; `copied`: there is a copy of it in the workspace folder; `projects`: folders below it, relative to it, at most 500 */
  'projects.list': { fields: Record<string, never>; result: { examples: { id: string; title: string; description: string; copied: boolean }[]; templates: { id: string; title: string }[]; models: string[]; sinumerik: string[]; projects: string[]; recent: string[]; folder: string } };
  /** one of them. It is opened for all browsers at this PLC; P1308 if another PLC has it; an example as a copy in the workspace folder so that it can be changed, `fresh`: as one more copy, untouched; in this `language` as far as the example has it */
  'projects.open': { fields: { example?: string; folder?: string; fresh?: boolean; language?: 'english' | 'german' }; result: Record<string, never> };
  /** the files of the open project into a new folder of the workspace; it stays open. `left` as of `download.begin` */
  'projects.copy': { fields: { name: string }; result: { folder: string; files: number; left: string[] } };
  /** wizard (S7-MGR-01); the CPU is in STOP and empty until `program.load` */
  'projects.new': { fields: { name: string; model?: string; mpiAddress?: number; template?: string; mnemonics?: 'german' | 'international'; ob?: string }; result: Record<string, never> };
  /** what programs are compared by: of the open project, with `side` of the CPU, with `folder` of another project of the workspace. P1308 beyond 8 MB */
  'projects.look': { fields: { folder?: string; side?: 'offline' | 'online'; mnemonics?: 'german' | 'international' }; result: { name: string; blocks: BlockText[]; symbols: SymbolRow[]; racks: Rack[] } };
  /** the PLCs of the server, at most 4; `here`: where this browser is */
  'plcs.list': { fields: Record<string, never>; result: { here: number; plcs: PlcRow[] } };
  /** from now on this browser is at that PLC, and all requests and events are about it. It begins at PLC 1, which has the project of the command line, S7 communication and the serial interface. For the PLC that it leaves it has disconnected: what still waits is not answered */
  'plcs.enter': { fields: { plc: number }; result: Record<string, never> };
  'projects.save': { fields: Record<string, never>; result: Record<string, never> };
  'projects.close': { fields: Record<string, never>; result: Record<string, never> };
  /** null: the project has one station */
  'stations.list': { fields: Record<string, never>; result: { network: StationsPlan | null } };
  /** all browsers see this one from now on; all stations go on, this one without breakpoints so far */
  'stations.show': { fields: { station: string }; result: Record<string, never> };
  /** the event `stations`, at most 10 a second */
  'stations.watch': { fields: { on: boolean }; result: Record<string, never> };
  /** to any of them: warm restart, STOP, power supply, memory reset */
  'stations.command': { fields: { station: string; command: 'run' | 'stop' | 'powerOn' | 'powerOff' | 'reset' }; result: Record<string, never> };
  /** the line is broken, or the plug of the `station` pulled; `mend` ends that, without a station all of it. `delay`: telegrams arrive so many nanoseconds later */
  'stations.fault': { fields: { subnet: string; station?: string; fault: 'break' | 'mend' | 'delay'; delay?: number }; result: Record<string, never> };
  /** all are loaded from the disk and started */
  'stations.reload': { fields: Record<string, never>; result: Record<string, never> };
  /** a new station with its folder, on the subnet of this name; then as `stations.reload`, and it is shown */
  'stations.add': { fields: { name: string; model?: string; subnet?: string; address?: number; template?: string; mnemonics?: 'german' | 'international' }; result: Record<string, never> };
  /** global data in a GD circle of their own, operands like `Press/MB 100:8`; then as `stations.reload` */
  'stations.connect': { fields: { from: string; to: string[]; rate?: number }; result: Record<string, never> };
  /** an S7 connection that `local` builds up, over the `subnet` or the first one of both, with the lowest free local IDs; `both`: blocks of the partner name it, too; then as `stations.reload` */
  'stations.link': { fields: { local: string; partner: string; subnet?: string; both?: boolean }; result: Record<string, never> };
  /** the station is on the subnet at this address, and on no other of this kind; without one it leaves it; then as `stations.reload` */
  'stations.node': { fields: { subnet: string; station: string; address?: string }; result: Record<string, never> };
  /** properties of a subnet; with a `kind` a new one, if there is none of this name. A new PROFIBUS subnet has the station `master` as its DP master and an ET 200M as its first slave; the slaves of a subnet go with it. An empty text and 0 change nothing; then as `stations.reload` */
  'stations.subnet': { fields: { subnet: string; kind?: 'mpi' | 'ethernet' | 'profibus'; master?: string; baud?: string; highest?: number; remove?: boolean }; result: Record<string, never> };
  /** a new project in the workspace folder whose first station is a copy of the project that is open */
  'stations.make': { fields: { name: string; station: string }; result: Record<string, never> };
  /** writes the project as a zip, for this browser; `left`: what is not in it, folders end with `/`. P1308 beyond 256 MB */
  'download.begin': { fields: Record<string, never>; result: { name: string; size: number; files: number; left: string[] } };
  /** up to 1 MB of the zip from this byte on, as base64; empty behind its end */
  'download.piece': { fields: { at: number }; result: { data: string } };
  /** the zip is no longer needed */
  'download.end': { fields: Record<string, never>; result: Record<string, never> };
  /** what has been sent so far is deleted. P1308 while another browser imports */
  'import.begin': { fields: Record<string, never>; result: Record<string, never> };
  /** bytes to the ends of files, up to 1,000 parts a request, 20,000 files and 256 MB in all (P1314) */
  'import.add': { fields: { files: UploadedPart[] }; result: Record<string, never> };
  /** what was sent: its programs (none: single files) by names that differ, a name for a new project; `step7`, `step5`: what family it is of; `loose`: single files that can go into the open project. P1308 if nothing in it is known */
  'import.look': { fields: Record<string, never>; result: { programs: string[]; name: string; step7: boolean; step5: boolean; loose: boolean } };
  /** `name`: into a new project of this name in the workspace folder, several programs into folders of it; without a name into the open project, where no file is replaced. `program`: only this one. `codePage`: of texts that are not Unicode, empty: as the source says or by their content */
  'import.run': { fields: { name?: string; program?: string; codePage?: '' | '437' | '850' | '852' | '866' | '932' | '936' | '949' | '950' | '1250' | '1251' | '1252' | '1253' | '1254' | '1255' | '1256' | '1257' | '20866' }; result: { folders: string[]; files: string[]; lost: boolean; report: ReportRow[]; more: number } };
  /** ends the import and deletes what was sent, as when the browser disconnects */
  'import.cancel': { fields: Record<string, never>; result: Record<string, never> };
}

/** What the server sends by itself. */
export interface Events {
  /** what changed; see above */
  state: { project?: Project | null; mode?: 'RUN' | 'STOP' | 'STARTUP' | 'HALT'; powered?: boolean; switch?: 'RUN-P' | 'RUN' | 'STOP' | 'MRES'; leds?: Lamps; stopReason?: string; time?: number; clock?: string; cycles?: number; cycle?: { last: number; min: number; max: number } | null; pace?: { mode: 'real' | 'fast' | 'pause'; factor: number }; reached?: number; engine?: 'interpreter' | 'jit'; forces?: { operand: string; value: string }[]; breakpoint?: { file: string; line: number; block: string; why: string } | null; breakpoints?: Record<string, number[]>; timersByHand?: boolean; recording?: { since: number; actions: number; full: boolean } | null; playback?: Playback | null; diagnostics?: number; program?: number; files?: number; browsers?: number; plcs?: { here: number; count: number } };
  /** only changed items (all the first time): index, text, value as a number (unsigned bits, REAL as a number). `done` marks the last event of a list that is triggered once */
  values: { list: number; time: number; values: [number, string, number | null][]; done?: true };
  /** follows each modification of `modify.set` */
  modified: { list: number };
  /** time in ms, then the values of the curves */
  samples: { list: number; rows: (number | null)[][] };
  /** program status: line, vke, sta, or, akku1, akku2, ar1, ar2, stw, db, di of the reached lines (empty: a register that the PLC does not have), and of a CALL what its operands held, by parameter, of S, R, FP and FN a local bit, by its name; null while the block does not run. Of a function block of S7: `instances`, the instance data blocks of its calls seen so far, at most 256, and `instance`, that of the call that is shown */
  status: { block: string; file: string; calls: number; instances: number[]; instance?: number; rows: [number, string, string, string, string, string, string, string, string, string, string, Record<string, string>][] | null };
  /** values by plant and signal; `axis`: those of the positioning axis, by the names that scenarios have for them */
  process: { time: number; plants: Record<string, Record<string, number>>; stuck: Record<string, Record<string, number>>; axis: Record<string, number> | null };
  /** characters on the line of X27, numbered from `first` on: from (0 X27, 1 its partner), value, name, meaning, first and last instant. At most 1,000; what nobody fetched in time is lost, and `first` leaves a gap */
  serial: { first: number; rows: [number, number, string, string, number, number][]; line: SerialLine };
  /** in the order of `stations.list`: `busy`: nanoseconds that the line was busy so far, `pulled`: stations whose plug is pulled; `circles`: the status words of global data in the order of `status` */
  stations: { time: number; stations: { mode: 'RUN' | 'STOP' | 'STARTUP' | 'HALT'; powered: boolean; leds: Lamps; reason: string }[]; subnets: { busy: number; interrupted: boolean; pulled: string[]; delay: number }[]; circles: number[][] };
  /** see above */
  stalled: { place: string; seconds: number };
}

/** The fields of the state, by their names. */
export const stateFields = ['project', 'mode', 'powered', 'switch', 'leds', 'stopReason', 'time', 'clock', 'cycles', 'cycle', 'pace', 'reached', 'engine', 'forces', 'breakpoint', 'breakpoints', 'timersByHand', 'recording', 'playback', 'diagnostics', 'program', 'files', 'browsers', 'plcs'] as const;
