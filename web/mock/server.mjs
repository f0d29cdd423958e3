// A stand-in for the cell's server while the panel is made: `npm run mock`, then `npm run dev` and http://127.0.0.1:5173/#key=mock.
// `node mock/server.mjs PORT FOLDER` serves a built panel too. Everybody may everything; nothing is kept.
import { createServer } from 'node:http';
import { readFileSync, existsSync } from 'node:fs';
import { extname, join, normalize } from 'node:path';
import { WebSocketServer } from 'ws';
import { Cell } from './cell.mjs';
import { machine, work } from './weld.mjs';

const port = Number(process.argv[2] ?? 8080);
const folder = process.argv[3];
const examples = new URL('../../examples/', import.meta.url);
const TYPES = { '.html': 'text/html', '.js': 'text/javascript', '.css': 'text/css', '.svg': 'image/svg+xml' };
const may = ['switch_on', 'switch_off', 'home', 'start_jog', 'start_teach', 'start_dry_run', 'arm', 'start_weld', 'hold', 'resume', 'reverse', 'stop', 'override', 'reset', 'acknowledge', 'jog', 'take_control', 'jobs.write', 'plan', 'load', 'edit', 'records.read', 'audit.read', 'tune', 'users.write', 'backup'];

const sockets = new Map();
let holder = null;
let stations = 0;
const all = (message) => sockets.forEach((_, socket) => socket.send(JSON.stringify(message)));
const cell = new Cell(all);
const jobs = new Map(['saddle.toml', 'ellipse.toml', 't-joint.toml', 'hillside.toml'].map((name) => [name, { text: readFileSync(new URL(name, examples), 'utf8'), example: true }]));
const row = ([name, { text, example }]) => ({ name, title: /title = "(.*)"/.exec(text)?.[1] ?? name, example });
const weld = { id: 1, part: 'N-17', title: work(1, 'saddle.toml', null).title, simulated: true, begun: '2026-01-02T10:00:00Z', ended: '2026-01-02T10:06:00Z', result: 'good', note: '', machine: machine.name, procedure: '135-saddle', welder: 'A. Welder', heat_input_kj_mm: [0.61, 0.65, 0.7], worst_deviation_mm: [0.12, 804.2] };

function trace(columns) {
  const { path } = work(1, '', null).passes[0];
  const of = { pass: () => 1, s_mm: (p) => p.s_mm, arc: () => 1, tip_speed_mm_s: (p) => p.speed_mm_s, path_error_mm: (p, i) => 0.05 + 0.03 * Math.sin(i / 9), current_a: (p) => p.values[0] };
  return { columns, values: columns.map((name) => path.map((p, i) => of[name]?.(p, i) ?? null)) };
}

function control() {
  sockets.forEach((client, socket) => socket.send(JSON.stringify({ kind: 'control', station: holder?.station ?? null, user: holder ? 'mock' : null, mine: client === holder })));
}

const routes = [
  ['POST', /^\/api\/login$/, () => session()],
  ['GET', /^\/api\/session$/, () => session()],
  ['POST', /^\/api\/logout$/, () => null],
  ['POST', /^\/api\/stop$/, () => (cell.ask({ do: 'stop' }), { mode: cell.mode, cycle_age_s: 0.01 })],
  ['GET', /^\/api\/machine$/, () => machine],
  ['GET', /^\/api\/machine\/of-job$/, () => machine],
  ['GET', /^\/api\/alarms\/catalogue$/, () => []],
  ['GET', /^\/api\/jobs$/, () => [...jobs].map(row)],
  ['GET', /^\/api\/jobs\/(.+)$/, (_, [name]) => ({ text: jobs.get(name)?.text ?? '' })],
  ['PUT', /^\/api\/jobs\/(.+)$/, ({ text }, [name]) => jobs.set(name, { text, example: false }) && row([name, jobs.get(name)])],
  ['DELETE', /^\/api\/jobs\/(.+)$/, (_, [name]) => void jobs.delete(name)],
  ['POST', /^\/api\/plan$/, () => ({ kind: 'planned', work: work(99, '', null) })],
  ['POST', /^\/api\/draft$/, () => draft()],
  ['GET', /^\/api\/devices$/, () => devices()],
  ['POST', /^\/api\/load$/, ({ job, from, part, overlap_mm }) => cell.load(job, from, part, overlap_mm) ?? cell.work],
  ['GET', /^\/api\/work$/, () => cell.work],
  ['POST', /^\/api\/post$/, () => ({ text: 'G21\nG1 X0\nM2\n', proof: ['read back: 0.001 mm'] })],
  ['POST', /^\/api\/edit$/, ({ text }) => ({ text, words: [] })],
  // It reads no files: forms are empty.
  ['POST', /^\/api\/form$/, ({ text }) => ({ text, form: { tables: [], passes: [] }, wrong: null })],
  ['GET', /^\/api\/records$/, () => [weld]],
  ['GET', /^\/api\/records\/\d+$/, () => ({ weld, values: [], alarms: [], events: [], columns: [['pass', ''], ['s_mm', 'mm'], ['arc', ''], ['tip_speed_mm_s', 'mm/s'], ['path_error_mm', 'mm'], ['current_a', 'A']], rows: 361 })],
  ['GET', /^\/api\/records\/\d+\/work$/, () => work(1, '', null)],
  ['GET', /^\/api\/records\/\d+\/trace$/, (_, __, query) => trace(query.get('columns').split(','))],
  ['GET', /^\/api\/audit$/, () => []],
  ['GET', /^\/api\/position$/, () => ({ axes: cell.axes, tip: cell.status().tip })],
  ['GET', /^\/api\/tuning$/, (_, __, query) => tuning(query.get('axis'))],
  ['POST', /^\/api\/place$/, ({ text, points }) => ({ text: `offset = "touched"\n${text}\n[offsets.touched]\nmove_mm = [1, 2, 3]\n`, move_mm: [1, 2, 3], angle_deg: 0, residuals_mm: points.map(() => 0.01), outliers: points.map(() => false), rms_mm: 0.01, notes: [] })],
  ['GET', /^\/api\/users$/, () => []],
];

