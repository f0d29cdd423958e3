import { read, replaced, type Entry, type Value } from './toml';

/** Where a solid stands in the text: fixtures in the work frame, the part's own in that of the seam. */
export type List = 'fixtures' | 'part.solids';

/** Numbers of a shape by their keys in files; lists are three numbers. */
export type Shape = { kind: string; sizes: { key: string; numbers: number[] }[] };

/** A solid of a job: mm and degrees. */
export type Solid = {
  list: List;
  index: number;
  name: string;
  shape: Shape;
  move: [number, number, number];
  turn: [number, number, number];
  angle: number;
  /** Written in a way that only the text can change. */
  fixed: boolean;
};

/** Shapes that can be added, with sizes to begin with. */
export const PRIMITIVES: Record<string, Record<string, number | number[]>> = {
  box: { size_mm: [40, 40, 40] },
  cylinder: { radius_mm: 20, length_mm: 60 },
  sphere: { radius_mm: 20 },
  cone: { radius_mm: 20, top_radius_mm: 10, length_mm: 40 },
  capsule: { radius_mm: 15, length_mm: 80 },
  ellipsoid: { semi_axes_mm: [30, 20, 10] },
};

type Place = [number, number, number];
export const NOWHERE: Place = [0, 0, 0];
/** So far from the seam something new is in sight, but seldom in the torch's way, mm. */
const BESIDE_MM = 200;

/** A place for something new beside where a seam with these tips begins, away from its middle. */
export function beside(tips: Place[]): Place {
  const [first] = tips;
  if (!first) return NOWHERE;
  const middle = [0, 1, 2].map((i) => tips.reduce((sum, tip) => sum + (tip[i] ?? 0), 0) / tips.length);
  const [x, y] = [first[0] - (middle[0] ?? 0), first[1] - (middle[1] ?? 0)];
  const length = Math.hypot(x, y);
  const [dx, dy] = length < 1 ? [1, 0] : [x / length, y / length];
  return [first[0] + BESIDE_MM * dx, first[1] + BESIDE_MM * dy, first[2]].map((v) => Math.round(v) + 0) as Place;
}

const LISTS: List[] = ['fixtures', 'part.solids'];

type Block = { list: List; index: number; entries: Entry[] };

/** The entries of each solid, tables within it too. */
function blocks(text: string): Block[] {
  const found = new Map<string, Block>();
  for (const entry of read(text)) {
    for (const list of LISTS) {
      const match = new RegExp(`^${list.replace('.', '\\.')}\\.(\\d+)(\\.|$)`).exec(entry.table);
      if (!match) continue;
      const key = `${list}.${match[1]}`;
      const block = found.get(key) ?? { list, index: Number(match[1]), entries: [] };
      found.set(key, block);
      block.entries.push({ ...entry, table: entry.table.slice(key.length + 1) });
    }
  }
  return [...found.values()];
}

/** What stands at a path of keys, as a dotted key, a table within or an inline one; its inner entries, if it is a table. */
function inner(entries: Entry[], key: string): { value: Value | null; entries: Entry[] } {
  const plain = entries.find((entry) => entry.table === '' && entry.key === key);
  if (plain) return { value: plain.value, entries: plain.value.kind === 'table' ? plain.value.entries : [] };
  const within = entries.filter((entry) => entry.table === key || entry.table.startsWith(`${key}.`));
  return { value: null, entries: within.map((entry) => ({ ...entry, table: entry.table.slice(key.length + 1) })) };
}

function numbers(value: Value | undefined): number[] {
  if (value?.kind === 'number') return [value.number];
  return value?.kind === 'list' ? value.items.map((item) => (item.kind === 'number' ? item.number : NaN)) : [];
}

const three = (list: number[], otherwise: [number, number, number]): [number, number, number] =>
  list.length === 3 ? (list as [number, number, number]) : otherwise;

/** The solids of a job's text. */
export function solidsOf(text: string): Solid[] {
  return blocks(text).map(({ list, index, entries }) => {
    const shape = inner(entries, 'shape');
    const kind = shape.entries.find((entry) => entry.table === '') ?? shape.entries[0];
    const name = kind?.table === '' ? kind.key : (kind?.table.split('.')[0] ?? '');
    const sizes = kind ? inner(shape.entries, name).entries : [];
    const at = inner(entries, 'at').entries;
    const of = (key: string): number[] => numbers(at.find((entry) => entry.key === key)?.value);
    const title = entries.find((entry) => entry.table === '' && entry.key === 'name')?.value;
    // Tables with headers of their own are for the text.
    const own = entries.some((entry) => entry.table === 'at' || entry.table.startsWith('shape.'));
    return {
      list,
      index,
      name: title?.kind === 'text' ? title.text : '',
      shape: { kind: name, sizes: sizes.map((entry) => ({ key: entry.key, numbers: numbers(entry.value) })) },
      move: three(of('move_mm'), [0, 0, 0]),
      turn: three(of('turn'), [0, 0, 1]),
      angle: of('angle_deg')[0] ?? 0,
      fixed: own || !(name in PRIMITIVES) || sizes.some((entry) => numbers(entry.value).some(Number.isNaN)),
    };
  });
}

