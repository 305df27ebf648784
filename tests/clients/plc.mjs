// Merker with a program and its S7 server, and the packages of the clients.
import { spawn } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { createInterface } from 'node:readline';

export const require = createRequire(join(process.env.MERKER_CLIENTS, 'package.json'));

// DB 1: an INT, a REAL, a DINT, bits and a text; MW 20 counts cycles, A 0.0 follows E 0.0, T 1 runs, Z 0 and Z 1 are 42; FC 1 and FB 1 are not called.
const PROGRAM = `DATA_BLOCK DB 1
STRUCT
 number : INT := 5; level : REAL := 1.5; large : DINT := L#-70000; on : BOOL := TRUE; off : BOOL;
 text : STRING [8] := 'box';
END_STRUCT
BEGIN
END_DATA_BLOCK
FUNCTION FC 1 : VOID
BEGIN
NETWORK
 L 7; T MW 30;
END_FUNCTION
FUNCTION_BLOCK FB 1
BEGIN
NETWORK
 L 8; T MW 30;
END_FUNCTION_BLOCK
ORGANIZATION_BLOCK OB 1
BEGIN
NETWORK
 L MW 20; + 1; T MW 20;
 U E 0.0; = A 0.0;
 UN M 0.0; L S5T#90S; SE T 1;
 UN M 0.1; L C#42; S Z 0; S Z 1; S M 0.1;
END_ORGANIZATION_BLOCK
`;

export class Plc {
  // `path`: a project, in place of the program above; `files`: a project by the names and texts of its files;
  // `card`: the folder of its memory card.
  static async start({ path, files = { 'a.awl': PROGRAM }, card } = {}) {
    const plc = new Plc();
    plc.folder = mkdtempSync(join(tmpdir(), 'merker-'));
    for (const [name, text] of Object.entries(files)) writeFileSync(join(plc.folder, name), text);
    const program = path ?? (files['merker.toml'] ? '.' : 'a.awl');
    plc.process = spawn(process.env.MERKER, ['run', program, '--no-workbench', '--s7', '0', ...(card ? ['--card', card] : [])], {
      cwd: plc.folder,
      stdio: ['ignore', 'ignore', 'pipe'],
    });
    plc.told = [];
    plc.ended = new Promise((resolve) => plc.process.on('close', resolve));
    const lines = createInterface({ input: plc.process.stderr });
    await new Promise((resolve) =>
      lines.on('line', (line) => {
        plc.told.push(line);
        resolve();
      }),
    );
    plc.port = Number(plc.told[0].match(/^S7 communication: 127\.0\.0\.1:(\d+)$/)[1]);
    return plc;
  }

  // What it says of its connections.
  async end() {
    this.process.kill('SIGINT');
    await this.ended;
    rmSync(this.folder, { recursive: true });
    return this.told.at(-1);
  }
}

// A client of Snap7, connected. `call(method, …)`: errors are numbers; the client says what they mean. `prepare`: what it
// does before; with SetConnectionParams it already knows whom to call.
export async function snap7Client(plc, prepare = () => {}) {
  const client = new (require('node-snap7').S7Client)();
  client.SetParam(client.RemotePort, plc.port);
  client.call = (method, ...values) =>
    new Promise((resolve, reject) =>
      client[method](...values, (error, result) =>
        error ? reject(new Error(client.ErrorText(error))) : resolve(result),
      ),
    );
  if (prepare(client) === 'knows') await client.call('Connect');
  else await client.call('ConnectTo', '127.0.0.1', 0, 2);
  return client;
}

// Calls until the value is as wanted; the test itself has a limit of time.
export async function until(read, wanted) {
  for (;;) {
    const value = await read();
    if (wanted(value)) return value;
  }
}