function draft() {
  const { part, fixtures, sections } = work(99, '', null);
  return { kind: 'drawn', part, fixtures, sections };
}

function devices() {
  const signal = (name, kind, place, value, more = {}) => ({ name, kind, place, bit: true, unit: '', value, safe: kind === 'output' ? 0 : null, wanted: null, condition: null, ...more });
  const status = cell.status();
  const door = { wanted: true, condition: 'door' };
  const signals = [signal('inputs.door_closed', 'input', 'discrete 0', 1, door), signal('inputs.gas_pressure', 'input', 'discrete 1', 0, { wanted: true, condition: 'gas pressure' }), signal('outputs.gas', 'output', 'coil 0', status.process.gas ? 1 : 0), signal('outputs.on', 'output', 'coil 1', status.process.on ? 1 : 0), signal('actual.current_a', 'actual', 'input 4', status.process.measured[0], { bit: false, unit: 'A' })];
  const traffic = { polls: Math.round(status.t * 100), missed: 0, failed: 1, connections: 1, away_s: 0, round_us: [820, 2100, 4300], trouble: null };
  return [{ name: 'source', address: '192.168.1.20:502', unit: 1, poll_s: 0.01, watchdog_s: 0.1, signals, traffic }];
}

/** An integrator with a drive of 40 Hz behind it. */
function tuning(axis) {
  const response = Array.from({ length: 60 }, (_, i) => {
    const f = 1.1 ** i;
    return [f, 20 * Math.log10(8 / f) - 10 * Math.log10(1 + (f / 40) ** 2), -90 - (Math.atan(f / 40) * 180) / Math.PI - f * 0.9];
  });
  return { axis, unit: 'mm', assumed_drive: false, refused: null, response, gain_margin: [11.2, 36], phase_margin: [65, 8], values: [['kp_per_s', 50.3], ['bandwidth_hz', 12.1]] };
}

function session() {
  return { user: 'mock', role: 'admin', may, token: 'mock', first_run: false };
}

const server = createServer(async (request, response) => {
  const url = new URL(request.url, 'http://mock');
  let text = '';
  for await (const chunk of request) text += chunk;
  response.setHeader('content-security-policy', "default-src 'self'; frame-ancestors 'none'");
  for (const [method, path, answer] of routes) {
    const match = method === request.method && path.exec(url.pathname);
    if (!match) continue;
    const body = answer(text ? JSON.parse(text) : {}, match.slice(1).map(decodeURIComponent), url.searchParams);
    response.writeHead(body === undefined ? 204 : 200, { 'content-type': 'application/json' });
    response.end(body === undefined ? '' : JSON.stringify(body));
    return;
  }
  const file = folder && join(folder, normalize(url.pathname === '/' ? '/index.html' : url.pathname));
  if (file && existsSync(file)) {
    response.writeHead(200, { 'content-type': TYPES[extname(file)] ?? 'application/octet-stream' });
    response.end(readFileSync(file));
  } else {
    response.writeHead(404, { 'content-type': 'application/json' });
    response.end(JSON.stringify({ key: 'not_found', code: 'text', text: url.pathname, arguments: [['text', { type: 'text', value: url.pathname }]] }));
  }
});

new WebSocketServer({ server, path: '/api/live' }).on('connection', (socket) => {
  const client = { station: (stations += 1) };
  sockets.set(socket, client);
  socket.send(JSON.stringify({ kind: 'hello', station: client.station, version: 'mock' }));
  socket.send(JSON.stringify({ kind: 'machine', number: 1 }));
  control();
  for (const message of [{ kind: 'work', work: cell.work }, { kind: 'alarms', list: cell.alarms }, ...cell.events]) socket.send(JSON.stringify(message));
  socket.on('close', () => {
    sockets.delete(socket);
    if (holder === client) holder = null;
    control();
  });
  socket.on('message', (data) => {
    const message = JSON.parse(data);
    if (message.kind === 'take_control' && (!holder || message.over)) holder = client;
    if (message.kind === 'give_control' && holder === client) holder = null;
    if (message.kind.endsWith('_control')) control();
    if (message.kind === 'jog' && holder === client) cell.jog(message.of, message.speeds);
    if (message.kind === 'why') socket.send(JSON.stringify({ kind: 'why', ask: message.ask, lacks: cell.lacks(message.ask) }));
    if (message.kind === 'command') {
      const why = cell.ask(message.ask);
      socket.send(JSON.stringify({ kind: 'answer', seq: message.seq, ok: why === null, why }));
    }
  });
});

setInterval(() => {
  cell.step();
  all(cell.status());
}, 33);
server.listen(port, '127.0.0.1', () => console.log(`panel: http://127.0.0.1:${port}/#key=mock`));
