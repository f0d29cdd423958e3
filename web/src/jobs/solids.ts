import type { FormChange, FormView } from '../wire';
import { values } from './form';

/** Where a solid stands in the text: fixtures in the work frame, the part's own in that of the seam. */
export type List = 'fixtures' | 'part.solids';

type Place = [number, number, number];

/** A solid of a job: mm and degrees. */
export type Solid = {
  list: List;
  /** Its path. */
  path: string;
  name: string;
  shape: string;
  /** Numbers of its shape by their keys; some are three numbers. */
  sizes: { key: string; numbers: number[] }[];
  move: Place;
  turn: Place;
  angle: number;
  /** Of a shape that only the text can change. */
  fixed: boolean;
};

/** Shapes that can be added. */
export const SHAPES = ['box', 'cylinder', 'sphere', 'cone', 'capsule', 'ellipsoid'];

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

/** The solids of a job. */
export function solidsOf(form: FormView | null): Solid[] {
  const found = new Map<string, Solid>();
  for (const [path, value] of values(form)) {
    const match = /^((fixtures|part\.solids)\[\d+\])\.(.+)$/.exec(path);
    if (!match?.[1] || !match[3]) continue;
    const solid = found.get(match[1]) ?? { list: match[2] as List, path: match[1], name: '', shape: '', sizes: [], move: NOWHERE, turn: [0, 0, 1], angle: 0, fixed: false };
    found.set(match[1], solid);
    const items = value.kind === 'list' ? value.items : [value];
    const numbers = items.flatMap((item) => (item.kind === 'number' ? [item.number] : []));
    const [key, kind, size] = match[3].split('.');
    if (match[3] === 'name' && value.kind === 'text') solid.name = value.text;
    if (match[3] === 'at.move_mm' && numbers.length === 3) solid.move = numbers as Place;
    if (match[3] === 'at.turn' && numbers.length === 3) solid.turn = numbers as Place;
    if (match[3] === 'at.angle_deg') solid.angle = numbers[0] ?? 0;
    if (key !== 'shape' || !kind || !size) continue;
    solid.shape = kind;
    solid.fixed ||= !SHAPES.includes(kind) || numbers.length !== items.length;
    solid.sizes.push({ key: size, numbers });
  }
  return [...found.values()];
}

/** The changes that add a solid. */
export function added(solids: Solid[], list: List, shape: string, move: Place): FormChange[] {
  const path = `${list}[${solids.filter((of) => of.list === list).length}]`;
  return [
    { op: 'insert', path, value: { name: freshName(solids, shape) } },
    { op: 'add', path: `${path}.shape.${shape}` },
    { op: 'set', path: `${path}.at.move_mm`, value: move },
  ];
}

/** A name that no solid has yet. */
function freshName(solids: Solid[], kind: string): string {
  for (let i = 1; ; i += 1) if (!solids.some((solid) => solid.name === `${kind} ${i}`)) return `${kind} ${i}`;
}
