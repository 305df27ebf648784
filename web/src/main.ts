import { mount } from 'svelte';
import App from './app/App.svelte';
import { followHash } from './app/route.svelte';
import { connection } from './connection';
import './design/tokens.css';
import './design/base.css';
import './design/table.css';
import { followPlc } from './state/plc.svelte';
import { enterOwnPlc } from './projects/enter';

followHash();
followPlc(enterOwnPlc());
connection.start();
mount(App, { target: document.getElementById('page')! });