function written(value: number | number[]): string {
  // A millionth of a millimetre is beyond any machine; TOML wants no `-0`.
  const short = (n: number): string => String(Number(n.toFixed(6)) + 0);
  return Array.isArray(value) ? `[${value.map(short).join(', ')}]` : short(value);
}

function shapeText({ kind, sizes }: Shape): string {
  const inside = sizes.map(({ key, numbers: list }) => `${key} = ${written(list.length === 1 ? (list[0] ?? 0) : list)}`);
  return `shape.${kind} = { ${inside.join(', ')} }`;
}

function atText({ move, turn, angle }: Solid): string {
  const turned = angle === 0 ? '' : `, turn = ${written(turn)}, angle_deg = ${written(angle)}`;
  return `at = { move_mm = ${written(move)}${turned} }`;
}

/** Lines of the text that belong to a solid: from its header to the next one, without the comment over that. */
function lines(text: string, list: List, index: number): { from: number; to: number } | null {
  const header = new RegExp(`^[ \\t]*\\[\\[\\s*${list.replace('.', '\\s*\\.\\s*')}\\s*\\]\\]`);
  const rows = text.split('\n');
  const starts: number[] = [];
  let at = 0;
  let count = -1;
  let found: { from: number; to: number } | null = null;
  for (const [i, row] of rows.entries()) {
    starts.push(at);
    at += row.length + 1;
    if (!/^[ \t]*\[/.test(row)) continue;
    const own = new RegExp(`^[ \\t]*\\[\\[?\\s*${list.replace('.', '\\s*\\.\\s*')}\\s*\\.`).test(row);
    if (found && found.to === Infinity && !own) {
      let end = i;
      while (end > 0 && /^[ \t]*(#|$)/.test(rows[end - 1] ?? '')) end -= 1;
      found.to = starts[end] ?? 0;
    }
    if (header.test(row) && (count += 1) === index) found = { from: starts[i] ?? 0, to: Infinity };
  }
  if (found && found.to === Infinity) found.to = text.length;
  return found;
}

/** The text with a solid changed; its comments stay. */
export function changed(text: string, solid: Solid): string {
  const block = blocks(text).find((of) => of.list === solid.list && of.index === solid.index);
  const range = lines(text, solid.list, solid.index);
  if (!block || !range || solid.fixed) return text;
  const had = solidsOf(text).find((of) => of.list === solid.list && of.index === solid.index);
  const edits: { from: number; to: number; by: string }[] = [];
  const headerEnd = text.indexOf('\n', range.from) + 1 || text.length;
  const whole = (key: string, table: string): Entry | undefined => block.entries.find((entry) => entry.key === key && entry.table === table);
  const put = (entry: Entry | undefined, line: string, value: string): void => {
    if (entry) edits.push({ from: entry.value.from, to: entry.value.to, by: value });
    else edits.push({ from: headerEnd, to: headerEnd, by: `${line}\n` });
  };
  const after = (line: string): string => line.slice(line.indexOf('=') + 2);
  if (solid.name !== had?.name) put(whole('name', ''), `name = ${JSON.stringify(solid.name)}`, JSON.stringify(solid.name));
  if (JSON.stringify(solid.shape) !== JSON.stringify(had?.shape)) {
    const line = shapeText(solid.shape);
    const dotted = whole(solid.shape.kind, 'shape');
    const inline = whole('shape', '');
    if (inline) put(inline, line, `{ ${solid.shape.kind} = ${after(line)} }`);
    else put(dotted, line, after(line));
  }
  const place = atText(solid);
  if (!had || place !== atText(had)) put(whole('at', ''), place, after(place));
  return edits.sort((a, b) => b.from - a.from).reduce((now, edit) => replaced(now, edit, edit.by), text);
}

/** The text with another solid, and that solid. */
export function added(text: string, list: List, kind: string, name: string, move: [number, number, number]): string {
  const sizes = Object.entries(PRIMITIVES[kind] ?? {}).map(([key, value]) => ({ key, numbers: [value].flat() }));
  const solid: Solid = { list, index: 0, name, shape: { kind, sizes }, move, turn: [0, 0, 1], angle: 0, fixed: false };
  const lines = [`[[${list}]]`, `name = ${JSON.stringify(name)}`, shapeText(solid.shape), atText(solid), ''];
  return `${text.replace(/\n*$/, '\n')}\n${lines.join('\n')}`;
}

/** The text without a solid. */
export function removed(text: string, solid: Pick<Solid, 'list' | 'index'>): string {
  const range = lines(text, solid.list, solid.index);
  if (!range) return text;
  // The blank line over it goes with it.
  const before = text.slice(0, range.from).replace(/\n\n$/, '\n');
  return before + text.slice(range.to);
}

/** A name that no solid has yet. */
export function freshName(solids: Solid[], kind: string): string {
  for (let i = 1; ; i += 1) if (!solids.some((solid) => solid.name === `${kind} ${i}`)) return `${kind} ${i}`;
}
