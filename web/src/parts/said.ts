import type { EventView } from '../wire';
import { alarmWords, named, t } from '../words/index.svelte';
import { en, type Key } from '../words/en';
import { lackText } from './lack';

const blank = { cause: '', consequence: '', action: '' };
const alarm = (name: string): string => alarmWords({ name, ...blank }).name;
/** An axis by its name, or a condition in words. */
const detail = (name: string): string => named('interlock', name);
/** As the words call what the executive calls `process off, hold`. */
const reaction = (name: string): string => named('reaction', name.replaceAll(',', ''));

/** What of an event's parameters has words of its own; the others are names, places and numbers. */
const PARTS: Record<string, ((of: string, event: EventView) => string)[]> = {
  mode: [(of) => named('mode', of), (of) => named('mode', of)],
  order: [(of) => named('do', of)],
  refused: [(of) => named('do', of), (of, event) => (event.why ? lackText(event.why) : of)],
  alarm: [alarm, reaction],
  alarm_of: [alarm, reaction, detail],
  alarm_before: [alarm],
  cleared: [alarm],
  cleared_of: [alarm, detail],
  recorded: [(of) => of, (of) => named('result', of)],
  teach_ended: [(of) => of, (of) => named('teach_end', of)],
};

/** An event in the chosen language; one that has no words here keeps those of the cell. */
export function eventText(event: EventView): string {
  const key = `said.${event.key}`;
  if (!(key in en)) return event.text;
  return t(key as Key, ...event.of.map((of, i) => PARTS[event.key]?.[i]?.(of, event) ?? of));
}
