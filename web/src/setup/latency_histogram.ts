import type { LatencyView } from '../wire';

/** A class of the histogram, as it is drawn. */
export type Bar = {
  /** Limits of the lateness, µs; the last class has no upper one. */
  from: number;
  to: number | null;
  count: number;
  /** Part of all cycles. */
  part: number;
  /** Height from 0 to 1: logarithmic, so that a few late cycles among millions are seen. */
  height: number;
};

const total = (of: LatencyView): number => of.counts.reduce((sum, count) => sum + count, 0);

/** The classes from the first to the last one with cycles; empty without cycles. */
export function bars(of: LatencyView): Bar[] {
  const [all, most] = [total(of), Math.log1p(Math.max(...of.counts, 0))];
  const used = of.counts.flatMap((count, i) => (count > 0 ? [i] : []));
  const [first, last] = [used[0], used.at(-1)];
  if (first === undefined || last === undefined) return [];
  return of.counts.slice(first, last + 1).map((count, i) => ({
    from: of.limits_us[first + i - 1] ?? 0,
    to: of.limits_us[first + i] ?? null,
    count,
    part: count / all,
    height: Math.log1p(count) / most,
  }));
}

/** The lateness that this part of the cycles does not exceed, µs: the limit of its class, or the maximum if that is less; null without cycles. */
export function quantile(of: LatencyView, part: number): number | null {
  const wanted = part * total(of);
  if (wanted === 0) return null;
  let seen = 0;
  const found = of.counts.findIndex((count) => (seen += count) >= wanted);
  return Math.min(of.limits_us[found] ?? Infinity, of.most_us);
}

/** A time in the unit in which it has few digits. */
export function short(us: number): string {
  const [value, unit] = us < 1000 ? [us, 'µs'] : us < 1e6 ? [us / 1000, 'ms'] : [us / 1e6, 's'];
  return `${Number(value.toPrecision(3))} ${unit}`;
}

/** A number of bytes in MiB or GiB. */
export function bytes(of: number | null): string {
  if (of === null) return '–';
  const mib = of / 2 ** 20;
  return mib < 1024 ? `${mib.toFixed(mib < 10 ? 1 : 0)} MiB` : `${(mib / 1024).toFixed(1)} GiB`;
}
