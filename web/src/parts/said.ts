import type { EventView } from '../wire';
import { about, alarmTitle, isKey, named, t } from '../words/index.svelte';
import { lackText } from './lack';

/** As the words call what the executive calls `process off, hold`. */
const reaction = (name: string): string => named('reaction', name.replaceAll(',', ''));

/** What of an event's parameters has words of its own; the others are names, places and numbers. */
const PARTS: Record<string, ((of: string, event: EventView) => string)[]> = {
  mode: [(of) => named('mode', of), (of) => named('mode', of)],
  order: [(of) => named('do', of)],
  refused: [(of) => named('do', of), (of, event) => (event.why ? lackText(event.why) : of)],
  alarm: [alarmTitle, reaction],
  alarm_of: [alarmTitle, reaction, about],
  alarm_before: [alarmTitle],
  shelved: [alarmTitle],
  unshelved: [alarmTitle],
  cleared: [alarmTitle],
  cleared_of: [alarmTitle, about],
  recorded: [(of) => of, (of) => named('result', of)],
  teach_ended: [(of) => of, (of) => named('teach_end', of)],
};

/** An event in the chosen language; one that has no words here keeps those of the cell. */
export function eventText(event: EventView): string {
  const key = `said.${event.key}`;
  if (!isKey(key)) return event.text;
  return t(key, ...event.of.map((of, i) => PARTS[event.key]?.[i]?.(of, event) ?? of));
}
