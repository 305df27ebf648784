// Snap7's partner as a program of its own (partner.cpp), and a CPU whose blocks speak to a partner.
import { execFileSync, spawn } from 'node:child_process';
import { once } from 'node:events';
import { createServer } from 'node:net';
import { dirname, join } from 'node:path';
import { createInterface } from 'node:readline';
import { fileURLToPath } from 'node:url';

const PACKAGE = join(process.env.MERKER_CLIENTS, 'node_modules/node-snap7');
const BUILT = join(process.env.MERKER_CLIENTS, 'partner');

// M 0.0 BSEND, M 0.2 EN_R of BRCV, M 0.3 GET, M 0.4 PUT; MD 140 R_ID of BSEND and MW 110 its LEN; MW 100, 102, 104 and 106 count
// DONE, NDR of BRCV, GET and PUT; MW 112, 114, 118, 124 the last STATUS of each with ERROR = 1, MW 108 the LEN that came.
export const PROGRAM = `DATA_BLOCK DB 1
STRUCT
 a : ARRAY [-32768..32765] OF BYTE;
END_STRUCT
BEGIN
END_DATA_BLOCK
DATA_BLOCK DB 2
STRUCT
 a : ARRAY [-32768..32765] OF BYTE;
END_STRUCT
BEGIN
END_DATA_BLOCK
${[12, 13, 14, 15].map((number) => `DATA_BLOCK DB ${number}\nSFB ${number}\nBEGIN\nEND_DATA_BLOCK\n`).join('')}
ORGANIZATION_BLOCK OB 1
BEGIN
NETWORK
 CALL SFB 12, DB 12 (REQ := M 0.0, R := M 0.1, ID := W#16#1, R_ID := MD 140, DONE := M 1.0, ERROR := M 1.1, STATUS := MW 150,
   SD_1 := P#DB1.DBX 0.0 BYTE 65534, LEN := MW 110);
 CALL SFB 13, DB 13 (EN_R := M 0.2, ID := W#16#1, R_ID := DW#16#7, NDR := M 1.2, ERROR := M 1.3, STATUS := MW 152,
   RD_1 := P#DB2.DBX 0.0 BYTE 65534, LEN := MW 116);
 CALL SFB 14, DB 14 (REQ := M 0.3, ID := W#16#1, NDR := M 1.4, ERROR := M 1.5, STATUS := MW 154,
   ADDR_1 := P#DB1.DBX 10.0 BYTE 100, ADDR_2 := P#M 10.0 WORD 1, RD_1 := P#DB2.DBX 0.0 BYTE 100, RD_2 := P#M 160.0 BYTE 2);
 CALL SFB 15, DB 15 (REQ := M 0.4, ID := W#16#1, DONE := M 1.6, ERROR := M 1.7, STATUS := MW 156,
   ADDR_1 := P#DB1.DBX 200.0 BYTE 100, ADDR_2 := P#M 20.3 BOOL 1, SD_1 := P#DB1.DBX 0.0 BYTE 100, SD_2 := P#M 0.4 BOOL 1);
 U M 1.0; SPBN a; L MW 100; + 1; T MW 100;
a: U M 1.2; SPBN b; L MW 102; + 1; T MW 102; L MW 116; T MW 108;
b: U M 1.4; SPBN c; L MW 104; + 1; T MW 104;
c: U M 1.6; SPBN d; L MW 106; + 1; T MW 106;
d: U M 1.1; SPBN e; L MW 150; T MW 112;
e: U M 1.3; SPBN f; L MW 152; T MW 114;
f: U M 1.5; SPBN g; L MW 154; T MW 118;
g: U M 1.7; SPBN h; L MW 156; T MW 124;
h: NOP 0;
END_ORGANIZATION_BLOCK
`;

// A project with one connection; `lines` of its table.
export const project = (lines) => ({
  'a.awl': PROGRAM,
  'merker.toml': `[cpu]\nmodel = "generic"\n[[connection]]\nid = "W#16#1"\n${lines}\n`,
});

// A port where nobody listens now.
export async function freePort() {
  const server = createServer().listen(0, '127.0.0.1');
  await once(server, 'listening');
  const { port } = server.address();
  server.close();
  await once(server, 'close');
  return port;
}

// The sum that the program says of the bytes 1, 2, 3 …
export function sumOf(count) {
  let sum = 0;
  for (let i = 0; i < count; ++i) sum += ((i + 1) & 255) * (1 + (i % 7));
  return sum;
}

export class Partner {
  static async start(line) {
    const core = join(PACKAGE, 'deps/snap7/src');
    const source = join(dirname(fileURLToPath(import.meta.url)), 'partner.cpp');
    const includes = ['core', 'sys', 'lib'].map((folder) => `-I${join(core, folder)}`);
    // Snap7's names are those of C++14.
    const options = ['-std=c++14', '-O1', '-w', ...includes, '-o', `${BUILT}-${process.pid}`, source];
    execFileSync('g++', [...options, join(PACKAGE, 'build/Release/snap7.a'), '-lpthread', '-ldl']);
    const partner = new Partner();
    partner.process = spawn(`${BUILT}-${process.pid}`, { stdio: ['pipe', 'pipe', 'inherit'] });
    partner.said = createInterface({ input: partner.process.stdout })[Symbol.asyncIterator]();
    if ((await partner.ask(line)) !== 'started 0') throw new Error('Snap7 has no partner here');
    return partner;
  }
  async ask(line) {
    this.process.stdin.write(`${line}\n`);
    return (await this.said.next()).value;
  }
  async kill() {
    this.process.kill('SIGKILL');
    await once(this.process, 'close');
  }
}
