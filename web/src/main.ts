import { mount } from 'svelte';
import App from './app/App.svelte';
import { followHash } from './app/route.svelte';
import { connection } from './connection';
import { enterPlc } from './connection/plcs';
import './design/tokens.css';
import './design/base.css';
import './design/table.css';
import { followPlc } from './state/plc.svelte';

followHash();
enterPlc(connection, location.href);
followPlc();
connection.start();
mount(App, { target: document.getElementById('page')! });
