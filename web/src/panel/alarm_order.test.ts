import { expect, test } from 'vitest';
import { byUrgency, PRIORITIES, prioritySign } from './alarm_order';

const alarm = (name: string, priority: string, state = 'unacknowledged') => ({ name, priority, state });

test('the most urgent alarm comes first, equal ones in the order in which they came', () => {
  const came = [
    alarm('jog stopped', 'low'),
    alarm('arc stays on, known', 'critical', 'acknowledged'),
    alarm('following error', 'medium'),
    alarm('drives silent', 'high', 'returned'),
    alarm('panel silent', 'low'),
    alarm('of a later version', 'urgent'),
    alarm('arc stays on', 'critical'),
  ];
  expect(byUrgency(came).map(({ name }) => name)).toEqual([
    'arc stays on', 'drives silent', 'following error', 'jog stopped', 'panel silent', 'of a later version', 'arc stays on, known',
  ]);
  expect(came[0]?.name).toBe('jog stopped');
});

test('every priority has a sign of its own', () => {
  expect(new Set(PRIORITIES.map(prioritySign)).size).toBe(PRIORITIES.length);
  expect(prioritySign('urgent')).toBe('');
});
