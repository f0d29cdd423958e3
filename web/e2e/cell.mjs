// A cell for the tests: the real program with a data folder of its own, or the mock if there is none.
import { spawn, spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, rmSync } from 'node:fs';
import { createServer } from 'node:net';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

const web = fileURLToPath(new URL('..', import.meta.url));
const binary = process.env.SEAMWRIGHT_BIN ?? join(web, '../target/release/seamwright');
const WAITS_MS = 60_000;

/** True if the real program is there and has a panel. */
export const isReal = existsSync(binary) && spawnSync(binary, ['serve', '--help']).status === 0;
/** Why what needs a cell is not tested. */
export const NO_CELL = `no program at ${binary}: set SEAMWRIGHT_BIN, or cargo build --release`;
if (!isReal) console.error(`\n!!! WHAT NEEDS A CELL IS SKIPPED, THE REST TRIED ON A MOCK: ${NO_CELL}\n`);

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
  const port = await freePort();
  const command = isReal ? [binary, 'serve', '--bind', `127.0.0.1:${port}`, '--data', data, ...(job ? ['--job', job] : [])] : mock(port);
  return started(command, data);
}

/** Starts the mock, also where there is a program: for what a cell does only when it breaks down. `at` is the port of one that has ended. */
export async function startMock(port) {
  const at = port ?? (await freePort());
  const made = await started(mock(at), mkdtempSync(join(tmpdir(), 'seamwright-e2e-')));
  return { ...made, again: () => startMock(at) };
}

const mock = (at) => [process.execPath, join(web, 'mock/server.mjs'), String(at), join(web, 'dist')];

async function started([command, ...args], data) {
  const child = spawn(command, args, { stdio: ['ignore', 'pipe', 'pipe'] });
  const ended = new Promise((done) => child.on('exit', done));
  const address = await new Promise((found, fails) => {
    let said = '';
    const take = (chunk) => {
      said += chunk;
      const match = /http:\/\/\S+/.exec(said);
      if (match) found(match[0]);
    };
    child.stdout.on('data', take);
    child.stderr.on('data', take);
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
