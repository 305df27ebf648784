export { default as Button } from './Button.svelte';
export { default as Dialog } from './Dialog.svelte';
export { default as Paper } from './Paper.svelte';
export { default as Led } from './Led.svelte';
export { default as Splitter } from './Splitter.svelte';
export { default as Tabs } from './Tabs.svelte';
export { default as Toggle } from './Toggle.svelte';
export { default as VirtualBody } from './VirtualBody.svelte';
