// A cell for the tests: the real program with a data folder of its own.
import { spawn } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { createServer } from 'node:net';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

const binary = process.env.SEAMWRIGHT_BIN ?? fileURLToPath(new URL('../../target/release/seamwright', import.meta.url));
const WAITS_MS = 60_000;

/** A port that nothing listens on, chosen by the system: several files of tests run at once. */
const freePort = () =>
  new Promise((found, fails) => {
    const server = createServer();
    server.on('error', fails);
    server.listen(0, '127.0.0.1', () => {
      const { port } = server.address();
      server.close(() => found(port));
    });
  });

/** Starts a cell with a job and its machine, or with what it begins with by itself (null); gives the address with the key of the first run, and what ends it. */
export async function startCell(job = 'saddle') {
  const data = mkdtempSync(join(tmpdir(), 'seamwright-e2e-'));
  const args = ['serve', '--bind', `127.0.0.1:${await freePort()}`, '--data', data, ...(job ? ['--job', job] : [])];
  const child = spawn(binary, args, { stdio: ['ignore', 'pipe', 'pipe'] });
  const ended = new Promise((done) => child.on('exit', done));
  // Whatever ends the tests ends the cell.
  process.on('exit', () => child.kill('SIGKILL'));
  const address = await new Promise((found, fails) => {
    let said = '';
    let printed = '';
    // The address with the key of the first run is printed on standard output; lines of the log have it without the key.
    child.stdout.on('data', (chunk) => {
      printed += chunk;
      const match = /http:\/\/\S+(?=\s)/.exec(printed);
      if (match) found(match[0]);
    });
    child.stderr.on('data', (chunk) => (said += chunk));
    child.on('error', fails);
    child.on('exit', (code) => fails(new Error(`the cell ended with ${code}: ${said}`)));
    setTimeout(() => fails(new Error(`the cell said no address: ${said}`)), WAITS_MS).unref();
  });
  return {
    address,
    data,
    async end() {
      child.kill('SIGTERM');
      const late = setTimeout(() => child.kill('SIGKILL'), 10_000);
      await ended;
      clearTimeout(late);
      rmSync(data, { recursive: true, force: true });
    },
  };
}
