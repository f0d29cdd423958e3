import { BufferGeometry, Group, Line, LineBasicMaterial, Mesh, MeshBasicMaterial, SphereGeometry, type Vector3 } from 'three';
import { release } from './passes';

/** A distance between two picked places, mm. */
export type Measured = { distance: number; by: [number, number, number] };

/** Measures between two picks; the third begins anew. */
export class Measure {
  active = false;
  readonly group = new Group();
  onMeasured: (measured: Measured | null) => void = () => undefined;
  private places: Vector3[] = [];

  constructor(private readonly draw: () => void) {}

  turn(on: boolean): void {
    this.active = on;
    this.clear();
  }

  take(place: Vector3): void {
    if (this.places.length === 2) this.clear();
    this.places.push(place.clone());
    const ball = new Mesh(new SphereGeometry(3, 16, 8), new MeshBasicMaterial({ color: 0x0b4fa8, depthTest: false }));
    ball.position.copy(place);
    this.group.add(ball);
    const [from, to] = this.places;
    if (from && to) {
      const line = new Line(
        new BufferGeometry().setFromPoints([from, to]),
        new LineBasicMaterial({ color: 0x0b4fa8, depthTest: false }),
      );
      this.group.add(line);
      const by = to.clone().sub(from);
      this.onMeasured({ distance: by.length(), by: [by.x, by.y, by.z] });
    }
    this.draw();
  }

  private clear(): void {
    this.places = [];
    release(this.group);
    this.onMeasured(null);
    this.draw();
  }
}
