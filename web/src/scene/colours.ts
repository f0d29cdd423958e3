import type { PassView, PathPoint } from '../wire';

/** What the colour of a pass says. */
export type ColourBy = { kind: 'pass' } | { kind: 'speed' } | { kind: 'heat' } | { kind: 'clearance' } | { kind: 'value'; index: number };

/** Numbers that the ends of the scale stand for. */
export type Scale = { least: number; most: number; unit: string };

type Rgb = [number, number, number];

/** Of even lightness, told apart with colour blindness too (after Okabe and Ito, without the alarm colours). */
const PASSES: Rgb[] = [
  [0.0, 0.35, 0.62],
  [0.0, 0.5, 0.38],
  [0.56, 0.3, 0.55],
  [0.4, 0.28, 0.14],
  [0.16, 0.5, 0.66],
  [0.35, 0.42, 0.08],
];

/** Dark blue over green to yellow, as viridis goes: even in lightness. */
const RAMP: Rgb[] = [
  [0.267, 0.005, 0.329],
  [0.229, 0.322, 0.546],
  [0.128, 0.567, 0.551],
  [0.369, 0.789, 0.383],
  [0.993, 0.906, 0.144],
];

export function passColour(pass: number): Rgb {
  return PASSES[pass % PASSES.length] ?? [0, 0, 0];
}

export function ramp(part: number): Rgb {
  const at = Math.min(1, Math.max(0, part)) * (RAMP.length - 1);
  const i = Math.min(RAMP.length - 2, Math.floor(at));
  const from = RAMP[i] ?? [0, 0, 0];
  const to = RAMP[i + 1] ?? from;
  return [0, 1, 2].map((k) => (from[k] ?? 0) + ((to[k] ?? 0) - (from[k] ?? 0)) * (at - i)) as Rgb;
}

/** Heat input by U I / v, kJ/mm, without an efficiency; null where the program does not say voltage and current. */
export function heat(point: PathPoint, values: string[]): number | null {
  const of = (...names: string[]): number | null => {
    const index = values.findIndex((name) => names.includes(name));
    return index < 0 ? null : (point.values[index] ?? null);
  };
  const current = of('current_a') ?? milli(of('current_ma', 'beam_current_ma'));
  const voltage = of('voltage_v') ?? kilo(of('voltage_kv', 'acceleration_kv'));
  const power = of('power_w') ?? kilo(of('power_kw')) ?? (current !== null && voltage !== null ? current * voltage : null);
  return power === null || point.speed_mm_s <= 0 ? null : power / point.speed_mm_s / 1000;
}

function milli(value: number | null): number | null {
  return value === null ? null : value / 1000;
}

function kilo(value: number | null): number | null {
  return value === null ? null : value * 1000;
}

export function numberOf(point: PathPoint, by: ColourBy, values: string[]): number | null {
  switch (by.kind) {
    case 'speed':
      return point.speed_mm_s;
    case 'heat':
      return heat(point, values);
    case 'clearance':
      return point.clearance_mm;
    case 'value':
      return point.values[by.index] ?? null;
    case 'pass':
      return null;
  }
}

/** Ends of the scale over all passes, without their acceleration and deceleration phases, where arc energy is unlimited. */
export function scale(passes: PassView[], by: ColourBy, values: string[]): Scale | null {
  if (by.kind === 'pass') return null;
  let least = Infinity;
  let most = -Infinity;
  for (const pass of passes) {
    for (const point of pass.path) {
      if (by.kind === 'heat' && point.speed_mm_s < 0.5 * pass.speed_mm_s) continue;
      const number = numberOf(point, by, values);
      if (number === null) continue;
      least = Math.min(least, number);
      most = Math.max(most, number);
    }
  }
  if (least > most) return null;
  const unit = by.kind === 'speed' ? 'mm/s' : by.kind === 'heat' ? 'kJ/mm' : by.kind === 'clearance' ? 'mm' : '';
  return { least, most, unit };
}
