import type { TargetAnswer } from '../wire';

/** A typed target of motion by hand that was checked, as the scene shows it; null: none. */
class Target {
  answer = $state.raw<TargetAnswer | null>(null);
}

export const target = new Target();
