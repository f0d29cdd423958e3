import { svelte } from '@sveltejs/vite-plugin-svelte';
import { defineConfig } from 'vitest/config';

// The cell's server, or the mock's (`npm run mock`), while developing.
const cell = process.env['SEAMWRIGHT_CELL'] ?? 'http://127.0.0.1:8080';

export default defineConfig({
  plugins: [svelte()],
  build: {
    target: 'es2022',
    // The server allows only its own origin: nothing as a data: address.
    assetsInlineLimit: 0,
    modulePreload: { polyfill: false },
    // Three alone is larger than the default; scripts/web-test holds the sum to a budget.
    chunkSizeWarningLimit: 1000,
  },
  worker: { format: 'es' },
  // The words that reports have too lie beside this folder.
  server: { fs: { allow: ['..'] }, proxy: { '/api': { target: cell, ws: true } } },
  test: { include: ['src/**/*.test.ts'], environment: 'node' },
});
