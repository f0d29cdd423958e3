import { svelte } from '@sveltejs/vite-plugin-svelte';
import { defineConfig } from 'vitest/config';
import FIRST from './src/words/first.json' with { type: 'json' };

// The cell's server while developing: `seamwright serve`.
const cell = process.env['SEAMWRIGHT_CELL'] ?? 'http://127.0.0.1:8080';

function chunkOfWords(path: string): string | null {
  const [, language = '', area = ''] = /\/messages\/(\w+)\/(\w+)\./.exec(path) ?? [];
  if (language === '') return null;
  return `${FIRST.includes(area) ? 'words' : 'messages'}-${language}`;
}

export default defineConfig({
  plugins: [svelte()],
  build: {
    target: 'es2022',
    // Licences of the packages in the panel: `seamwright licences` prints them.
    license: { fileName: 'third-party.json' },
    // The server allows only its own origin: nothing as a data: address.
    assetsInlineLimit: 0,
    modulePreload: { polyfill: false },
    // Three alone is larger than the default; scripts/web-test holds the sum to a budget.
    chunkSizeWarningLimit: 1100,
    // Two files a language: the words that every page needs, and those of the cell's messages.
    rolldownOptions: { output: { codeSplitting: { groups: [{ test: /\/messages\//, name: chunkOfWords }] } } },
  },
  worker: { format: 'es' },
  // The catalogues lie beside this folder.
  server: { fs: { allow: ['..'] }, proxy: { '/api': { target: cell, ws: true, changeOrigin: true, headers: { origin: cell } } } },
  // Loading all words takes a while on a busy computer.
  test: { include: ['src/**/*.test.ts'], environment: 'node', setupFiles: 'src/page.stub.ts', testTimeout: 60_000 },
});
