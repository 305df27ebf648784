// Clients of S7 communication: who is connected, and whether other computers can come.
import { connection, type Requests } from '../connection';

export type S7 = Requests['diagnosis.connections']['result'];

class Communication {
  state = $state<S7 | null>(null);
  load = async () => {
    this.state = await connection.ask('diagnosis.connections').catch(() => this.state);
  };
}

export const s7 = new Communication();
