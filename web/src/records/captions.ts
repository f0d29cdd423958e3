import { valueName } from '../panel/numbers';
import { named, t } from '../words/index.svelte';

/** What every trace of a cell or of a simulation has. */
const KNOWN: Record<string, string[]> = {
  mode: ['mode'],
  welded_mm: ['trace.welded'],
  speed_set_mm_s: ['plot.path', 'set'],
  tip_speed_mm_s: ['value.tip_speed', 'actual'],
  tip_s_mm: ['trace.tip_s'],
  path_error_mm: ['trace.path_error'],
  attitude_error_deg: ['trace.attitude_error'],
  override: ['override'],
  gas: ['gas'],
  process_state: ['trace.process_state'],
  burning: ['trace.burning'],
  power: ['trace.power'],
  inputs: ['trace.inputs'],
  missed: ['setup.missed'],
  steady: ['trace.steady'],
};
const AXIS = /^(.+)_(set|measured|true|following_error|current)_(mm|deg|part)$/;
const OF_AXIS: Record<string, string> = { set: 'set', measured: 'actual', true: 'trace.true', following_error: 'plot.error', current: 'axis.current' };
/** Of a head that is tracked; with several heads its name is the end. */
const HEAD = /^(deviation|correction|miss)_(lateral|height)_mm(?:_(.+))?$/;
const SURE = /^(sigma_mm|confidence)(?:_(.+))?$/;
/** Parts of a whole, by the ends of their names. */
const PART = /(_part|^override)$/;

/** A column of a trace in words, with its unit; `recorded` is the unit that the trace says. */
export function caption(name: string, recorded: string): string {
  const unit = PART.test(name) ? '(1 = 100 %)' : recorded.replace(/^1$/, '').replace(/^deg$/, '°');
  return [...words(name), unit || (name in KNOWN ? '' : valueName(name.replace(/_set$/, '')).unit)].filter(Boolean).join(' ');
}

function words(name: string): string[] {
  const known = KNOWN[name];
  if (known) return known.map((key) => t(key));
  const [, axis, kind] = AXIS.exec(name) ?? [];
  if (axis && kind && OF_AXIS[kind]) return [`${axis}:`, t(OF_AXIS[kind])];
  const [, what, side, head] = HEAD.exec(name) ?? [];
  if (what && side) return [head ? `${head}:` : '', `${named('trace', what)},`, t(side === 'lateral' ? 'track.lateral' : 'track.height').toLowerCase()];
  const [, sure, of] = SURE.exec(name) ?? [];
  if (sure) return [of ? `${of}:` : '', t(sure === 'confidence' ? 'track.confidence' : 'track.sigma')];
  const isSet = name.endsWith('_set');
  return [named('value', valueName(isSet ? name.slice(0, -'_set'.length) : name).title), t(isSet ? 'set' : 'actual')];
}
