import {
  AmbientLight,
  type Box3,
  Color,
  DirectionalLight,
  Group,
  HemisphereLight,
  Matrix4,
  Mesh,
  PerspectiveCamera,
  Plane,
  Scene as World,
  Vector2,
  Vector3,
  WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
import type { MachineView, NearView, PathPoint, Status, WorkView } from '../wire';
import { bones } from './bones';
import { Caps } from './caps';
import type { ColourBy, Scale } from './colours';
import { everything, extent } from './extent';
import { facing, standings, type Spot, type Standing } from './facing';
import { Ghost } from './ghost';
import { Highlight } from './highlight';
import { poseAt, type Pose } from './kinematics';
import { Links } from './links';
import { Mark } from './mark';
import { Measure } from './measure';
import { Near, type Nearness } from './near';
import { Passes, release } from './passes';
import { nearest, surface } from './pick';
import { matrix } from './shapes';
import { sight } from './sight';
import { solid, tint } from './solids';
import type { Off } from './spot';
import { TaughtLine } from './taught';
import { Torch } from './torch';
import { Trace } from './trace';
import { look, type View } from './views';

export type Layer = 'machine' | 'part' | 'zones' | 'air' | 'near' | 'sensors' | 'trace';
export type Cut = { axis: 'x' | 'y' | 'z'; part: number } | null;

/** At this distance of the camera marks are as large as they say, mm. */
const MARKS_AT_MM = 1500;
/** A torch this near to what is looked at is at the work, mm. */
const AT_WORK_MM = 20;
/** A frame that takes longer is no graphics card's. */
const SLOW_MS = 25;
/** A frozen clock: the scene takes the first status and no other, for pictures that are always the same. */
const FROZEN = new URLSearchParams(location.search).has('freeze');

/**
 * The cell in 3D. It is told what there is and draws it when something has changed; nothing else of the panel knows three.
 * Inside `root` z is up and the machine's base stands still; `links` move as the status says, and work and passes with the
 * link of the work.
 */
export class Scene {
  /** Called with the pass (from 0) and the sample that was picked. */
  onPick: (pass: number, point: number) => void = () => undefined;
  onScale: (scale: Scale | null) => void = () => undefined;
  readonly measure: Measure;
  readonly taught: TaughtLine;

  private readonly renderer: WebGLRenderer;
  private readonly world = new World();
  private readonly camera = new PerspectiveCamera(35, 1, 1, 40_000);
  private readonly controls: OrbitControls;
  private readonly links = new Links();
  private readonly root = this.links.root;
  private readonly machineParts: Group[] = [];
  private readonly zones: Group[] = [];
  private readonly parts: Group[] = [];
  private readonly passes = new Passes();
  private readonly trace = new Trace();
  private readonly near = new Near();
  private readonly torch = new Torch();
  private readonly sights: Group[] = [];
  private readonly mark = new Mark();
  private readonly highlight = new Highlight();
  private readonly ghost = new Ghost();
  private readonly cut = new Plane(new Vector3(0, 0, -1), 0);
  private readonly cuts: Plane[] = [];
  private readonly caps = new Caps(this.cuts);
  private machine: MachineView | null = null;
  private work: WorkView | null = null;
  private status: Status | null = null;
  private by: ColourBy = { kind: 'pass' };
  private asked = false;
  private prepares = 0;
  private ended = false;
  private restUntil = 0;
  private fitted = '';
  /** Fitted before it was known where the machine stands. */
  private blind = false;
  /** What was fitted last is everything: the next time it is the seam again. */
  private wide = true;
  private readonly hidden = new Set<Layer>();
  private readonly watch: ResizeObserver;
  private pressed: Vector2 | null = null;

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly live: boolean,
  ) {
    this.renderer = new WebGLRenderer({ canvas, antialias: true, stencil: true, preserveDrawingBuffer: FROZEN });
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.renderer.localClippingEnabled = true;
    this.camera.up.set(0, 0, 1);
    this.camera.position.set(900, -1300, 900);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.addEventListener('change', this.draw);
    // After the view was turned, the seam comes first.
    this.controls.addEventListener('start', () => ([this.wide, this.blind] = [true, false]));
    this.world.add(this.root, new AmbientLight(0xffffff, 0.9), new HemisphereLight(0xffffff, 0x8a8f95, 1.2));
    const sun = new DirectionalLight(0xffffff, 1.6);
    sun.position.set(0.4, -0.8, 1);
    this.world.add(sun);
    this.torch.group.visible = live;
    this.trace.line.visible = live;
    this.measure = new Measure(this.draw);
    this.taught = new TaughtLine(this.draw);
    this.world.add(this.measure.group, this.caps.group);
    canvas.addEventListener('pointerdown', this.press);
    canvas.addEventListener('pointerup', this.lift);
    this.watch = new ResizeObserver(() => this.resize());
    this.watch.observe(canvas.parentElement ?? canvas);
    this.resize();
  }

  end(): void {
    this.ended = true;
    this.watch.disconnect();
    this.controls.dispose();
    this.near.end();
    this.caps.end();
    release(this.root);
    this.renderer.dispose();
    // A browser has few contexts, and gives up the oldest that nobody has collected yet.
    this.renderer.forceContextLoss();
  }

  background(colour: string): void {
    this.world.background = new Color(colour);
    tint(this.zones, this.isLight());
    this.draw();
  }

  setMachine(machine: MachineView | null): void {
    if (this.machine === machine) return;
    this.machine = machine;
    this.links.set(machine);
    this.ghost.clear();
    this.machineParts.length = this.zones.length = this.sights.length = 0;
    if (machine) {
      for (const view of machine.solids) this.machineParts.push(this.links.add(view.link, solid(view, 'machine', this.cuts, this.caps, !this.live)));
      for (const bone of bones(machine, this.cuts)) this.machineParts.push(this.links.add(bone.link, bone.group));
      for (const zone of machine.zones) {
        const kind = zone.permitted ? 'permitted' : 'forbidden';
        for (const view of zone.solids) this.zones.push(this.links.add(view.link, solid(view, kind, this.cuts, this.caps, false)));
      }
      tint(this.zones, this.isLight());
      for (const view of machine.sensors) this.sights.push(this.links.add(view.link, sight(view)));
    }
    this.torch.setBeam(machine?.beam_mm ?? null);
    this.links.work().add(this.highlight.group, this.passes.group, this.passes.air, this.trace.line, this.near.group, this.torch.group, this.mark.arrow, this.taught.group);
    this.links.stand();
    const work = this.work;
    this.work = null;
    this.parts.length = 0;
    this.setWork(work);
  }

  setWork(work: WorkView | null): void {
    if (this.work === work) return;
    this.work = work;
    for (const part of this.parts) {
      const parent = part.parent as Group | null;
      parent?.remove(part);
      const holder = new Group();
      holder.add(part);
      release(holder);
    }
    this.parts.length = 0;
    this.trace.clear();
    for (const view of work?.part ?? []) this.parts.push(this.links.add(view.link, solid(view, 'part', this.cuts, this.caps, false)));
    for (const view of work?.fixtures ?? []) this.parts.push(this.links.add(view.link, solid(view, 'fixture', this.cuts, this.caps, false)));
    this.onScale(this.passes.set(work, this.by));
    this.showLayers();
    const name = `${this.machine?.name ?? ''}/${work?.job ?? ''}`;
    if (name !== this.fitted && this.machine) {
      this.fitted = name;
      this.wide = this.blind = true;
      this.show('fit', this.box());
    }
    this.prepare();
  }

  /** `off`: how far torch or beam are from the pass. */
  setStatus(status: Status, off: Off | null): void {
    if (FROZEN && this.status) return;
    const before = this.status;
    this.status = status;
    const [x, y, z, ...along] = status.tip;
    const burns = status.process.burning;
    this.stands({ links: status.links.map(matrix), tip: [x, y, z], along }, burns, off);
    if (this.blind) this.show('fit', this.box());
    this.blind = false;
    const runs = status.mode === 'weld' || status.mode === 'dry_run';
    if (runs && before?.mode === 'ready') this.trace.clear();
    if (runs) this.trace.add(x, y, z, burns);
  }

  /** Stands machine and torch as they were, in a record. */
  setPose(pose: Pose, burns: boolean, off: Off | null): void {
    this.torch.group.visible = true;
    this.stands(pose, burns, off);
  }

  private stands(pose: Pose, burns: boolean, off: Off | null): void {
    this.links.put(pose.links);
    this.ghost.stand(this.links);
    const along = new Vector3(...pose.along).normalize();
    this.torch.set(new Vector3(...pose.tip), along, burns, off, this.links.work().matrixWorld, this.parts);
    this.draw();
  }

  /** Puts the marked torch to a sample of a pass, or takes it away. */
  setMark(point: Pick<PathPoint, 'tip' | 'torch'> | null): void {
    this.mark.set(point);
    this.draw();
  }

  /** Shows a stretch of a pass that is chosen, by its tips; none: nothing is. */
  setStretch(tips: [number, number, number][]): void {
    this.highlight.set(tips);
    this.draw();
  }

  /** Shows the machine as it would stand, to be looked through; null: not. */
  setGhost(pose: Pose | null): void {
    this.ghost.set(this.machine, pose, this.links);
    this.draw();
  }

  /** Shows the nearest pair of bodies, or none. */
  setNear(of: NearView | null, level: Nearness): void {
    if (this.near.set(of, level, [...this.machineParts, ...this.zones, ...this.parts])) this.draw();
  }

  setColours(by: ColourBy): void {
    this.by = by;
    this.onScale(this.passes.set(this.work, by));
    this.draw();
  }

  setLayer(layer: Layer, shown: boolean): void {
    if (shown) this.hidden.delete(layer);
    else this.hidden.add(layer);
    this.showLayers();
    this.draw();
  }

  /** Cuts machine and part open, looking along the axis; `part` of the way through what there is. */
  setCut(cut: Cut): void {
    this.cuts.length = 0;
    const box = this.box();
    if (cut) {
      const at = box.min[cut.axis] + (box.max[cut.axis] - box.min[cut.axis]) * cut.part;
      const normal = new Vector3();
      normal[cut.axis] = -1;
      this.cut.set(normal, at);
      this.cuts.push(this.cut);
    }
    this.caps.set(cut && this.cut, box);
    this.root.traverse((object) => {
      if (object instanceof Mesh) for (const material of [object.material].flat()) material.needsUpdate = true;
      if (object.userData['mask']) object.visible = cut !== null;
    });
    this.draw();
  }

  /** `fit` shows the seam with its part, and asked for again, everything. */
  view(view: View): void {
    this.wide = view !== 'fit' || !this.wide;
    const all = view === 'fit' && this.wide ? everything(this.passes.group.children, this.parts, this.machineParts, this.zones) : null;
    this.show(view, all && !all.isEmpty() ? all : this.box());
  }

  private show(view: View, box: Box3): void {
    const axis = this.status && new Vector3(...this.status.tip.slice(3)).transformDirection(this.links.work().matrixWorld);
    const { at, from, away } = look(view, box, this.camera, axis && { at: this.torch.place(), axis }, (from) => this.turned(from, box));
    this.controls.target.copy(at);
    this.camera.position.copy(at).addScaledVector(from, away);
    [this.camera.near, this.camera.far] = [away / 200, away * 20];
    this.camera.updateProjectionMatrix();
    this.controls.update();
    this.draw();
  }

  /** Where to look from to see where the torch is, if it is at the work; else the passes, as they stand and as they will. */
  private turned(from: Vector3, box: Box3): Vector3 {
    const { tip } = this.status ?? {};
    const torch = tip && ({ tip: tip.slice(0, 3), torch: tip.slice(3) } as Spot);
    const there = torch && box.distanceToPoint(this.torch.place()) < AT_WORK_MM;
    const stood = this.links.put([]);
    const stand = ({ axes }: Standing): Matrix4 => {
      this.links.put(axes && this.machine ? poseAt(this.machine, axes).links : stood);
      return this.links.work().matrixWorld;
    };
    const best = facing(from, there ? [{ axes: null, spots: [torch] }] : standings(this.work), stand, [...this.parts, ...this.machineParts]);
    this.links.put(stood);
    return best;
  }

  /** Draws with the next frame; any number of calls until then are one. */
  readonly draw = (): void => {
    if (this.asked || this.prepares > 0) return;
    this.asked = true;
    const wait = this.restUntil - performance.now();
    if (wait > 0) setTimeout(this.ask, wait);
    else this.ask();
  };

  /** Has the graphics card make what new materials need, beside the page's own work, and then draws. */
  private prepare(): void {
    if (!this.renderer.extensions.has('KHR_parallel_shader_compile')) {
      this.draw();
      return;
    }
    this.prepares += 1;
    const done = (): void => {
      this.prepares -= 1;
      if (!this.ended) this.draw();
    };
    this.renderer.compileAsync(this.world, this.camera).then(done, done);
  }

  private readonly ask = (): void => {
    if (this.ended) return;
    requestAnimationFrame(() => {
      this.asked = false;
      if (this.ended) return;
      const begun = performance.now();
      this.sizeMarks();
      this.renderer.render(this.world, this.camera);
      // Where drawing is slow it gets less than half of the time: heartbeat and buttons come first.
      const took = performance.now() - begun;
      if (took > SLOW_MS) this.restUntil = begun + took * 3;
    });
  };

  /** Marks are as large on the screen from everywhere. */
  private sizeMarks(): void {
    const near = this.camera.position.distanceTo(this.controls.target) / MARKS_AT_MM;
    this.torch.size(near);
    this.mark.size(near);
    this.near.size(near);
  }

  private showLayers(): void {
    const shows = (layer: Layer): boolean => !this.hidden.has(layer);
    this.machineParts.forEach((group) => (group.visible = shows('machine')));
    this.parts.forEach((group) => (group.visible = shows('part')));
    this.zones.forEach((group) => (group.visible = shows('zones')));
    this.sights.forEach((group) => (group.visible = shows('sensors')));
    this.passes.air.visible = shows('air');
    this.near.hide(!shows('near'));
    this.trace.line.visible = this.live && shows('trace');
  }

  private isLight(): boolean {
    const { background } = this.world;
    return !(background instanceof Color) || background.getHSL({ h: 0, s: 0, l: 0 }).l > 0.5;
  }

  private box(): Box3 {
    this.root.updateMatrixWorld(true);
    return extent(this.passes.group.children, this.parts, this.machineParts);
  }

  private readonly press = (event: PointerEvent): void => {
    this.pressed = new Vector2(event.clientX, event.clientY);
  };

  private readonly lift = (event: PointerEvent): void => {
    const moved = this.pressed?.distanceTo(new Vector2(event.clientX, event.clientY)) ?? Infinity;
    if (moved > 5) return;
    const area = this.canvas.getBoundingClientRect();
    const at = new Vector2(event.clientX - area.left, event.clientY - area.top);
    const near = nearest(this.work, this.links.work().matrixWorld, this.camera, at, area);
    if (this.measure.active) {
      const place = near ? near.place : surface(this.root, this.camera, at, area);
      if (place) this.measure.take(place);
    } else if (near) {
      this.onPick(near.pass, near.point);
    }
  };

  private resize(): void {
    const { clientWidth, clientHeight } = this.canvas.parentElement ?? this.canvas;
    if (clientWidth === 0 || clientHeight === 0) return;
    this.renderer.setSize(clientWidth, clientHeight, false);
    this.camera.aspect = clientWidth / clientHeight;
    this.camera.updateProjectionMatrix();
    this.draw();
  }
}
