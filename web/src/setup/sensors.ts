import { written } from '../panel/numbers';
import type { HeightView } from '../wire';

/** Residuals of dots are drawn so much longer. */
export const LONGER = 50;
/** Planes nearer than this are the same one, mm. */
const SAME_MM = 1e-6;

/** A key of a sensor as what it means and its unit. */
export function sensorMeaning(key: string): { word: string; unit: string } | null {
  return KEYS[key] ?? null;
}

const KEYS: Record<string, { word: string; unit: string }> = {
  'at.move_mm': { word: 'sensor.move', unit: 'mm' },
  'at.turn': { word: 'sensor.turn', unit: '' },
  'at.angle_deg': { word: 'sensor.angle', unit: '°' },
  'map.camera.distance_mm': { word: 'sensor.distance', unit: 'mm' },
  'map.camera.angle_deg': { word: 'sensor.laser_angle', unit: '°' },
  'map.camera.focal_px': { word: 'sensor.focal', unit: 'px' },
  'map.camera.centre_px': { word: 'sensor.centre', unit: 'px' },
  'map.homography': { word: 'sensor.homography', unit: '' },
  'map.scale.mm_per_px': { word: 'sensor.scale', unit: '' },
  'map.scale.origin_px': { word: 'sensor.origin', unit: 'px' },
  period_ms: { word: 'sensor.period', unit: 'ms' },
  latency_ms: { word: 'sensor.latency', unit: 'ms' },
  noise_mm: { word: 'sensor.noise', unit: 'mm' },
};

/** Numbers as they are typed, apart by spaces; null if one is none. */
export function numbersOf(text: string): number[] | null {
  const parts = text.trim().split(/[\s;]+/).filter((part) => part !== '');
  const numbers = parts.map((part) => written(part) ?? NaN);
  return numbers.every(Number.isFinite) ? numbers : null;
}

/** The plane at this height. */
export function planeAt(planes: HeightView[], z_mm: number): HeightView | undefined {
  return planes.find((plane) => Math.abs(plane.z_mm - z_mm) < SAME_MM);
}

/** Planes with this one: in place of that at its height, or where it belongs among them. */
export function withPlane(planes: HeightView[], found: HeightView): HeightView[] {
  const others = planes.filter((plane) => plane !== planeAt(planes, found.z_mm));
  return [...others, found].sort((a, b) => a.z_mm - b.z_mm);
}

type Px = [number, number];

/** Lines from dot to dot next to it, by where the map has them: pairs nearer than a diagonal of the grid. */
export function net(dots: readonly (readonly [number, number, number, number])[]): [Px, Px][] {
  const places = dots.map(([x, y, dx, dy]): Px => [x + dx, y + dy]);
  const far = (a: Px, b: Px): number => Math.hypot(a[0] - b[0], a[1] - b[1]);
  const nearest = places.map((a, i) => Math.min(...places.map((b, k) => (k === i ? Infinity : far(a, b))))).sort((a, b) => a - b);
  const reach = 1.25 * (nearest[Math.floor(nearest.length / 2)] ?? 0);
  return places.flatMap((a, i) => places.slice(i + 1).filter((b) => far(a, b) < reach).map((b): [Px, Px] => [a, b]));
}
