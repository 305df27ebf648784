import { svelte } from '@sveltejs/vite-plugin-svelte';
import { defineConfig } from 'vitest/config';

// Relative addresses: the page works below any path. No inlined assets: the server's content security policy allows
// scripts and styles from files only.
export default defineConfig({
  base: './',
  plugins: [svelte({ compilerOptions: { cssHash: ({ hash, css }) => `m-${hash(css)}` } })],
  build: {
    target: 'es2022',
    assetsInlineLimit: 0,
    modulePreload: { polyfill: false },
    reportCompressedSize: false,
    chunkSizeWarningLimit: 1200,
  },
  test: { environment: 'node', include: ['src/**/*.test.ts'] },
});
