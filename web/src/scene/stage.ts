// Where the robots stand: renderer, camera, light, floor. A picture is made only when something asks for one.
import {
  DirectionalLight, Group, HemisphereLight, Mesh, PCFShadowMap, PerspectiveCamera, PlaneGeometry, Scene, ShadowMaterial,
  WebGLRenderer, GridHelper, type Material,
} from "three"; // prettier-ignore
import type { Extent } from "./extent";
import type { Palette } from "./palette";

export type Quality = "low" | "high";

/** The quality that suits the machine: low where a program draws instead of a graphics card; null without WebGL. */
export function suitable(): Quality | null {
  const context = document.createElement("canvas").getContext("webgl2");
  if (context === null) return null;
  const info = context.getExtension("WEBGL_debug_renderer_info");
  const name = String(context.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : context.RENDERER));
  context.getExtension("WEBGL_lose_context")?.loseContext();
  return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name) ? "low" : "high";
}

export class Stage {
  readonly canvas = document.createElement("canvas");
  readonly scene = new Scene();
  readonly camera = new PerspectiveCamera(32, 1, 0.01, 100);
  /** Pixels for one of the page while something moves. */
  readonly usual: number;
  private readonly renderer: WebGLRenderer;
  private readonly floor = new Group();
  private readonly light = new DirectionalLight("#ffffff", 2.2);

  constructor(readonly quality: Quality, private readonly extent: Extent) {
    const fine = quality === "high";
    this.renderer = new WebGLRenderer({
      canvas: this.canvas,
      antialias: fine,
      alpha: true,
      powerPreference: "low-power",
    });
    this.usual = fine ? Math.min(window.devicePixelRatio, 2) : 0.75 * Math.min(window.devicePixelRatio, 1);
    this.renderer.setPixelRatio(this.usual);
    this.renderer.shadowMap.enabled = fine;
    this.renderer.shadowMap.type = PCFShadowMap;
    this.camera.up.set(0, 0, 1);
    this.camera.near = 0.01 * extent.reach;
    this.camera.far = 100 * extent.reach;
    this.scene.add(this.floor);
  }

  /** Light and floor in the colours of the page's scheme. */
  dress(colours: Palette): void {
    const { extent, light } = this;
    this.undress();
    const size = extent.cell * 2 * Math.ceil((1.6 * extent.reach) / extent.cell);
    const grid = new GridHelper(size, Math.round(size / extent.cell), colours.gridStrong, colours.grid);
    grid.rotation.x = Math.PI / 2;
    grid.position.z = extent.floor;
    this.floor.add(grid, new HemisphereLight(colours.sky, colours.ground, 1.6), light, light.target);
    const middle = extent.box.getCenter(light.target.position);
    light.position.set(middle.x - 0.6 * extent.reach, middle.y - 1.1 * extent.reach, middle.z + 2.2 * extent.reach);
    if (this.quality === "high") this.shadows(size);
  }

  get floorShown(): boolean {
    return this.floor.children[0]?.visible ?? false;
  }

  set floorShown(shown: boolean) {
    this.floor.children.forEach((child) => {
      if (child instanceof GridHelper || child instanceof Mesh) child.visible = shown;
    });
  }

  resize(width: number, height: number): void {
    if (width < 1 || height < 1) return;
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
  }

  /** `ratio`: pixels for one of the page. */
  draw(ratio = this.usual): void {
    if (this.renderer.getPixelRatio() !== ratio) this.renderer.setPixelRatio(ratio);
    this.renderer.render(this.scene, this.camera);
  }

  dispose(): void {
    this.undress();
    this.light.dispose();
    this.renderer.dispose();
    if (!this.renderer.getContext().isContextLost()) this.renderer.forceContextLoss();
    this.canvas.remove();
  }

  private shadows(size: number): void {
    const { light, extent } = this;
    light.castShadow = true;
    light.shadow.mapSize.set(2048, 2048);
    light.shadow.normalBias = 0.2 * extent.usual;
    const { camera } = light.shadow;
    camera.left = camera.bottom = -1.4 * extent.reach;
    camera.right = camera.top = 1.4 * extent.reach;
    camera.near = 0.1 * extent.reach;
    camera.far = 6 * extent.reach;
    const shade = new Mesh(new PlaneGeometry(size, size), new ShadowMaterial({ opacity: 0.22, depthWrite: false }));
    shade.position.z = extent.floor;
    shade.receiveShadow = true;
    this.floor.add(shade);
  }

  private undress(): void {
    for (const child of [...this.floor.children]) {
      if (child instanceof GridHelper) child.dispose();
      else if (child instanceof Mesh) {
        child.geometry.dispose();
        (child.material as Material).dispose();
      }
    }
    this.floor.clear();
  }
}
