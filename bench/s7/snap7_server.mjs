// Snap7's server with DB 1 of 64 bytes, for the comparison. Prints its port. usage: node snap7_server.mjs FOLDER-OF-THE-CLIENTS
import { createRequire } from 'node:module';
import { createServer } from 'node:net';
import { join } from 'node:path';

const require = createRequire(join(process.argv[2], 'package.json'));
const snap7 = require('node-snap7');
const free = createServer().listen(0, '127.0.0.1');
await new Promise((resolve) => free.on('listening', resolve));
const { port } = free.address();
await new Promise((resolve) => free.close(resolve));
const server = new snap7.S7Server();
server.SetResourceless(false);
server.SetParam(server.LocalPort, port);
server.RegisterArea(server.srvAreaDB, 1, Buffer.alloc(64));
if (!server.StartTo('127.0.0.1')) throw new Error(server.ErrorText(server.LastError()));
process.stdout.write(`${port}\n`);
setInterval(() => server.ServerStatus(), 1000); // an object that nobody holds is collected, and the server ends
