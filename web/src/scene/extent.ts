import { Box3, Vector3, type Group, type Object3D } from 'three';

/** All that stands there, seen or not. */
export function everything(...groups: Object3D[][]): Box3 {
  const box = new Box3();
  for (const of of groups.flat()) box.expandByObject(of);
  return box;
}

/** What there is to look at: passes and part, else the machine. */
export function extent(passes: Object3D[], parts: Group[], machine: Group[]): Box3 {
  const box = new Box3();
  for (const line of passes) box.expandByObject(line);
  for (const part of parts) {
    const size = new Box3().setFromObject(part).getSize(new Vector3()).length();
    // A long shell or plate would make the seam a dot.
    if (box.isEmpty() || size < 3 * box.getSize(new Vector3()).length()) box.expandByObject(part);
  }
  if (box.isEmpty()) for (const part of machine) box.expandByObject(part);
  if (box.isEmpty()) box.set(new Vector3(-200, -200, -200), new Vector3(200, 200, 200));
  return box;
}
