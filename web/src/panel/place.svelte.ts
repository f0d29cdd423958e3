import type { FindingView } from '../wire';
import type { Stretch } from './stretch';

export const tabs = ['weld', 'teach', 'jobs', 'records', 'setup'] as const;
export type Tab = (typeof tabs)[number];

export const setupPages = ['machine', 'parameters', 'tool', 'frames', 'sensors', 'devices', 'diagnostics', 'tuning', 'alarms', 'users', 'audit', 'data'] as const;
export type SetupPage = (typeof setupPages)[number];

const TOURED = 'seamwright.toured';

/** Where the operator is in the panel. Nothing of it changes what the cell does. */
class Place {
  tab = $state<Tab>('weld');
  /** The page of jobs shows tables of seams, and of which. */
  schedules = $state(false);
  schedule = $state('');
  /** The page of the set-up that was looked at last. */
  setup = $state<SetupPage>('machine');
  /** The first-run tour is shown: until it is dismissed once. */
  touring = $state(localStorage.getItem(TOURED) === null);
  /** Teaching by camera, else by hand. */
  byEye = $state(false);
  /** A place on a pass that is shown in 3D, tables and plots alike: pass from 0 and the sample of its path. */
  spot = $state.raw<{ pass: number; point: number } | null>(null);
  /** The finding that is looked at, and the place that was shown for it: with another place it is looked at no longer. */
  finding = $state.raw<{ of: FindingView; spot: Place['spot'] } | null>(null);
  /** The stretch about that place that is chosen: its span, or the whole pass. */
  stretch = $state.raw<Stretch | null>(null);

  endTour(): void {
    this.touring = false;
    localStorage.setItem(TOURED, 'true');
  }
}

export const place = new Place();
