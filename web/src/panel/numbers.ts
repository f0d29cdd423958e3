/** Units by the ends of keys of files and of names of process values. */
const units = {
  a: 'A', v: 'V', kv: 'kV', ma: 'mA', w: 'W', kw: 'kW',
  mm: 'mm', m_min: 'm/min', mm_s: 'mm/s', mm_min: 'mm/min', l_min: 'l/min',
  hz: 'Hz', khz: 'kHz', deg: '°', s: 's', ms: 'ms', percent: '%',
  mbar: 'mbar', bar: 'bar', c: '°C', k: 'K', kj_mm: 'kJ/mm',
  mm_s2: 'mm/s²', mm_s3: 'mm/s³', deg_s: '°/s', deg_s2: '°/s²', deg_s3: '°/s³',
  per_s: '1/s', per_s2: '1/s²', per_mm: '1/mm', per_deg: '1/°',
  n: 'N', n_m: 'N m', kg: 'kg', kg_m2: 'kg m²', n_s_m: 'N s/m', n_m_s_rad: 'N m s/rad',
};

/** A number with a decimal point in every language, and a true minus sign; what is not there is a dash. */
export function number(value: number | null | undefined, digits: number): string {
  if (value === null || value === undefined || !Number.isFinite(value)) return '–';
  const text = value.toFixed(digits);
  // No -0.00: the sign of nothing flickers.
  return Number(text) === 0 ? text.replace('-', '') : text.replace('-', '\u2212');
}

/** The number that a hand has written, with a point or a comma; null if it is none. */
export function written(text: string): number | null {
  const value = Number(text.replace(',', '.'));
  return text.trim() !== '' && Number.isFinite(value) ? value : null;
}

/** A limit, with all the digits that it has. */
export function limit(value: number): string {
  return String(Number(value.toFixed(6))).replace('-', '\u2212');
}

/** How many digits after the point show what numbers of this size differ in. */
export function digitsFor(values: readonly (number | null)[]): number {
  const most = Math.max(0, ...values.map((value) => Math.abs(value ?? 0)).filter(Number.isFinite));
  return most < 2 ? 3 : most < 20 ? 2 : 1;
}

const UNIT = new RegExp(`_(${Object.keys(units).join('|')})$`);

/** Splits the name of a process value, which ends in its unit, as `wire_feed_m_min`. */
export function valueName(name: string): { title: string; unit: string } {
  const unit = UNIT.exec(name);
  if (!unit) return { title: name.replaceAll('_', ' '), unit: '' };
  return { title: name.slice(0, unit.index).replaceAll('_', ' '), unit: units[unit[1] as keyof typeof units] };
}

/** `mm` or `°` of an axis. */
export function axisUnit(unit: string): string {
  return unit === 'deg' ? '°' : unit;
}

/** Minutes and seconds. */
export function duration(seconds: number): string {
  if (!Number.isFinite(seconds)) return '–';
  const whole = Math.max(0, Math.round(seconds));
  return `${Math.floor(whole / 60)}:${String(whole % 60).padStart(2, '0')}`;
}

/** Time of day of an RFC 3339 time, in the browser's zone. */
export function timeOfDay(at: string): string {
  const time = new Date(at);
  return Number.isNaN(time.getTime()) ? at : time.toTimeString().slice(0, 8);
}

/** Day and time, to the second, of an RFC 3339 time, in the browser's zone. */
export function dayAndTime(at: string | null): string {
  if (!at) return '–';
  const time = new Date(at);
  if (Number.isNaN(time.getTime())) return at;
  const two = (n: number): string => String(n).padStart(2, '0');
  return `${time.getFullYear()}-${two(time.getMonth() + 1)}-${two(time.getDate())} ${time.toTimeString().slice(0, 8)}`;
}

/** From one RFC 3339 time to another; the day is said again if it is another one. */
export function span(from: string, to: string | null): string {
  const [begun, ended] = [dayAndTime(from), to === null ? '' : dayAndTime(to)];
  const same = begun.slice(0, 11) === ended.slice(0, 11);
  return `${begun} – ${same ? ended.slice(11) : ended}`.trimEnd();
}
