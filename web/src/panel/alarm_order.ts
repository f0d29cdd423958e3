import type { AlarmView } from '../wire';

/** Priorities of ISA-18.2, the most urgent first, each with a sign of its own shape: colour is never the only difference. */
export const PRIORITIES = ['critical', 'high', 'medium', 'low'] as const;
export type Priority = (typeof PRIORITIES)[number];
const SIGNS: Record<Priority, string> = { critical: '◆', high: '▲', medium: '▼', low: '●' };

/** Sign of a priority; none for one that this page does not know. */
export function prioritySign(priority: string): string {
  return SIGNS[priority as Priority] ?? '';
}

function rank(priority: string): number {
  const at = PRIORITIES.indexOf(priority as Priority);
  return at < 0 ? PRIORITIES.length : at;
}

type Ordered = Pick<AlarmView, 'priority' | 'state'>;

/** Alarms that wait for an acknowledgement first, then by priority, then in the order in which they came. */
export function byUrgency<A extends Ordered>(alarms: readonly A[]): A[] {
  const known = (alarm: A): number => Number(alarm.state === 'acknowledged');
  return [...alarms].sort((a, b) => known(a) - known(b) || rank(a.priority) - rank(b.priority));
}
