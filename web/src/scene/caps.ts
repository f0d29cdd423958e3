import {
  AlwaysStencilFunc,
  BackSide,
  type Box3,
  DecrementWrapStencilOp,
  DoubleSide,
  FrontSide,
  Group,
  IncrementWrapStencilOp,
  Mesh,
  MeshBasicMaterial,
  NotEqualStencilFunc,
  type Plane,
  PlaneGeometry,
  ReplaceStencilOp,
  type Side,
  type StencilOp,
  Vector3,
} from 'three';

/** Cut faces are so much darker than the surface. */
const DARKER = 0.72;

/** Hatched as in a drawing: lines of 2 in 12 pixels, so much darker again. */
const HATCH = `#include <color_fragment>
  if (mod(gl_FragCoord.x + gl_FragCoord.y, 12.0) < 2.0) diffuseColor.rgb *= 0.6;`;

/** Counts a solid's faces beyond the cut: where it is cut open, more of them look away from the eye than towards it. */
function counts(side: Side, op: StencilOp, cuts: Plane[]): MeshBasicMaterial {
  return new MeshBasicMaterial({
    side,
    clippingPlanes: cuts,
    colorWrite: false,
    depthWrite: false,
    depthTest: false,
    stencilWrite: true,
    stencilFunc: AlwaysStencilFunc,
    stencilFail: op,
    stencilZFail: op,
    stencilZPass: op,
  });
}

/**
 * Closes the solids that the section plane cuts open, by the stencil: a face of each colour lies in the plane and is seen where
 * solids of that colour are cut. Solids have to be closed.
 */
export class Caps {
  /** The faces, in the world. */
  readonly group = new Group();
  private readonly back: MeshBasicMaterial;
  private readonly front: MeshBasicMaterial;
  private readonly faces = new Map<number, { face: Mesh; order: number }>();
  private cut = false;

  constructor(cuts: Plane[]) {
    this.back = counts(BackSide, IncrementWrapStencilOp, cuts);
    this.front = counts(FrontSide, DecrementWrapStencilOp, cuts);
  }

  /** Closes this solid, of this colour. */
  add(solid: Group, surface: Mesh, colour: number): void {
    for (const material of [this.back, this.front]) {
      const mask = new Mesh(surface.geometry, material);
      // Counted and closed colour by colour, after all surfaces.
      mask.renderOrder = this.face(colour).order;
      // Told by the scene's cut, with all else that is cut.
      mask.visible = this.cut;
      mask.userData['mask'] = true;
      mask.raycast = () => undefined;
      solid.add(mask);
    }
  }

  /** Lays the faces into the plane, so large that they reach beyond `box`; none: nothing is cut. */
  set(plane: Plane | null, box: Box3): void {
    this.cut = plane !== null;
    for (const { face } of this.faces.values()) {
      face.visible = this.cut;
      if (!plane) continue;
      plane.projectPoint(box.getCenter(new Vector3()), face.position);
      face.lookAt(face.position.clone().sub(plane.normal));
      face.scale.setScalar(20 * box.getSize(new Vector3()).length() + 10_000);
    }
  }

  end(): void {
    for (const { face } of this.faces.values()) {
      face.geometry.dispose();
      (face.material as MeshBasicMaterial).dispose();
    }
    this.back.dispose();
    this.front.dispose();
  }

  private face(colour: number): { face: Mesh; order: number } {
    let made = this.faces.get(colour);
    if (!made) {
      const material = new MeshBasicMaterial({
        color: colour,
        side: DoubleSide,
        stencilWrite: true,
        stencilRef: 0,
        stencilFunc: NotEqualStencilFunc,
        // Back to nothing for the next colour.
        stencilFail: ReplaceStencilOp,
        stencilZFail: ReplaceStencilOp,
        stencilZPass: ReplaceStencilOp,
        polygonOffset: true,
        polygonOffsetFactor: 2,
        polygonOffsetUnits: 8,
      });
      material.color.multiplyScalar(DARKER);
      material.onBeforeCompile = (shader) => {
        shader.fragmentShader = shader.fragmentShader.replace('#include <color_fragment>', HATCH);
      };
      const order = 1 + 2 * this.faces.size;
      const face = new Mesh(new PlaneGeometry(1, 1), material);
      face.renderOrder = order + 1;
      face.visible = this.cut;
      this.group.add(face);
      made = { face, order };
      this.faces.set(colour, made);
    }
    return made;
  }
}
