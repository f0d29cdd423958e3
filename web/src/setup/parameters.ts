/** A key of a machine file as what it means and its unit: `max_speed_mm_s` is the highest speed in mm/s. */
export function meaning(key: string): { word: string; unit: string } {
  const known = KEYS.find(([pattern]) => pattern.test(key));
  return known ? { word: known[1], unit: known[2](key) } : { word: key, unit: '' };
}

const unit = (of: Record<string, string>) => (key: string): string => {
  const end = Object.keys(of).find((end) => key.endsWith(end));
  return end ? (of[end] ?? '') : '';
};
const none = (): string => '';
const force = unit({ _n_m: 'N m', _n: 'N' });

const KEYS: [RegExp, string, (key: string) => string][] = [
  [/^home_/, 'home', unit({ _mm: 'mm', _deg: '°' })],
  [/^max_speed_/, 'max_speed', unit({ _mm_s: 'mm/s', _deg_s: '°/s' })],
  [/^max_acceleration_/, 'max_acceleration', unit({ _mm_s2: 'mm/s²', _deg_s2: '°/s²' })],
  [/^max_jerk_/, 'max_jerk', unit({ _mm_s3: 'mm/s³', _deg_s3: '°/s³' })],
  [/^velocity_bandwidth_/, 'velocity_bandwidth', () => 'Hz'],
  [/^kp_/, 'kp', () => '1/s'],
  [/^ki_/, 'ki', () => '1/s²'],
  [/^kd$/, 'kd', none],
  [/^kvff$/, 'kvff', none],
  [/^kaff_/, 'kaff', () => 's'],
  [/^(force|torque)_limit_/, 'limit', force],
  [/^current_time_constant_/, 'current_time_constant', () => 'ms'],
  [/^current_delay_/, 'current_delay', () => 'ms'],
  [/^friction_compensation_/, 'friction_compensation', force],
  [/^friction_smoothing_/, 'friction_smoothing', unit({ _mm_s: 'mm/s', _deg_s: '°/s' })],
  [/^backlash_compensation_ms$/, 'backlash_time', () => 'ms'],
  [/^backlash_compensation_/, 'backlash_compensation', unit({ _mm: 'mm', _deg: '°' })],
  [/^encoder_counts_/, 'encoder_counts', unit({ _mm: '1/mm', _deg: '1/°' })],
  [/^(mass|inertia)_/, 'inertia', unit({ _kg: 'kg', _kg_m2: 'kg m²' })],
  [/^peak_/, 'peak', force],
  [/^friction_/, 'friction', force],
  [/^viscous_/, 'viscous', unit({ _n_s_m: 'N s/m', _n_m_s_rad: 'N m s/rad' })],
  [/^resonance_/, 'resonance', () => 'Hz'],
  [/^load_ratio$/, 'load_ratio', none],
  // What is measured where an axis is tuned.
  [/^bandwidth_hz$/, 'bandwidth', () => 'Hz'],
  [/^measured_at_/, 'measured_at', unit({ _mm_s: 'mm/s', _deg_s: '°/s' })],
  [/^following_error_counts$/, 'following_counts', none],
  [/^load_error_/, 'load_error', unit({ _mm: 'mm', _deg: '°' })],
  [/^notch_hz$/, 'notch_at', () => 'Hz'],
];

/** So many times more or less than it was, a number is asked about: a key too many is ten times. */
const MUCH = 4;

/** A number is several times more or less than it was, or has another sign. */
export function isWild(was: number, now: number): boolean {
  if (!Number.isFinite(was) || !Number.isFinite(now) || was === 0 || now === 0) return false;
  return now / was > MUCH || now / was < 1 / MUCH;
}
